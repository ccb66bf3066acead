// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/surface.hpp"
#include "abut/search/bvh.hpp"
#include "abut/search/faces.hpp"

#include <vector>

namespace abut::search {

/// How thick bodies are behind their faces, in the reference configuration. A body is what elements
/// that share nodes make up.
class BodyThickness {
public:
  /// The mesh must outlive the object. Collective.
  explicit BodyThickness(const mesh::Mesh& mesh);

  /// (faces) The way of the line that enters the body at the middle of each face, against its
  /// normal, until it leaves the same body; infinite where it does not. faces: of the same mesh.
  /// Collective. [length]
  std::vector<double> behind(const mesh::Surface& faces) const;

private:
  struct Ray;
  double leaves_after(const Ray& ray) const;

  const mesh::Mesh& mesh_;
  std::vector<Global> body_; ///< (mesh nodes)
  mesh::Surface skin_;
  Faces faces_; ///< of the skin
  Bvh<3> tree_;
  std::vector<Box<3>> rank_boxes_; ///< (ranks) around the skin that each one has
};

} // namespace abut::search
