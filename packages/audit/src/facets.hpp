// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "skin.hpp"

#include <optional>
#include <vector>

namespace abut::audit {

/// Which faces of the skin lie beside each other, on any rank.
class Facets {
public:
  /// Collective.
  Facets(const mesh::Mesh& mesh, const Skin& skin);

  /// How far the round surface that faces stand for rises over each of them at node positions x
  /// (N): the height of an arc over the face that meets both faces at an edge at the same angle. An
  /// angle of more than 60 degrees is an edge of the body, and no roundness. (faces) Collective.
  std::vector<double> rises(const Skin& skin, const std::vector<Vec3>& x) const;

  /// (faces,4) whether an edge, from each corner to the next, is one of the body: no other face is
  /// there, or one at more than 30 degrees. Collective.
  std::vector<char> creases(const Skin& skin, const std::vector<Vec3>& x) const;

private:
  std::vector<Vec3> normals(const Skin& skin, const std::vector<Vec3>& x) const;

  const mesh::Mesh& mesh_;
  /// (faces,4) the same edge of another face: an index of this kind, or beyond them a row that
  /// comes from another rank; -1: none
  std::vector<Local> beside_;
  std::optional<NeighbourMessages> messages_; ///< of those rows
  Local rows_ = 0;
};

} // namespace abut::audit
