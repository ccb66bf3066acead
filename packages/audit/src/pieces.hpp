// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "skin.hpp"

#include <map>
#include <vector>

namespace abut::audit {

constexpr int deforms = -1; ///< frame of what is fixed to none

/// What one rank has of one piece in the present configuration.
struct PiecePart {
  Global piece;
  int rank;
  int frame;       ///< of all its nodes; else `deforms`
  Box all;         ///< around its elements
  Box skin;        ///< around its faces
  Box swept;       ///< around its faces now and when the step began
  Box way;         ///< of the displacements of its faces' nodes since then
  double shortest; ///< edge of its faces in the reference configuration [length]
};

/// Connected pieces of the mesh, whatever their bodies.
class Pieces {
public:
  /// frame_of_node: see Bodies. Collective.
  Pieces(const mesh::Mesh& mesh, const Skin& skin, const std::vector<int>& frame_of_node);

  const std::vector<Global>& of_nodes() const { return of_node_; } ///< (N)
  Global of_node(Local n) const { return of_node_[std::size_t(n)]; }
  Global of_face(const Skin& skin, Local face) const { return of_node(skin.node(face, 0)); }
  int frame(Global piece) const { return frame_.at(piece); } ///< of a piece with nodes here

  /// Every rank's parts at the pose. Collective.
  std::vector<PiecePart> parts(const Skin& skin, const Pose& pose) const;

  /// Whether one may be found in the other at all.
  static bool may_meet(Global a, int frame_a, Global b, int frame_b) {
    return a == b ? frame_a == deforms : frame_a == deforms || frame_a != frame_b;
  }

private:
  const mesh::Mesh& mesh_;
  std::vector<Global> of_node_;       ///< (N)
  std::map<Global, int> frame_;       ///< of pieces with nodes here
  std::map<Global, double> shortest_; ///< of pieces with faces here
  bool quadratic_ = false;
};

} // namespace abut::audit
