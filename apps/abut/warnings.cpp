// SPDX-License-Identifier: BSD-3-Clause
#include "warnings.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace abut::app {

namespace {

constexpr double deep = 0.5;       ///< in sizes of the face
constexpr double too_soft = 0.02;  ///< of the force
constexpr double main_share = 0.2; ///< of the largest error, which makes an interface worth naming

} // namespace

std::vector<std::string> warnings_of_start(const Model& m) {
  std::vector<std::string> result;
  for (const auto& c : m.contacts) {
    const contact::Settings& settings = c->settings();
    // A surface that may touch itself later has no partner, and sees its own back.
    if (!c->acts() || settings.primary == settings.secondary)
      continue;
    const contact::ContactSummary s = c->summary();
    const std::string path = std::string("contact.") + c->name() + ": ";
    if (s.paired_points == 0)
      result.push_back(path + fmt::format("at the start no point of '{}' has a partner on '{}' "
                                          "within {:g} face sizes: are they far apart, or do they "
                                          "face the wrong way?",
                                          settings.primary, settings.secondary, settings.reach));
    const double wrong = c->wrong_facing_share();
    if (wrong > 0.0)
      result.push_back(path + fmt::format("{:.0f}% of the points of '{}' near '{}' see its back: "
                                          "check which way the faces point",
                                          100.0 * wrong, settings.primary, settings.secondary));
    if (settings.fits && s.paired_points > 0 && s.shifted_points == 0)
      result.push_back(path +
                       fmt::format("the interference acts nowhere: no point of '{}' is within "
                                   "{:.4g} of '{}' at the start; give 'fit_within'",
                                   settings.primary, settings.fit_within, settings.secondary));
    if (s.max_penetration_over_face_size > deep)
      result.push_back(path +
                       fmt::format("'{}' and '{}' overlap at the start by up to {:.4g}, {:.2g} "
                                   "of a face: is that meant?",
                                   settings.primary, settings.secondary, s.max_penetration,
                                   s.max_penetration_over_face_size));
  }
  return result;
}

std::vector<std::string> shifts_of_start(const Model& m) {
  std::vector<std::string> result;
  for (const auto& c : m.contacts) {
    const contact::Settings& settings = c->settings();
    if (!c->acts())
      continue;
    const contact::ContactSummary s = c->summary();
    const bool is_asked_for = settings.fits || settings.initial_gap == contact::InitialGap::close;
    if (is_asked_for || s.shifted_points > 0)
      result.push_back(
          fmt::format("contact.{}: gaps of {} of {} points are shifted at the start, by "
                      "up to {:.4g}",
                      c->name(), s.shifted_points, s.points, s.max_shift));
  }
  return result;
}

void ContactWatch::look(const scene::State& state) {
  ++looks_;
  seen_.resize(state.contacts.size());
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const contact::ContactSummary& now = state.contacts[i];
    seen_[i].touched = seen_[i].touched || now.active_points > 0;
    seen_[i].deepest = std::max(seen_[i].deepest, now.max_penetration_over_face_size);
  }
}

std::vector<std::string> ContactWatch::warnings(const Model& m, bool converged) const {
  const bool has_steps = looks_ > 1; // beside the start
  std::vector<std::string> result;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const contact::Settings& settings = m.contacts[i]->settings();
    const std::string path = std::string("contact.") + m.contacts[i]->name() + ": ";
    if (!seen_[i].touched && has_steps && settings.window.from < m.deck.time.end)
      result.push_back(path + fmt::format("'{}' and '{}' {}", settings.primary, settings.secondary,
                                          converged ? "never touched in the whole run"
                                                    : "had not touched when the run stopped"));
    if (seen_[i].deepest > deep)
      result.push_back(path + fmt::format("points of '{}' sank into '{}' by up to {:.2g} of their "
                                          "face: a larger penalty or multipliers, a finer mesh, or "
                                          "do the surfaces meet through a body?",
                                          settings.primary, settings.secondary, seen_[i].deepest));
  }
  return result;
}

std::vector<std::string> warnings_of_penalty(const Model& m, const scene::PenaltyError& error) {
  if (!(error.whole > too_soft))
    return {};
  const double largest = *std::max_element(error.contacts.begin(), error.contacts.end());
  std::string names;
  bool by_penalty = false;
  for (std::size_t i = 0; i < error.contacts.size(); ++i)
    if (error.contacts[i] >= main_share * largest) {
      names += (names.empty() ? "contact." : ", contact.") + std::string(m.contacts[i]->name());
      by_penalty = by_penalty || !m.contacts[i]->settings().augmented();
    }
  return {fmt::format(
      "{}: surfaces sink into each other so far that forces under given displacements, or "
      "displacements under given forces, are off by about {:.1f} %: {}",
      names, 100.0 * error.whole,
      by_penalty ? "take 'enforcement: augmented_lagrangian' or a larger penalty_factor"
                 : "ask for more augmentations (gap_tolerance, min_augmentations) or take a larger "
                   "penalty_factor")};
}

} // namespace abut::app
