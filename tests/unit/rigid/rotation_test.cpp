// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/rotation.hpp"

#include <gtest/gtest.h>

using namespace abut;
using rigid::rotation;

namespace {

double distance(const Mat3& a, const Mat3& b) {
  double d = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      d = std::max(d, std::fabs(a[i][j] - b[i][j]));
  return d;
}

const Vec3 vectors[] = {{{0.0, 0.0, 0.0}},    {{1e-9, 0.0, -2e-9}}, {{0.03, -0.05, 0.02}},
                        {{0.0, 0.0999, 0.0}}, {{0.0, 0.1001, 0.0}}, {{0.7, -1.1, 0.4}},
                        {{3.0, 2.0, -4.0}}};

} // namespace

TEST(Rotation, IsOrthogonalAndTurnsByItsAngle) {
  const Mat3 quarter = rotation({{0.0, 0.0, std::acos(0.0)}});
  EXPECT_LT(distance(quarter, {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}), 1e-15);
  for (const Vec3& w : vectors) {
    const Mat3 r = rotation(w);
    EXPECT_LT(distance(r * transpose(r), Mat3::identity()), 1e-15);
    EXPECT_LT(norm(r * w - w), 1e-14);
  }
}

// d rotation(w) = skew(T dw) rotation(w): central differences, error h^2 and rounding / h.
TEST(Rotation, TangentIsTheDerivative) {
  const Vec3 dw{{0.3, -0.5, 0.8}};
  const double h = 1e-5;
  for (const Vec3& w : vectors) {
    const Mat3 plus = rotation(w + h * dw), minus = rotation(w - h * dw);
    Mat3 difference;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        difference[i][j] = (plus[i][j] - minus[i][j]) / (2.0 * h);
    const Mat3 exact = rigid::skew(rigid::rotation_tangent(w) * dw) * rotation(w);
    EXPECT_LT(distance(difference, exact), 2e-10);
  }
}

TEST(Rotation, VectorCountsWholeTurns) {
  const Vec3 axis{{0.6, 0.0, -0.8}};
  Vec3 found = Vec3::zero();
  for (int i = 1; i <= 200; ++i) { // ten turns there, through whole and half turns
    const Vec3 exact = (0.05 * i * 2.0 * std::acos(-1.0)) * axis;
    found = rigid::rotation_vector(rotation(exact), found);
    EXPECT_LT(norm(found - exact), 1e-12) << i;
  }
  for (int i = 199; i >= -40; --i) { // and back, beyond zero
    const Vec3 exact = (0.05 * i * 2.0 * std::acos(-1.0)) * axis;
    found = rigid::rotation_vector(rotation(exact), found);
    EXPECT_LT(norm(found - exact), 1e-12) << i;
  }
}
