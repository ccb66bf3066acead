// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/equation_system.hpp"

namespace abut::assembly {

/// A contribution and where its cells go in the present pattern.
struct EquationSystem::Part {
  std::shared_ptr<Contribution> contribution;
  CellPositions positions;
  long connectivity_version = -1;
  long pattern_version = -1;
};

} // namespace abut::assembly
