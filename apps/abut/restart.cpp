// SPDX-License-Identifier: BSD-3-Clause
#include "restart.hpp"

#include "abut/core/error.hpp"
#include "abut/io/checkpoint_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <vector>

namespace abut::app {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? "nothing" : "'" + line.substr(first) + "'";
}

/// Where two models part, in words.
std::string first_difference(const std::string& there, const std::string& here) {
  const std::vector<std::string> a = lines_of(there), b = lines_of(here);
  std::string section;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const std::string x = i < a.size() ? a[i] : "", y = i < b.size() ? b[i] : "";
    if (x != y)
      return fmt::format("{}it has {} where this deck has {}",
                         section.empty() || y[0] != ' ' ? "" : "in " + section + ", ", trimmed(x),
                         trimmed(y));
    if (!x.empty() && x[0] != ' ')
      section = "'" + x.substr(0, x.find(':')) + "'";
  }
  return "it is another one";
}

void require_same(const Model& model, const io::Checkpoint& c) {
  if (c.program != ABUT_VERSION)
    throw InputError("it was written by abut " + c.program + ", this is abut " ABUT_VERSION);
  const std::string here = deck::model_yaml(model.deck);
  if (c.model != here)
    throw InputError("it is of another model (" + c.deck + "): " + first_difference(c.model, here));
  if (c.mesh != model.mesh_fingerprint)
    throw InputError("it is of another mesh: coordinates, elements or sets differ");
  if (!(c.t < model.deck.time.end))
    throw InputError(
        fmt::format("it is at t = {:g}, and the run ends at time.end = {:g}: nothing is "
                    "left to do but with a larger end",
                    c.t, model.deck.time.end));
}

} // namespace

Restart::Restart(const Model& model, const std::string& file) : file_(file) {
  std::vector<StateArchive::Array> arrays;
  model.comm.on_root([&] {
    io::Checkpoint checkpoint = io::read_checkpoint(file);
    try {
      require_same(model, checkpoint);
    } catch (const InputError& e) {
      throw InputError("checkpoint '" + file + "': " + e.what());
    }
    part_ = checkpoint.part + 1;
    arrays = std::move(checkpoint.arrays);
  });
  model.comm.broadcast(&part_, sizeof part_);
  archive_.emplace(model.comm, std::move(arrays));
}

solver::Standing Restart::take(const ExchangeState& exchange) {
  solver::Standing standing;
  try {
    exchange(*archive_, standing);
  } catch (const InputError& e) {
    throw InputError("checkpoint '" + file_ + "': " + e.what());
  }
  archive_.reset();
  return standing;
}

} // namespace abut::app
