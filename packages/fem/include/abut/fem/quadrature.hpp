// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

#include <array>
#include <vector>

namespace abut::fem {

/// Points of the reference domain of dimension D with weights that sum to its measure.
template <int D> struct Rule {
  std::vector<std::array<double, D>> xi; ///< (P, D)
  std::vector<double> weight;            ///< (P)

  int size() const { return static_cast<int>(weight.size()); }
  void add(const std::array<double, D>& x, double w) {
    xi.push_back(x);
    weight.push_back(w);
  }
};

constexpr int max_points_per_direction = 6;

/// Gauss-Legendre rule with n >= 1 points on [-1, 1], exact to degree 2n-1.
Rule<1> line_rule(int n);

/// Rule with n = 1 .. 6 "points per direction"; otherwise throws Defect.
/// Quads: n x n Gauss, exact to degree 2n-1 in each direction.
/// Triangles: n = 1, 2, 3, 4 have 1, 3, 6, 12 interior points with positive weights, exact to
/// degree 1, 2, 4, 6 (Dunavant, Int. J. Numer. Meth. Eng. 21, 1985); above, collapsed n x n Gauss,
/// degree 2n-2.
Rule<2> face_rule(FaceType type, int n);

/// Points at the nodes. quad4, tri3, quad9 (Simpson) and tri6 (middle nodes only) have the weights
/// that integrate their own functions. Those of quad8 would be negative at the corners, where a
/// penalty then attracts: it has positive ones in the ratio of its lumped mass, 3/19 and 16/19.
Rule<2> nodal_rule(FaceType type);

/// Rule with n = 1 .. 6 "points per direction"; otherwise throws Defect.
/// Bricks: n^3 Gauss. Tetrahedra: n = 1, 2, 3 have 1, 4, 15 points, degree 1, 2, 5 (Keast, Comput.
/// Meth. Appl. Mech. Eng. 55, 1986); above, collapsed (n+1)^3 Gauss, degree 2n-1. Wedges: triangle
/// rule n times line rule n.
Rule<3> cell_rule(CellType type, int n);

/// n that integrates the stiffness of an undistorted face or cell well enough:
/// quad4, tri3: 2; quad8, quad9, tri6: 3.
int default_points(FaceType type);
/// hex8: 2 (8 points); hex20, hex27: 3 (27); tet4: 1 (1); tet10: 2 (4); wedge6: 2 (6).
int default_points(CellType type);

} // namespace abut::fem
