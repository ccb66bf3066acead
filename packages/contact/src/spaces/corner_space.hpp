// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/node_exchange.hpp"
#include "abut/mesh/surface.hpp"

#include <vector>

namespace abut::contact {

/// Values of the functions of a face that are linear between its corners, at a point of its
/// parameter plane: (corners).
void corner_values(fem::FaceType type, const double xi[2], double* N);

/// Share of node a of a face (corners, middle nodes, center) in a point with corner functions N:
/// a middle node takes those of the corners it stands between.
double corner_share(const double* N, int corners, int a);

/// Continuous functions on the primary surface that are linear between the corners of its faces,
/// one for each corner node: positive with a positive integral on every face type, where the
/// functions of quadratic faces are not. Nodes are the surface's own numbers; a node on several
/// ranks has a value on each.
class CornerSpace {
public:
  /// surface must outlive the space. Collective.
  CornerSpace(const Comm& comm, const mesh::Surface& surface)
      : surface_(surface), shared_(comm, surface.node) {}

  Local nodes() const { return surface_.num_nodes(); }
  int corners(Local face) const { return fem::face_corners(surface_.type[face]); }
  /// Surface nodes of the face's corners.
  const Local* nodes(Local face) const { return &surface_.nodes[surface_.offset[face]]; }
  /// Values of the face's functions at a point of its parameter plane: (corners).
  void values(Local face, const double xi[2], double* N) const;
  /// The function's value at the point; data: (surface nodes, components).
  double interpolate(Local face, const double* N, const std::vector<double>& data,
                     int component = 0, int components = 1) const;

  /// Lowest rank that has the surface node, and whether there are others.
  int owner(Local node) const { return shared_.owner(node); }
  bool is_shared(Local node) const { return shared_.is_shared(node); }
  /// Adds up what each rank has for a node that several ranks share: data (surface nodes,
  /// components). Every rank gets the same digits. Collective.
  void sum(double* data, int components = 1) const { shared_.sum(data, components); }
  void sum(std::vector<double>& data, int components = 1) const { sum(data.data(), components); }

private:
  const mesh::Surface& surface_;
  SharedNodes shared_;
};

} // namespace abut::contact
