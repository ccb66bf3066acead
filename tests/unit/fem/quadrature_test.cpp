// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/fem/quadrature.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::fem;

namespace {

double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

/// Integral of x^k over [-1, 1].
double line(int k) {
  return k % 2 ? 0.0 : 2.0 / (k + 1);
}

/// Integrals of monomials over the unit triangle and tetrahedron.
double triangle(int i, int j) {
  return factorial(i) * factorial(j) / factorial(i + j + 2);
}
double tetrahedron(int i, int j, int k) {
  return factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
}

template <int D> double integrate(const Rule<D>& rule, const int (&power)[D]) {
  double sum = 0.0;
  for (int p = 0; p < rule.size(); ++p) {
    double f = rule.weight[p];
    for (int d = 0; d < D; ++d)
      f *= std::pow(rule.xi[p][d], power[d]);
    sum += f;
  }
  return sum;
}

constexpr double tolerance = 1e-14;
const int triangle_degree[] = {0, 1, 2, 4, 6, 8, 10};
const int tetrahedron_degree[] = {0, 1, 2, 5, 7, 9, 11};

TEST(Quadrature, Quad) {
  for (int n = 1; n <= max_points_per_direction; ++n) {
    const Rule<2> rule = face_rule(FaceType::quad8, n);
    EXPECT_EQ(rule.size(), n * n);
    for (int i = 0; i < 2 * n; ++i)
      for (int j = 0; j < 2 * n; ++j)
        EXPECT_NEAR(integrate(rule, {i, j}), line(i) * line(j), 4 * tolerance) << n;
    EXPECT_GT(std::abs(integrate(rule, {2 * n, 0}) - 2.0 * line(2 * n)), 1e-6) << n;
  }
}

TEST(Quadrature, Triangle) {
  const int points[] = {0, 1, 3, 6, 12, 25, 36};
  for (int n = 1; n <= max_points_per_direction; ++n) {
    const Rule<2> rule = face_rule(FaceType::tri6, n);
    EXPECT_EQ(rule.size(), points[n]);
    for (const double w : rule.weight)
      EXPECT_GT(w, 0.0);
    for (const auto& p : rule.xi) {
      EXPECT_GT(p[0], 0.0);
      EXPECT_GT(p[1], 0.0);
      EXPECT_LT(p[0] + p[1], 1.0);
    }
    for (int i = 0; i <= triangle_degree[n]; ++i)
      for (int j = 0; i + j <= triangle_degree[n]; ++j)
        EXPECT_NEAR(integrate(rule, {i, j}), triangle(i, j), tolerance) << n << i << j;
  }
}

TEST(Quadrature, Tetrahedron) {
  const int points[] = {0, 1, 4, 15, 125, 216, 343};
  for (int n = 1; n <= max_points_per_direction; ++n) {
    const Rule<3> rule = cell_rule(CellType::tet10, n);
    EXPECT_EQ(rule.size(), points[n]);
    for (const double w : rule.weight)
      EXPECT_GT(w, 0.0);
    for (int i = 0; i <= tetrahedron_degree[n]; ++i)
      for (int j = 0; i + j <= tetrahedron_degree[n]; ++j)
        for (int k = 0; i + j + k <= tetrahedron_degree[n]; ++k)
          EXPECT_NEAR(integrate(rule, {i, j, k}), tetrahedron(i, j, k), tolerance) << n;
  }
}

TEST(Quadrature, HexAndWedge) {
  for (int n = 1; n <= max_points_per_direction; ++n) {
    const Rule<3> hex = cell_rule(CellType::hex8, n), wedge = cell_rule(CellType::wedge6, n);
    EXPECT_EQ(hex.size(), n * n * n);
    for (int i = 0; i < 2 * n; ++i)
      for (int j = 0; j < 2 * n; ++j)
        for (int k = 0; k < 2 * n; ++k) {
          EXPECT_NEAR(integrate(hex, {i, j, k}), line(i) * line(j) * line(k), 8 * tolerance);
          if (i + j <= triangle_degree[n]) {
            EXPECT_NEAR(integrate(wedge, {i, j, k}), triangle(i, j) * line(k), tolerance);
          }
        }
  }
}

TEST(Quadrature, Defaults) {
  const auto points = [](CellType t) { return cell_rule(t, default_points(t)).size(); };
  EXPECT_EQ(points(CellType::hex8), 8);
  EXPECT_EQ(points(CellType::hex20), 27);
  EXPECT_EQ(points(CellType::hex27), 27);
  EXPECT_EQ(points(CellType::tet4), 1);
  EXPECT_EQ(points(CellType::tet10), 4);
  EXPECT_EQ(points(CellType::wedge6), 6);
  EXPECT_EQ(default_points(FaceType::quad4), 2);
  EXPECT_EQ(default_points(FaceType::tri6), 3);
}

TEST(Quadrature, OutOfRangeIsADefect) {
  EXPECT_THROW(face_rule(FaceType::quad4, 0), Defect);
  EXPECT_THROW(cell_rule(CellType::hex8, max_points_per_direction + 1), Defect);
}

} // namespace
