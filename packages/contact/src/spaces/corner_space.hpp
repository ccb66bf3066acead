// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/mesh/surface.hpp"

#include <vector>

namespace abut::contact {

/// Continuous functions on the primary surface that are linear between the corners of its faces,
/// one for each corner node: positive with a positive integral on every face type, where the
/// functions of quadratic faces are not. Nodes are the surface's own numbers; a node on several
/// ranks has a value on each.
class CornerSpace {
public:
  /// surface must outlive the space. Collective.
  CornerSpace(const Comm& comm, const mesh::Surface& surface);

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
  int owner(Local node) const { return owner_[node]; }
  bool is_shared(Local node) const { return is_shared_[node] != 0; }
  /// Adds up what each rank has for a node that several ranks share: data (surface nodes,
  /// components). Every rank gets the same digits. Collective.
  void sum(double* data, int components = 1) const;
  void sum(std::vector<double>& data, int components = 1) const { sum(data.data(), components); }

private:
  struct Neighbour {
    int rank;
    std::vector<Local> nodes; ///< shared with that rank, ascending by their global number
  };

  Comm comm_;
  const mesh::Surface& surface_;
  std::vector<Neighbour> neighbours_; ///< ascending by rank, this one among them when it shares
  std::vector<Local> shared_;         ///< nodes that other ranks have too
  std::vector<char> is_shared_;       ///< (surface nodes)
  std::vector<int> owner_;            ///< (surface nodes)
};

} // namespace abut::contact
