// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/core/tensor.hpp"
#include "abut/fem/cell.hpp"
#include "abut/fem/cell_shape.hpp"
#include "abut/fem/face_shape.hpp"
#include "abut/fem/quadrature.hpp"

#include <gtest/gtest.h>
#include <map>
#include <set>

using namespace abut;
using namespace abut::fem;

namespace {

const CellType all_cells[] = {CellType::hex8, CellType::hex20, CellType::hex27,
                              CellType::tet4, CellType::tet10, CellType::wedge6};

Vec3 reference_node(CellType type, int a) {
  Vec3 x;
  dispatch_cell(type, [&](auto shape) { decltype(shape)::node(a, x.v); });
  return x;
}

double reference_volume(CellType type) {
  double v = 0.0;
  for (const double w : cell_rule(type, 1).weight)
    v += w;
  return v;
}

TEST(Cell, NodeCountsAgreeWithShapeFunctions) {
  for (const CellType type : all_cells)
    dispatch_cell(type, [&](auto shape) {
      EXPECT_EQ(info(type).nodes, decltype(shape)::nodes);
      EXPECT_EQ(type, decltype(shape)::type);
    });
}

// Divergence theorem: the sides close the cell with outward normals if and only if the integral of
// x.n over them is three times the volume and the integral of n is zero.
TEST(Cell, SidesCloseTheCellAndPointOut) {
  for (const CellType type : all_cells) {
    Vec3 center = Vec3::zero(), area = Vec3::zero();
    const int corners = info(type).corners;
    for (int a = 0; a < corners; ++a)
      center += (1.0 / corners) * reference_node(type, a);
    double flux = 0.0;
    for (int s = 0; s < info(type).sides; ++s) {
      const CellSide& cell_side = side(type, s);
      dispatch_face(cell_side.type, [&](auto shape) {
        using S = decltype(shape);
        const Rule<2> rule = face_rule(S::type, 3);
        for (int p = 0; p < rule.size(); ++p) {
          double N[S::nodes], dN[S::nodes][2];
          S::values(rule.xi[p].data(), N);
          S::derivatives(rule.xi[p].data(), dN);
          Vec3 x = Vec3::zero(), t1 = Vec3::zero(), t2 = Vec3::zero();
          for (int a = 0; a < S::nodes; ++a) {
            const Vec3 xa = reference_node(type, cell_side.nodes[a]);
            x += N[a] * xa;
            t1 += dN[a][0] * xa;
            t2 += dN[a][1] * xa;
          }
          const Vec3 n = cross(t1, t2);
          EXPECT_GT(dot(n, x - center), 0.0) << info(type).name << " side " << s;
          area += rule.weight[p] * n;
          flux += rule.weight[p] * dot(n, x);
        }
      });
    }
    EXPECT_NEAR(norm(area), 0.0, 1e-14) << info(type).name;
    EXPECT_NEAR(flux, 3.0 * reference_volume(type), 1e-13) << info(type).name;
  }
}

// The cell's shape functions on a side are the face's shape functions, node by node: this fixes the
// position of every mid-side and centre node, not only of the corners.
TEST(Cell, TraceOnSideIsFaceShape) {
  for (const CellType type : all_cells)
    for (int s = 0; s < info(type).sides; ++s) {
      const CellSide& cell_side = side(type, s);
      dispatch_face(cell_side.type, [&](auto face) {
        using S = decltype(face);
        const double xi[2] = {0.27, 0.41};
        double N[S::nodes], n[max_cell_nodes];
        S::values(xi, N);
        Vec3 x = Vec3::zero();
        for (int a = 0; a < S::nodes; ++a)
          x += N[a] * reference_node(type, cell_side.nodes[a]);
        dispatch_cell(type, [&](auto cell) { decltype(cell)::values(x.v, n); });
        std::set<int> on_side;
        for (int a = 0; a < S::nodes; ++a) {
          EXPECT_NEAR(n[cell_side.nodes[a]], N[a], 1e-15) << info(type).name << " side " << s;
          on_side.insert(cell_side.nodes[a]);
        }
        for (int a = 0; a < info(type).nodes; ++a)
          if (!on_side.count(a)) {
            EXPECT_NEAR(n[a], 0.0, 1e-15) << info(type).name << " side " << s;
          }
        for (int a = S::nodes; a < max_face_nodes; ++a)
          EXPECT_EQ(cell_side.nodes[a], -1);
      });
    }
}

// Spot values of the Exodus II manual (1-based there).
TEST(Cell, ExodusSideNumbers) {
  const auto one_based = [](CellType type, int s) {
    std::vector<int> nodes;
    for (int a = 0; a < face_nodes(side(type, s - 1).type); ++a)
      nodes.push_back(side(type, s - 1).nodes[a] + 1);
    return nodes;
  };
  using V = std::vector<int>;
  EXPECT_EQ(one_based(CellType::hex8, 4), (V{1, 5, 8, 4}));
  EXPECT_EQ(one_based(CellType::hex8, 5), (V{1, 4, 3, 2}));
  EXPECT_EQ(one_based(CellType::hex20, 1), (V{1, 2, 6, 5, 9, 14, 17, 13}));
  EXPECT_EQ(one_based(CellType::hex27, 2), (V{2, 3, 7, 6, 10, 15, 18, 14, 25}));
  EXPECT_EQ(one_based(CellType::hex27, 5), (V{1, 4, 3, 2, 12, 11, 10, 9, 22}));
  EXPECT_EQ(one_based(CellType::tet4, 3), (V{1, 4, 3}));
  EXPECT_EQ(one_based(CellType::tet10, 4), (V{1, 3, 2, 7, 6, 5}));
  EXPECT_EQ(one_based(CellType::wedge6, 3), (V{1, 4, 6, 3}));
  EXPECT_EQ(one_based(CellType::wedge6, 5), (V{4, 5, 6}));
}

TEST(Cell, NoSuchSideIsADefect) {
  EXPECT_THROW(side(CellType::tet4, 4), Defect);
  EXPECT_THROW(side(CellType::hex8, -1), Defect);
}

TEST(Cell, ExodusNames) {
  CellType type = CellType::wedge6;
  EXPECT_TRUE(cell_type_from_exodus("HEX", 8, type));
  EXPECT_EQ(type, CellType::hex8);
  EXPECT_TRUE(cell_type_from_exodus("hex27", 27, type));
  EXPECT_EQ(type, CellType::hex27);
  EXPECT_TRUE(cell_type_from_exodus("HEX", 20, type));
  EXPECT_EQ(type, CellType::hex20);
  EXPECT_TRUE(cell_type_from_exodus("TETRA", 10, type));
  EXPECT_EQ(type, CellType::tet10);
  EXPECT_TRUE(cell_type_from_exodus("tet4", 4, type));
  EXPECT_EQ(type, CellType::tet4);
  EXPECT_TRUE(cell_type_from_exodus("Wedge", 6, type));
  EXPECT_EQ(type, CellType::wedge6);
  EXPECT_FALSE(cell_type_from_exodus("HEX", 9, type));
  EXPECT_FALSE(cell_type_from_exodus("SHELL4", 4, type));
  EXPECT_FALSE(cell_type_from_exodus("TETRA", 8, type));
}

} // namespace
