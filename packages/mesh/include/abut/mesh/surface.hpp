// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"

#include <limits>
#include <string>
#include <vector>

namespace abut::mesh {

/// The faces of a named surface that one rank owns, with all their nodes. A host code with a mesh
/// of its own fills it by hand; extract_surface fills it from a side set.
struct Surface {
  std::string name;
  int dim = 3;
  std::vector<fem::FaceType> type; ///< (faces)
  std::vector<Global>
      face_id; ///< (faces) unique over ranks, the same on any number of ranks; ascending
  std::vector<Local> offset{0};   ///< (faces+1) into nodes
  std::vector<Local> nodes;       ///< surface nodes of each face; the normal points out of the body
  std::vector<Global> node;       ///< (surface nodes) global mesh node number
  std::vector<Local> field_index; ///< (surface nodes) row of the node in the host's nodal fields
  std::vector<double> x;          ///< (surface nodes, dim) reference coordinates [length]
  std::vector<double> modulus;    ///< (faces) E_n of the body along the normal [pressure]; 0: rigid
  std::vector<double> inverse_depth; ///< (faces) A/V of the element behind the face [1/length]
  std::vector<double>
      thickness; ///< (faces) of the body behind the face, see search::BodyThickness;
                 ///< empty: not known, as thick as may be [length]

  Local num_faces() const { return static_cast<Local>(type.size()); }
  Local num_nodes() const { return static_cast<Local>(node.size()); }
  double thickness_behind(Local face) const {
    return thickness.empty() ? std::numeric_limits<double>::infinity()
                             : thickness[std::size_t(face)];
  }
};

/// The sides of a side set on this rank in the order of their face ids.
std::vector<Side> sorted_sides(const Mesh& mesh, const std::string& side_set);

/// The faces of a side set on this rank, in the order of sorted_sides. modulus and inverse_depth
/// are left zero. The name must be one of the mesh's side sets.
Surface extract_surface(const Mesh& mesh, const std::string& side_set);

/// The faces on this rank that belong to one element alone, over all ranks: the skin of all bodies.
/// Collective.
Surface outer_surface(const Mesh& mesh);

} // namespace abut::mesh
