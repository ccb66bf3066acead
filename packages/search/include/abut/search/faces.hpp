// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/views.hpp"
#include "abut/fem/face_shape.hpp"
#include "abut/search/box.hpp"

namespace abut::search {

/// Faces as kernels read them, in CRS form. Copied by value; the arrays are shared.
struct Faces {
  View<const fem::FaceType> type;
  View<const Local> offset; ///< (faces+1) into node
  View<const Local> node;   ///< number of each node of each face
  View<const Vec3> x;       ///< (nodes) coordinates [length]

  KOKKOS_INLINE_FUNCTION Local size() const { return static_cast<Local>(type.extent(0)); }
  /// Coordinates of a face's nodes: at most fem::max_face_nodes.
  KOKKOS_INLINE_FUNCTION void coordinates(Local face, Vec3* y) const {
    for (Local k = offset(face); k < offset(face + 1); ++k)
      y[k - offset(face)] = x(node(k));
  }
};

/// How far a face may leave the box of its nodes, in lengths of that box: the largest sum of the
/// negative parts of its shape functions, which quadratic ones have at the middle.
constexpr double bulge(fem::FaceType type) {
  return type == fem::FaceType::quad8   ? 1.0
         : type == fem::FaceType::quad9 ? 9.0 / 32.0
         : type == fem::FaceType::tri6  ? 1.0 / 3.0
                                        : 0.0;
}

/// A box that holds the whole of a curved face with nodes y.
KOKKOS_INLINE_FUNCTION Box<3> face_box(fem::FaceType type, const Vec3* y) {
  Box<3> box = Box<3>::empty();
  for (int a = 0; a < fem::face_nodes(type); ++a)
    box.add(y[a].v);
  for (int i = 0; i < 3; ++i) {
    const double margin = bulge(type) * (box.high[i] - box.low[i]);
    box.low[i] -= margin;
    box.high[i] += margin;
  }
  return box;
}

/// Length of a box's diagonal.
KOKKOS_INLINE_FUNCTION double diagonal(const Box<3>& box) {
  double s = 0.0;
  for (int i = 0; i < 3; ++i)
    s += (box.high[i] - box.low[i]) * (box.high[i] - box.low[i]);
  return std::sqrt(s);
}

} // namespace abut::search
