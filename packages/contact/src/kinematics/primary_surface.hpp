// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/primary_point.hpp"
#include "abut/core/views.hpp"
#include "abut/mesh/surface.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace abut::contact {

/// What kernels read of the primary surface: faces (I), their nodes, and the points of all faces
/// (I,P), one after the other. Copied by value; the arrays are shared.
struct PrimaryView {
  View<fem::FaceType> type;   ///< (I)
  View<Local> first_node;     ///< (I+1) into x, x_previous and node
  View<Local> first_point;    ///< (I+1)
  View<Local> first_table;    ///< (I) into the tables of shape functions, of the face's first point
  View<double> size;          ///< (I) square root of the reference area [length]
  View<double> modulus;       ///< (I) of the body behind it; 0: rigid [pressure]
  View<double> inverse_depth; ///< (I) A/V of the element behind it [1/length]
  View<double> thickness;     ///< (I) of the body behind it, see mesh::Surface [length]
  View<double> stretch;       ///< (I) current over reference area that the penalty knows of [1]
  View<Local> node;           ///< (face nodes) surface nodes
  View<Global> global_node;   ///< (face nodes) mesh nodes
  View<Vec3> x, x_previous;   ///< (face nodes) now, and at the last converged step [length]
  View<Vec3> x_reference;     ///< (face nodes) [length]
  View<Local> face;           ///< (I,P) of each point
  View<double> weight;        ///< (I,P) of the quadrature [1]
  View<double> area;          ///< (I,P) weight times reference area [length^2]
  View<double> table_N;       ///< (table points, max_face_nodes)
  View<double> table_dN;      ///< (table points, max_face_nodes, 2)
  View<double> table_xi;      ///< (table points, 2)

  KOKKOS_INLINE_FUNCTION Local faces() const { return static_cast<Local>(type.extent(0)); }
  KOKKOS_INLINE_FUNCTION Local points() const { return static_cast<Local>(face.extent(0)); }
  KOKKOS_INLINE_FUNCTION int nodes(Local f) const { return first_node(f + 1) - first_node(f); }
  KOKKOS_INLINE_FUNCTION const Vec3* now(Local f) const { return &x(first_node(f)); }
  KOKKOS_INLINE_FUNCTION const Vec3* before(Local f) const { return &x_previous(first_node(f)); }
  KOKKOS_INLINE_FUNCTION const Vec3* at_rest(Local f) const { return &x_reference(first_node(f)); }
  KOKKOS_INLINE_FUNCTION Local table(Local point) const {
    return first_table(face(point)) + point - first_point(face(point));
  }
  /// Place of the point in its face's parameter plane.
  KOKKOS_INLINE_FUNCTION const double* xi(Local point) const { return &table_xi(2 * table(point)); }
  KOKKOS_INLINE_FUNCTION PointShape shape(Local point) const {
    const Local t = table(point) * fem::max_face_nodes;
    return {nodes(face(point)), &table_N(t),
            reinterpret_cast<const double(*)[2]>(&table_dN(2 * t))};
  }
  KOKKOS_INLINE_FUNCTION PrimaryPoint<double> at(Local point) const {
    return primary_point(shape(point), now(face(point)));
  }
  /// Area that the point stands for in the present configuration [length^2].
  KOKKOS_INLINE_FUNCTION double current_area(Local point) const {
    return weight(point) * at(point).area;
  }
};

/// The surface that carries the integration points.
class PrimarySurface {
public:
  /// surface: reference coordinates, which are moved by -origin. points: per direction; nodal: the
  /// points are the nodes.
  PrimarySurface(mesh::Surface surface, const Vec3& origin, std::optional<int> points, bool nodal);

  const mesh::Surface& surface() const { return surface_; }
  const PrimaryView& view() const { return view_; }

  /// Takes the positions of the nodes: u (nodal fields) with `fields` values per node.
  void move(const double* u, int fields);
  /// The present positions become those of the last converged step.
  void accept();
  /// Calls `work` with the positions of the last converged step as the present ones.
  template <class Work> void at_last_step(const Work& work) {
    const View<Vec3> now = view_.x;
    view_.x = view_.x_previous;
    work();
    view_.x = now;
  }
  /// Takes the present area of each face into its stretch.
  void update_stretch();
  void reset_stretch();

private:
  void make_points(std::optional<int> points, bool nodal);

  mesh::Surface surface_;
  PrimaryView view_;
};

/// Size of each face: square root of its area in the coordinates x (surface nodes, 3).
std::vector<double> face_sizes(const mesh::Surface& surface);

} // namespace abut::contact
