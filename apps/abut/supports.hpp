// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include <string>
#include <vector>

namespace abut::app {

/// A connected deformable piece or a rigid body that nothing holds in some rigid motion.
struct FreePiece {
  std::string body;
  std::vector<std::string> motions; ///< e.g. "translation along z"
};

/// Pieces that neither prescribed displacements, rigid bodies that they share nodes with nor
/// contact that is closed at the start hold; and rigid bodies with unknowns in the same way. Loads
/// hold nothing. The equations must have been prepared at the start. Collective.
std::vector<FreePiece> free_pieces(const Model& model);

/// Throws InputError naming the free pieces, their motions and what would hold them. Collective.
void require_supports(const Model& model);

} // namespace abut::app
