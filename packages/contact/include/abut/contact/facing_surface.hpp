// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/search/bvh.hpp"

#include <vector>

namespace abut::contact {

/// The secondary faces that this rank's integration points may meet: its own and those of other
/// ranks whose boxes come near. No rank ever holds the whole surface.
class FacingSurface {
public:
  /// own: the secondary faces that this rank owns. reach: see ContactOptions.
  FacingSurface(const Comm& comm, const mesh::Surface& own, double reach);

  /// Fetches the faces that come within `wanted` (boxes of this rank's primary faces, inflated by
  /// what they need); each face counts with its own reach. x_own, x_previous: (own nodes, 3)
  /// current and at the last converged step. Collective.
  void collect(const std::vector<double>& x_own, const std::vector<double>& x_previous,
               const std::vector<search::Box<3>>& wanted);
  /// Fetches the current coordinates of the nodes of the collected faces. Collective.
  void update(const std::vector<double>& x_own);
  /// The current coordinates become those of the last converged step.
  void accept() { x_previous_ = x_; }

  Local num_faces() const { return static_cast<Local>(type_.size()); }
  fem::FaceType type(Local face) const { return type_[face]; }
  Global face_id(Local face) const { return face_id_[face]; }
  int nodes(Local face) const { return offset_[face + 1] - offset_[face]; }
  /// The face of this id, -1 when it is not among those here.
  Local find(Global face_id) const;
  /// Which of two faces a point above their common edge belongs to: by the place of their centers
  /// along x, y, z. It depends neither on the numbering nor on the number of ranks.
  bool goes_before(Local face, Local other) const;
  /// Current coordinates of a face's nodes, and those at the last converged step.
  void coordinates(Local face, Vec3* y) const { gather(x_, face, y); }
  void previous_coordinates(Local face, Vec3* y) const { gather(x_previous_, face, y); }
  /// Global mesh nodes of a face.
  void global_nodes(Local face, Global* nodes) const;
  double size(Local face) const { return size_[face]; } ///< reference size [length]
  double largest_size() const { return largest_size_; } ///< of all faces here [length]
  double modulus(Local face) const { return modulus_[face]; }
  double inverse_depth(Local face) const { return inverse_depth_[face]; }
  const search::Bvh<3>& tree() const { return tree_; }

private:
  struct Parcels;
  void pack(Local face, double size, std::size_t rank, std::vector<char>& taken, Parcels& out);
  void unpack(const Parcels& in);
  search::Box<3> box(Local face) const;
  void fetch(const std::vector<double>& x_own, std::vector<double>& x) const;
  void gather(const std::vector<double>& x, Local face, Vec3* y) const;

  Comm comm_;
  const mesh::Surface& own_;
  double reach_;
  std::vector<std::vector<Local>> send_nodes_;    ///< per rank: own surface nodes
  std::vector<std::vector<Local>> receive_nodes_; ///< per rank: nodes here, in arriving order
  std::vector<fem::FaceType> type_;
  std::vector<Global> face_id_; ///< ascending: the order does not depend on the partition
  std::vector<Local> offset_, face_nodes_;
  std::vector<Global> node_;
  std::vector<double> x_, x_previous_; ///< (nodes, 3)
  std::vector<double> size_, modulus_, inverse_depth_;
  double largest_size_ = 0.0;
  search::Bvh<3> tree_;
};

/// Size of each face: square root of its area in the coordinates x (surface nodes, 3).
std::vector<double> face_sizes(const mesh::Surface& surface);

} // namespace abut::contact
