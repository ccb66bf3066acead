// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/scene.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A connected deformable piece or a rigid body that nothing holds in some rigid motion.
struct FreePiece {
  std::string body;
  /// E.g. "translation along z", "rotation about x through (0, 0, 1)". Of motions that pieces can
  /// only make together, those of one of them.
  std::vector<std::string> motions;

  std::string text() const; ///< the motions, separated by commas
};

/// When and where supports are looked at.
struct SupportedAt {
  double t;                               ///< an end of a step: what then holds counts
  const std::vector<double>* u = nullptr; ///< (N, 3) displacements of nodes; null: none
  bool contact = true;                    ///< whether it counts
};

/// Pieces that neither prescribed displacements, rigid bodies that they share nodes with nor
/// contact that is closed at the start hold; and rigid bodies with unknowns in the same way. Loads
/// hold nothing. The equations must have been prepared at the start. Collective.
std::vector<FreePiece> free_pieces(const Options& options, const Scene& scene);

/// The same in the last evaluated configuration; nothing where there are joints, which are known
/// in the reference configuration alone. Collective.
std::vector<FreePiece> free_pieces(const Options& options, const Scene& scene,
                                   const SupportedAt& at);

/// Where something is free that the points nearest to other surfaces would hold, they do from now on,
/// until there is contact (Interaction::hold_by_nearest); what is so held is among the warnings.
/// Throws InputError naming the pieces that are free all the same, their motions and what would hold
/// them. x: the start, at which the equations have been prepared and are again. Collective.
void require_supports(const Options& options, Scene& scene, const Vector& x, const Where& where);

} // namespace abut::scene
