// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/face_kernel.hpp"

#include <type_traits>

/// Loads on cells, of which their values at points or nodes are known.
namespace abut::solid {

constexpr int max_face_points = 9;

/// Forces that do not depend on the displacement.
struct DeadForce {
  CellArrays cells;
  View<const Vec3> force; ///< (entries) external force
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    double r[3 * fem::max_cell_nodes];
    const Local first = cells.first(c);
    for (int a = 0; a < cells.nodes(c); ++a)
      for (int i = 0; i < 3; ++i)
        r[3 * a + i] = -force(first + a)[i];
    scatter.add(c, r, 3);
  }
};

/// Faces under a load per current area: a pressure (Load double) or a traction (Vec3). Copied by
/// value; the arrays are shared.
template <class Load> struct LoadedFaces {
  static constexpr bool is_pressure = std::is_same_v<Load, double>;

  CellArrays cells;
  View<const fem::FaceType> type;    ///< (cells)
  View<const ReferenceFaces> tables; ///< one
  View<const Load> load;             ///< (cells, max_face_points)

  KOKKOS_INLINE_FUNCTION const Load* at_points(Local c) const { return &load(c * max_face_points); }
};

template <class Load> struct FaceResidual {
  LoadedFaces<Load> faces;
  NodalFields fields;
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    Vec3 x[fem::max_face_nodes], r[fem::max_face_nodes];
    faces.cells.positions(c, fields, x);
    fem::dispatch_face(faces.type(c), [&](auto shape) {
      const ReferenceFace<decltype(shape)::type>& face = faces.tables(0);
      if constexpr (LoadedFaces<Load>::is_pressure)
        pressure_residual(face, faces.at_points(c), x, r);
      else
        traction_residual(face, faces.at_points(c), x, r);
    });
    scatter.add(c, reinterpret_cast<const double*>(r), 3);
  }
};

template <class Load> struct FaceTangent {
  LoadedFaces<Load> faces;
  NodalFields fields;
  TangentScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    Vec3 x[fem::max_face_nodes];
    double k[9 * fem::max_face_nodes * fem::max_face_nodes];
    faces.cells.positions(c, fields, x);
    fem::dispatch_face(faces.type(c), [&](auto shape) {
      const ReferenceFace<decltype(shape)::type>& face = faces.tables(0);
      if constexpr (LoadedFaces<Load>::is_pressure)
        pressure_tangent(face, faces.at_points(c), x, k);
      else
        traction_tangent(face, faces.at_points(c), x, k);
    });
    scatter.add(c, k, 3);
  }
};

} // namespace abut::solid
