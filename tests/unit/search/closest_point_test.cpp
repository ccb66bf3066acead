// SPDX-License-Identifier: BSD-3-Clause
// Newton's projection against a dense sampling of the face.
#include "abut/search/closest_point.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace abut;
using fem::FaceType;

TEST(ClosestPoint, BeatsEverySampleOfTheFace) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.1, 0.1), inside(0.1, 0.4), height(-0.4, 0.4);
  int checked = 0;
  for (const FaceType type :
       {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3, FaceType::tri6})
    for (int trial = 0; trial < 50; ++trial) {
      Vec3 y[9];
      fem::dispatch_face(type, [&](auto shape) {
        for (int a = 0; a < decltype(shape)::nodes; ++a) {
          double p[2];
          decltype(shape)::node(a, p);
          y[a] = {{p[0] + noise(random), p[1] + noise(random), noise(random)}};
        }
      });
      const Vec3 x = {{inside(random), inside(random), height(random)}};
      double start[2];
      fem::dispatch_face(type, [&](auto shape) { decltype(shape)::center(start); });
      const search::Projection p = search::project(type, y, x, start);
      ASSERT_TRUE(p.converged);
      fem::FacePoint<double> at;
      fem::face_point(type, y, p.xi, at);
      const double distance = norm(x - at.x);
      // Orthogonality to round-off of the coordinates.
      EXPECT_LT(std::fabs(dot(x - at.x, at.tangent[0])), 1e-14);
      EXPECT_LT(std::fabs(dot(x - at.x, at.tangent[1])), 1e-14);
      const bool interior =
          fem::dispatch_face(type, [&](auto shape) { return decltype(shape)::inside(p.xi, 0.0); });
      if (!interior)
        continue;
      ++checked;
      for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 60; ++j) {
          double xi[2] = {i / 60.0, j / 60.0};
          if (!fem::is_triangle(type))
            xi[0] = 2 * xi[0] - 1, xi[1] = 2 * xi[1] - 1;
          if (fem::is_triangle(type) && xi[0] + xi[1] > 1.0)
            continue;
          fem::FacePoint<double> sample;
          fem::face_point(type, y, xi, sample);
          EXPECT_GE(norm(x - sample.x), distance - 1e-12);
        }
    }
  EXPECT_GT(checked, 150);
}

TEST(ClosestPoint, IndependentOfTheStart) {
  Vec3 y[4] = {{{-1, -1, 0.1}}, {{1.2, -1, -0.2}}, {{1, 1.1, 0.15}}, {{-1, 0.9, 0}}};
  const Vec3 x = {{0.3, -0.2, -0.3}};
  const double a[2] = {0, 0}, b[2] = {0.9, -0.9};
  const auto p = search::project(FaceType::quad4, y, x, a),
             q = search::project(FaceType::quad4, y, x, b);
  ASSERT_TRUE(p.converged && q.converged);
  EXPECT_NEAR(p.xi[0], q.xi[0], 1e-14);
  EXPECT_NEAR(p.xi[1], q.xi[1], 1e-14);
}

TEST(ClosestPoint, FarOutsideDoesNotConverge) {
  Vec3 y[3] = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  const double start[2] = {0.3, 0.3};
  EXPECT_FALSE(search::project(FaceType::tri3, y, Vec3{{50, 50, 1}}, start).converged);
}
