// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/views.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/search/bvh.hpp"

#include <vector>

namespace abut::contact {

/// What kernels read of the secondary faces that are here. Copied by value; the arrays are shared.
struct FacingView {
  View<fem::FaceType> face_type;
  View<Global> face_id;            ///< ascending: the order does not depend on the partition
  View<Local> offset;              ///< (faces+1) into face_node
  View<Local> face_node;           ///< nodes here
  View<Global> node;               ///< mesh node of each node here
  View<Vec3> x, x_previous;        ///< (nodes) now, and at the last converged step [length]
  View<double> face_size;          ///< reference [length]
  View<double> face_modulus;       ///< 0: rigid [pressure]
  View<Vec3> x_reference;          ///< (nodes) [length]
  View<double> face_inverse_depth; ///< [1/length]
  View<double> face_thickness;     ///< of the body behind it, see mesh::Surface [length]
  View<double> face_rise;          ///< (faces,2) facet_rises [length]
  double largest_size = 0.0;       ///< of all faces here [length]
  search::Tree<3> tree;            ///< over the faces' boxes

  KOKKOS_INLINE_FUNCTION Local faces() const { return static_cast<Local>(face_type.extent(0)); }
  KOKKOS_INLINE_FUNCTION fem::FaceType type(Local face) const { return face_type(face); }
  KOKKOS_INLINE_FUNCTION int nodes(Local face) const { return offset(face + 1) - offset(face); }
  KOKKOS_INLINE_FUNCTION double size(Local face) const { return face_size(face); }
  KOKKOS_INLINE_FUNCTION double inverse_depth(Local face) const { return face_inverse_depth(face); }
  KOKKOS_INLINE_FUNCTION double thickness(Local face) const { return face_thickness(face); }
  /// Coordinates of a face's nodes: current, at the last converged step, in the reference.
  KOKKOS_INLINE_FUNCTION void coordinates(Local face, Vec3* y) const { gather(x, face, y); }
  KOKKOS_INLINE_FUNCTION void previous_coordinates(Local face, Vec3* y) const {
    gather(x_previous, face, y);
  }
  KOKKOS_INLINE_FUNCTION void reference_coordinates(Local face, Vec3* y) const {
    gather(x_reference, face, y);
  }
  KOKKOS_INLINE_FUNCTION Global mesh_node(Local face, int a) const {
    return node(face_node(offset(face) + a));
  }
  KOKKOS_INLINE_FUNCTION bool has_node(Local face, Global mesh_node_number) const {
    for (int a = 0; a < nodes(face); ++a)
      if (mesh_node(face, a) == mesh_node_number)
        return true;
    return false;
  }
  /// The face of this id, -1 when it is not among those here.
  KOKKOS_INLINE_FUNCTION Local find(Global id) const {
    Local low = 0, high = faces();
    while (low < high) {
      const Local middle = low + (high - low) / 2;
      if (face_id(middle) < id)
        low = middle + 1;
      else
        high = middle;
    }
    return low < faces() && face_id(low) == id ? low : -1;
  }
  /// Which of two faces a point above their common edge belongs to: by the place of their centers
  /// along x, y, z. It depends neither on the numbering nor on the number of ranks.
  KOKKOS_INLINE_FUNCTION bool goes_before(Local face, Local other) const {
    constexpr double same_place = 1e-6; // in face sizes
    const Vec3 apart = center(face) - center(other);
    for (int i = 0; i < 3; ++i)
      if (std::fabs(apart[i]) > same_place * size(face))
        return apart[i] < 0.0;
    return face < other;
  }

private:
  KOKKOS_INLINE_FUNCTION void gather(const View<Vec3>& from, Local face, Vec3* y) const {
    for (int a = 0; a < nodes(face); ++a)
      y[a] = from(face_node(offset(face) + a));
  }
  KOKKOS_INLINE_FUNCTION Vec3 center(Local face) const {
    Vec3 sum = Vec3::zero();
    for (int a = 0; a < nodes(face); ++a)
      sum += (1.0 / nodes(face)) * x(face_node(offset(face) + a));
    return sum;
  }
};

/// The secondary faces that this rank's integration points may meet: its own and those of other
/// ranks whose boxes come near. No rank ever holds the whole surface.
class FacingSurface {
public:
  /// own: the secondary faces that this rank owns; it must outlive the object. reach: see
  /// ContactOptions. Collective.
  FacingSurface(const Comm& comm, const mesh::Surface& own, double reach);

  /// Fetches the faces that come within `wanted` (boxes of this rank's primary faces, inflated by
  /// what they need); each face counts with its own reach. x_own, x_previous: (own nodes, 3)
  /// current and at the last converged step. at_rest: reference coordinates too, for self-contact.
  /// Collective.
  void collect(const std::vector<double>& x_own, const std::vector<double>& x_previous,
               const std::vector<search::Box<3>>& wanted, bool at_rest);
  /// Fetches the current coordinates of the nodes of the collected faces. Collective.
  void update(const std::vector<double>& x_own);
  /// The current coordinates become those of the last converged step.
  void accept() { Kokkos::deep_copy(view_.x_previous, view_.x); }

  /// Adds up at the own nodes what ranks have at the nodes they have collected: values (collected
  /// nodes, width), result (own nodes, width). Collective.
  std::vector<double> give_back(const std::vector<double>& values, std::size_t width) const;

  const FacingView& view() const { return view_; }

private:
  struct Parcels;
  void pack(Local face, double size, std::size_t rank, std::vector<char>& taken, Parcels& out);
  void unpack(const Parcels& in);
  void fetch(const std::vector<double>& x_own, View<Vec3>& x) const;

  Comm comm_;
  const mesh::Surface& own_;
  double reach_;
  std::vector<double> rise_;                      ///< (own faces, 2)
  std::vector<std::vector<Local>> send_nodes_;    ///< per rank: own surface nodes
  std::vector<std::vector<Local>> receive_nodes_; ///< per rank: nodes here, in arriving order
  FacingView view_;
  search::Bvh<3> tree_;
};

} // namespace abut::contact
