// SPDX-License-Identifier: BSD-3-Clause
#include "free_motions.hpp"

#include <cmath>
#include <gmock/gmock.h>

namespace abut::scene {
namespace {

using ::testing::ElementsAre;

/// A motion of unit size about a centre, of a body of size 2: spin about a direction through a
/// point, and an advance along it.
Twist turning(const Vec3& spin, const Vec3& point, const Vec3& center, double advance = 0.0) {
  constexpr double size = 2.0;
  Twist t{cross(spin, center - point) + advance * spin, size * spin};
  const double length = std::sqrt(dot(t.velocity, t.velocity) + dot(t.turn, t.turn));
  t.velocity *= 1.0 / length;
  t.turn *= 1.0 / length;
  return t;
}

const Vec3 center{{1.0, 1.0, 1.0}};

TEST(FreeMotions, RotationIsNamedByAxisAndPoint) {
  const Twist hinge = turning({{0.0, 0.0, 1.0}}, {{4.0, 0.0, 7.0}}, center);
  EXPECT_THAT(describe_motions({hinge}, center, 2.0),
              ElementsAre("rotation about z through (4, 0, 1)"));
}

TEST(FreeMotions, ScrewAdvances) {
  const Twist screw = turning({{1.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}}, center, 0.25);
  EXPECT_THAT(describe_motions({screw}, center, 2.0),
              ElementsAre("screw motion about x through (1, 0, 0) that advances 0.25 a radian"));
}

TEST(FreeMotions, DirectionsAreThoseOfAxesWhereTheyCan) {
  const double h = std::sqrt(0.5);
  const Twist a{{{h, h, 0.0}}, Vec3::zero()}, b{{{h, -h, 0.0}}, Vec3::zero()};
  EXPECT_THAT(describe_motions({a, b}, center, 2.0),
              ElementsAre("translation along x", "translation along y"));
  EXPECT_THAT(describe_motions({a}, center, 2.0),
              ElementsAre("translation along (0.707, 0.707, 0)"));
}

/// A body on a smooth floor slides and turns; the axis of its turning is any one along z.
TEST(FreeMotions, AxisIsNearestToTheCentreWhereTranslationsMoveIt) {
  const Twist x{{{1.0, 0.0, 0.0}}, Vec3::zero()}, y{{{0.0, 1.0, 0.0}}, Vec3::zero()};
  EXPECT_THAT(describe_motions({x, y, turning({{0.0, 0.0, 1.0}}, center, center)}, center, 2.0),
              ElementsAre("translation along x", "translation along y",
                          "rotation about z through (1, 1, 1)"));
}

} // namespace
} // namespace abut::scene
