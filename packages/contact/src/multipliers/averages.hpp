// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multipliers/plateau.hpp"
#include "multipliers/sites.hpp"

namespace abut::contact {

/// Multipliers of a site: pressure and shear, tangent and on the primary [pressure].
struct Multiplier {
  double pressure = 0.0;
  Vec3 shear = {{0.0, 0.0, 0.0}};
};

/// Smoothed multipliers: averages of the tractions at the corners, read back by the points. The
/// pressures stay apart from them by what the springs carry, as little as an average differs from
/// the pressure itself.
/// increments: multipliers grow by averages of what springs carry. Violations at the corners go to
/// `watch` and to result.gap and length, of this rank. Collective.
std::vector<Multiplier> averaged_multipliers(const InterfaceData& data, bool increments,
                                             PlateauWatch& watch, Augmentation& result);

} // namespace abut::contact
