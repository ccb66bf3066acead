// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/mesh/surface.hpp"

namespace abut::contact {

/// How the side that carries points and multipliers compares with the other. A multiplier needs a
/// node that can follow it: on a stiff primary whose faces are smaller than those of a soft
/// secondary several multipliers press on one soft face, and only their sum means anything.
/// docs/theory/multipliers.md
struct SideComparison {
  double stiffness = 1.0; ///< modulus of the primary over that of the secondary; inf: rigid primary
  double size = 1.0;      ///< faces of the primary over those of the secondary
  double softest = 0.0;   ///< smallest modulus of both sides; 0: both are rigid [pressure]
  double face_size = 0.0; ///< mean over both sides [length]

  bool prefers_swap() const { return stiffness > 1.5; }
  /// Compliance that a multiplier finds, as a fraction of what it needs: 1 or more is healthy. In
  /// two-body studies pressures were off by 7 % at .5, by 18 to 30 % at .01.
  double health() const { return size / stiffness; }
  bool is_poor() const { return stiffness > 1.5 && size < 0.8; }
  /// Dual tractions alternate in sign within a face. Where only the secondary yields they dent it
  /// between its nodes, and a deep dent leaves Newton without an end.
  bool suits_dual() const { return !is_poor() && stiffness <= 10.0; }
};

/// Means over the faces by area; modulus 0 is rigid. Collective.
SideComparison compare_sides(const Comm& comm, const mesh::Surface& primary,
                             const mesh::Surface& secondary);

} // namespace abut::contact
