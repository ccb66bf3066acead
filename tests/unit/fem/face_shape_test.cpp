// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/face_shape.hpp"

#include <Sacado.hpp>
#include <gtest/gtest.h>

using namespace abut::fem;

namespace {

using Ad = Sacado::Fad::SFad<double, 2>;

template <class S> class FaceShapes : public ::testing::Test {};
using Faces = ::testing::Types<FaceShape<FaceType::quad4>, FaceShape<FaceType::quad8>,
                               FaceShape<FaceType::quad9>, FaceShape<FaceType::tri3>,
                               FaceShape<FaceType::tri6>>;
TYPED_TEST_SUITE(FaceShapes, Faces);

TYPED_TEST(FaceShapes, Nodal) {
  using S = TypeParam;
  EXPECT_EQ(S::nodes, face_nodes(S::type));
  EXPECT_EQ(S::corners, face_corners(S::type));
  EXPECT_EQ(S::triangle, is_triangle(S::type));
  for (int b = 0; b < S::nodes; ++b) {
    double xi[2], N[S::nodes];
    S::node(b, xi);
    EXPECT_TRUE(S::inside(xi, 0.0));
    S::values(xi, N);
    for (int a = 0; a < S::nodes; ++a)
      EXPECT_NEAR(N[a], a == b ? 1.0 : 0.0, 1e-16);
  }
}

// Mid-edge node a of edge (a - corners) lies between that corner and the next one.
TYPED_TEST(FaceShapes, MiddlesBetweenCorners) {
  using S = TypeParam;
  for (int a = S::corners; a < S::nodes && a < 2 * S::corners; ++a) {
    double p[2], q[2], m[2];
    S::node(a - S::corners, p);
    S::node((a - S::corners + 1) % S::corners, q);
    S::node(a, m);
    for (int i = 0; i < 2; ++i)
      EXPECT_DOUBLE_EQ(m[i], 0.5 * (p[i] + q[i]));
  }
}

TYPED_TEST(FaceShapes, DerivativesMatchAutomaticDifferentiation) {
  using S = TypeParam;
  const double points[][2] = {{0.13, 0.37}, {0.71, 0.11}, {-0.6, 0.83}};
  for (const auto& point : points) {
    const Ad xi[2] = {Ad(2, 0, point[0]), Ad(2, 1, point[1])};
    Ad N[S::nodes], dN_ad[S::nodes][2];
    double dN[S::nodes][2], d2N[S::nodes][3];
    S::values(xi, N);
    S::derivatives(xi, dN_ad);
    S::derivatives(point, dN);
    S::second_derivatives(point, d2N);
    double sum = 0.0;
    for (int a = 0; a < S::nodes; ++a) {
      sum += N[a].val();
      for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(dN[a][i], N[a].dx(i), 1e-15);
        EXPECT_NEAR(dN[a][i], dN_ad[a][i].val(), 1e-15);
        EXPECT_NEAR(d2N[a][i], dN_ad[a][i].dx(i), 1e-14);
        EXPECT_NEAR(d2N[a][2], dN_ad[a][i].dx(1 - i), 1e-14);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
  }
}

TYPED_TEST(FaceShapes, InsideWithTolerance) {
  using S = TypeParam;
  double c[2];
  S::center(c);
  EXPECT_TRUE(S::inside(c, 0.0));
  const double out[2] = {S::triangle ? 0.55 : 1.05, S::triangle ? 0.5 : 0.0};
  EXPECT_FALSE(S::inside(out, 0.0));
  EXPECT_TRUE(S::inside(out, 0.0501));
  const double low[2] = {0.0, S::triangle ? -0.05 : -1.05};
  EXPECT_FALSE(S::inside(low, 0.0));
  EXPECT_TRUE(S::inside(low, 0.0501));
}

TEST(FaceShape, DispatchReachesEveryType) {
  for (const FaceType t :
       {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3, FaceType::tri6})
    EXPECT_EQ(dispatch_face(t, [](auto shape) { return decltype(shape)::type; }), t);
}

} // namespace
