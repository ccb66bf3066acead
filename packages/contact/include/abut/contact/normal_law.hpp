// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace abut::contact {

/// Pressure of a point and its resistance to opening at the present gap.
struct NormalResponse {
  double pressure = 0.0;  ///< > 0 pushes the bodies apart, < 0 holds them together [pressure]
  double stiffness = 0.0; ///< - d pressure / d gap [pressure/length]
};

/// A law of the normal traction beside Signorini's: what a point carries at a gap (offset taken
/// off, > 0 open) with the interface's penalty. A point without pressure and stiffness is open. The
/// law must be a function of its arguments alone. Friction acts where it presses with the penalty
/// itself as stiffness, because the tangential springs are those of the penalty.
using NormalLaw = std::function<NormalResponse(double gap, double penalty)>;

} // namespace abut::contact
