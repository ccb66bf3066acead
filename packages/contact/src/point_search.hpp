// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"

namespace abut::contact {

/// What a point looks for: its closest point, or where a line meets the secondary surface.
struct Interaction::Query {
  Local face = -1; ///< primary face of the point
  Vec3 x, normal;  ///< of the primary at the point
  Vec3 x_previous; ///< at the last converged step
  bool line = false;
  Vec3 origin, direction; ///< of the line
  double reach = 0.0;     ///< of the point; a large secondary face may reach further [length]
  Local last = -1;        ///< partner of the last search, -1: none
  double last_xi[2] = {0.0, 0.0};
  double hold = 0.0; ///< margin within which the last partner is kept; 0: it is not
};

struct Interaction::Partner {
  Local face = -1;
  double distance = 0.0, gap = 0.0, xi[2] = {0.0, 0.0};
};

} // namespace abut::contact
