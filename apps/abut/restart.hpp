// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/core/state_archive.hpp"
#include "abut/solver/standing.hpp"

#include <functional>
#include <optional>
#include <string>

namespace abut::app {

/// All owners of state of a run, one after the other: each gives its own or takes it. Collective.
using ExchangeState = std::function<void(StateArchive&, solver::Standing&)>;

/// A checkpoint that a run goes on from.
class Restart {
public:
  /// Throws InputError, naming the file, for one that cannot be read, is damaged, of another
  /// program, another model or mesh, or at the end of the run already. Collective.
  Restart(const Model& model, const std::string& file);

  int part() const { return part_; } ///< of the results, that begins now
  /// The owners take their state; returns where the steps stand. Collective.
  solver::Standing take(const ExchangeState& exchange);

private:
  std::string file_;
  int part_ = 2;
  std::optional<StateArchive> archive_;
};

} // namespace abut::app
