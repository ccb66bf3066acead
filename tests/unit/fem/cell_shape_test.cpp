// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/cell_shape.hpp"

#include <Sacado.hpp>
#include <gtest/gtest.h>

using namespace abut::fem;

namespace {

using Ad = Sacado::Fad::SFad<double, 3>;

template <class S> class CellShapes : public ::testing::Test {};
using Cells = ::testing::Types<CellShape<CellType::hex8>, CellShape<CellType::hex20>,
                               CellShape<CellType::hex27>, CellShape<CellType::tet4>,
                               CellShape<CellType::tet10>, CellShape<CellType::wedge6>>;
TYPED_TEST_SUITE(CellShapes, Cells);

TYPED_TEST(CellShapes, Nodal) {
  using S = TypeParam;
  for (int b = 0; b < S::nodes; ++b) {
    double xi[3], N[S::nodes];
    S::node(b, xi);
    S::values(xi, N);
    for (int a = 0; a < S::nodes; ++a)
      EXPECT_NEAR(N[a], a == b ? 1.0 : 0.0, 1e-16);
  }
}

TYPED_TEST(CellShapes, DerivativesMatchAutomaticDifferentiation) {
  using S = TypeParam;
  const double point[3] = {0.13, 0.37, 0.29};
  const Ad xi[3] = {Ad(3, 0, point[0]), Ad(3, 1, point[1]), Ad(3, 2, point[2])};
  Ad N[S::nodes];
  double dN[S::nodes][3];
  S::values(xi, N);
  S::derivatives(point, dN);
  for (int a = 0; a < S::nodes; ++a)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(dN[a][i], N[a].dx(i), 1e-15);
}

// Interpolates every linear field exactly: sum N = 1, sum N x_a = x, sum dN x_a = identity.
TYPED_TEST(CellShapes, LinearCompleteness) {
  using S = TypeParam;
  const double point[3] = {0.21, 0.33, -0.17};
  double N[S::nodes], dN[S::nodes][3], sum = 0.0, x[3] = {}, gradient[3][3] = {};
  S::values(point, N);
  S::derivatives(point, dN);
  for (int a = 0; a < S::nodes; ++a) {
    double p[3];
    S::node(a, p);
    sum += N[a];
    for (int i = 0; i < 3; ++i) {
      x[i] += N[a] * p[i];
      for (int j = 0; j < 3; ++j)
        gradient[i][j] += p[i] * dN[a][j];
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(x[i], point[i], 1e-15);
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(gradient[i][j], i == j ? 1.0 : 0.0, 1e-15);
  }
}

} // namespace
