// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/scene.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A connected deformable piece or a rigid body that nothing holds in some rigid motion.
struct FreePiece {
  std::string body;
  std::vector<std::string> motions; ///< e.g. "translation along z"
};

/// Pieces that neither prescribed displacements, rigid bodies that they share nodes with nor
/// contact that is closed at the start hold; and rigid bodies with unknowns in the same way. Loads
/// hold nothing. The equations must have been prepared at the start. Collective.
std::vector<FreePiece> free_pieces(const Options& options, const Scene& scene);

/// Throws InputError naming the free pieces, their motions and what would hold them. Collective.
void require_supports(const Options& options, const Scene& scene, const Where& where);

} // namespace abut::scene
