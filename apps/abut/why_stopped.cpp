// SPDX-License-Identifier: BSD-3-Clause
#include "why_stopped.hpp"

#include "abut/scene/supports.hpp"
#include "abut/scene/windows.hpp"

#include <fmt/format.h>

namespace abut::app {

namespace {

std::string limit(const Model& m, long long cuts) {
  const solver::TimeOptions& time = m.deck.time;
  if (!time.adaptive)
    return "\nThe step is not cut because of 'time: {adaptive: false}'";
  if (cuts >= time.max_cuts)
    return fmt::format("\nIt is cut no further because of time.max_cuts, which is {}",
                       time.max_cuts);
  return fmt::format("\nIt is cut no further because of time.min_fraction, which is {:g}",
                     time.min_fraction);
}

std::string changes(const Model& m, double t) {
  std::string list;
  for (const std::string& path : scene::windows_at(m.deck, t))
    list += (list.empty() ? "" : ", ") + path;
  return list.empty() ? ""
                      : "\nThere begins or ends: " + list +
                            ". What is let go must be held by something else, or balance itself";
}

/// What is free in the step after t; else what contact alone holds, and may have let go of.
std::string free_motions(const Model& m, const scene::State& state) {
  if (m.deck.dynamics.active)
    return "";
  const double next = state.time + m.deck.time.min_fraction * m.deck.time.end / m.deck.time.steps;
  std::string text;
  const auto add = [&](bool contact, const char* before, const char* after) {
    for (const scene::FreePiece& piece : scene::free_pieces(m.deck, m, {next, &state.u, contact}))
      text += before + piece.body + after + piece.text();
  };
  add(true, "\nBody '", "' is free to move: ");
  if (text.empty())
    add(false, "\nNothing but contact holds body '", "' against: ");
  return text;
}

} // namespace

std::string why_stopped(const Model& m, const Recorder& recorder,
                        const solver::LoadResult& result) {
  const long long cuts = result.counters.cut_backs - recorder.counters().cut_backs;
  return limit(m, cuts) + changes(m, result.t) + free_motions(m, recorder.state());
}

} // namespace abut::app
