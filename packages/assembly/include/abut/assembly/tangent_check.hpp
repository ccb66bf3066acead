// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <string>
#include <vector>

namespace abut::assembly {

class EquationSystem;

/// How far the tangent of one contribution is from the slope of its residual.
struct TangentMismatch {
  std::string part;
  double error = 0.0; ///< |K d - slope| / |slope| in the L2 norm [1]
  double force = 0.0; ///< |slope|: zero when the contribution does not act [force/length]
  Global node = -1;   ///< id of the node of the worst row; -1: there is no error at all
  int field = 0;      ///< its component
};

/// Each contribution's tangent where the residual was last asked, along a random direction of all
/// unknowns, against central differences of its residual over +- step [length]. Rows of free
/// rigid bodies are left out: their arm stiffness belongs to no contribution. Collective.
std::vector<TangentMismatch> check_tangent(EquationSystem& equations, double step);

} // namespace abut::assembly
