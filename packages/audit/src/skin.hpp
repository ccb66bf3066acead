// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_grid.hpp"

#include "abut/mesh/mesh.hpp"
#include "abut/mesh/surface.hpp"

#include <array>
#include <vector>

namespace abut::audit {

/// The outer faces of all bodies on this rank. A piece is what elements that share nodes make up.
struct Skin {
  mesh::Surface surface;
  std::vector<int> block;     ///< (faces)
  std::vector<Local> element; ///< (faces) within the block
  std::vector<double> size;   ///< (faces) square root of the reference area [length]
  std::vector<double> scale;  ///< (faces) that or the depth of the element, if less [length]

  Local faces() const { return surface.num_faces(); }
  fem::FaceType type(Local face) const { return surface.type[std::size_t(face)]; }
  int corners(Local face) const { return fem::face_corners(type(face)); }
  /// Mesh node on this rank of a node of a face.
  Local node(Local face, int a) const {
    const Local first = surface.offset[std::size_t(face)];
    return surface.field_index[std::size_t(surface.nodes[std::size_t(first + a)])];
  }
};

/// Collective.
Skin make_skin(const mesh::Mesh& mesh);

/// Where nodes are and where they were when the step began, and what their faces make of it.
struct Pose {
  std::vector<Vec3> x, before; ///< (N) [length]
  std::vector<Vec3> normal;    ///< (N) unit mean of the skin's normals; zero inside
  std::vector<double> rise;    ///< (faces) see Facets
};

/// Nodes of a face at positions x (N).
void face_nodes_at(const Skin& skin, Local face, const std::vector<Vec3>& x, Vec3* y);

/// Unit normals of a face in its corners, out of the body.
std::array<Vec3, 4> corner_normals(fem::FaceType type, const Vec3* y);

/// Sum over the faces at each node of their unit normals there, made a unit vector. Collective.
std::vector<Vec3> nodal_normals(const Skin& skin, const NodeExchange& exchange,
                                const std::vector<Vec3>& x);

} // namespace abut::audit
