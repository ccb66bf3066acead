// SPDX-License-Identifier: BSD-3-Clause
#include "abut/audit/inside_cell.hpp"

#include "abut/fem/cell_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace abut;

namespace {

constexpr fem::CellType all_types[] = {fem::CellType::hex8,  fem::CellType::hex20,
                                       fem::CellType::hex27, fem::CellType::tet4,
                                       fem::CellType::tet10, fem::CellType::wedge6};

/// Nodes of a cell that is stretched, sheared and bent a little.
std::vector<Vec3> bent_cell(fem::CellType type) {
  std::vector<Vec3> y;
  fem::dispatch_cell(type, [&](auto shape) {
    using Shape = decltype(shape);
    for (int a = 0; a < Shape::nodes; ++a) {
      double p[3];
      Shape::node(a, p);
      y.push_back({{5.0 + 2.0 * p[0] + 0.3 * p[1], -1.0 + p[1] + 0.1 * p[0] * p[2],
                    0.5 * p[2] + 0.05 * p[0] * p[0] + 0.2 * p[1]}});
    }
  });
  return y;
}

Vec3 at(fem::CellType type, const std::vector<Vec3>& y, const double xi[3]) {
  return fem::dispatch_cell(type, [&](auto shape) {
    using Shape = decltype(shape);
    double N[Shape::nodes];
    Shape::values(xi, N);
    Vec3 x = Vec3::zero();
    for (int a = 0; a < Shape::nodes; ++a)
      x += N[a] * y[std::size_t(a)];
    return x;
  });
}

/// How far xi is inside the domain of the cell, in parameters; < 0: outside.
double depth(fem::CellType type, const double xi[3]) {
  const int corners = fem::info(type).corners;
  if (corners == 8)
    return 1.0 - std::max({std::fabs(xi[0]), std::fabs(xi[1]), std::fabs(xi[2])});
  const double triangle = std::min({xi[0], xi[1], 1.0 - xi[0] - xi[1]});
  if (corners == 6)
    return std::min(triangle, 1.0 - std::fabs(xi[2]));
  return std::min({xi[0], xi[1], xi[2], 1.0 - xi[0] - xi[1] - xi[2]});
}

TEST(InsideCell, TellsPointsInsideFromPointsOutside) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.3, 1.3);
  for (const fem::CellType type : all_types) {
    const std::vector<Vec3> y = bent_cell(type);
    int inside = 0, outside = 0;
    for (int k = 0; k < 4000; ++k) {
      const double xi[3] = {any(random), any(random), any(random)};
      const double d = depth(type, xi);
      if (std::fabs(d) < 1e-6)
        continue;
      EXPECT_EQ(audit::inside_cell(type, y.data(), at(type, y, xi)), d > 0.0)
          << fem::info(type).name << " " << xi[0] << " " << xi[1] << " " << xi[2];
      (d > 0.0 ? inside : outside)++;
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(outside, 500);
  }
}

TEST(InsideCell, FacesEdgesAndCornersBelongToTheCell) {
  for (const fem::CellType type : all_types) {
    const std::vector<Vec3> y = bent_cell(type);
    for (int a = 0; a < fem::info(type).corners; ++a)
      EXPECT_TRUE(audit::inside_cell(type, y.data(), y[std::size_t(a)])) << fem::info(type).name;
    EXPECT_FALSE(audit::inside_cell(type, y.data(), Vec3{{100.0, 0.0, 0.0}}));
  }
}

/// A cell without volume has nothing inside, and breaks nothing.
TEST(InsideCell, FlatCellsHoldNothing) {
  std::vector<Vec3> y = bent_cell(fem::CellType::hex8);
  for (Vec3& x : y)
    x[2] = 0.0;
  EXPECT_FALSE(audit::inside_cell(fem::CellType::hex8, y.data(), Vec3{{5.0, -1.0, 0.1}}));
}

} // namespace
