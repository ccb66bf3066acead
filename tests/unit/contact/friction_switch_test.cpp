// SPDX-License-Identifier: BSD-3-Clause
// The way to the return map ends at the return map, with its derivative, from wherever it starts.
#include "abut/contact/friction_switch.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

using namespace abut;
using contact::Keep;
using contact::ShearChoice;
using contact::ShearIterate;

const Vec3 up{{0, 0, 1}};
constexpr double limit = 0.3;

Vec3 return_map(const Vec3& z) {
  return norm(z) > limit ? (limit / norm(z)) * z : z;
}

/// Iterates at a trial that stays; the number of iterates that it took in `count`.
ShearChoice settle(ShearIterate last, const Vec3& trial, double share, int& count) {
  for (count = 1;; ++count) {
    const ShearChoice choice = choose_shear(last, trial, up, limit, share);
    if (choice.settled || count == 50)
      return choice;
    last = {true, choice.slips, choice.line};
  }
}

class Switching : public ::testing::TestWithParam<double> {};

TEST_P(Switching, EndsAtTheReturnMapFromAnyIterate) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * M_PI), size(0.0, 1.0);
  int most = 0, stuck = 0, slipped = 0;
  for (int i = 0; i < 500; ++i) {
    const double a = angle(random), b = angle(random);
    const Vec3 trial =
        (std::pow(10.0, 4.0 * size(random) - 1.0) * limit) * Vec3{{std::cos(a), std::sin(a), 0}};
    ShearIterate last{true, true, {{{std::cos(b), std::sin(b), 0}}, size(random)}};
    int count = 0;
    const ShearChoice choice = settle(last, trial, GetParam(), count);
    most = std::max(most, count);
    EXPECT_LT(norm(choice.traction - return_map(trial)), 2e-8 * limit);
    EXPECT_EQ(choice.slips, norm(trial) > limit);
    ++(choice.slips ? slipped : stuck);
  }
  EXPECT_GT(stuck, 50);
  EXPECT_GT(slipped, 50);
  EXPECT_LE(most, 12);
}

TEST_P(Switching, SlipHasTheDerivativeOfTheReturnMapInTheEnd) {
  const Vec3 trial{{0.5, 0.4, 0}};
  int count = 0;
  const ShearChoice near = settle({true, true, {{{1, 0, 0}}, 0.5}}, trial, GetParam(), count);
  ASSERT_TRUE(near.slips);
  // The traction is exact to the square of what the direction is.
  const ShearChoice end =
      contact::choose_shear({true, true, near.line}, trial, up, limit, GetParam());
  constexpr double h = 1e-6;
  for (int i = 0; i < 2; ++i) {
    Vec3 step = Vec3::zero();
    step[i] = h;
    const Vec3 exact = (0.5 / h) * (return_map(trial + step) - return_map(trial - step));
    const Vec3& n = end.line.direction;
    const Vec3 line = (end.line.turning / h) * (step - dot(n, step) * n);
    EXPECT_LT(norm(line - exact), 1e-7);
  }
}

TEST_P(Switching, StaysWithAHeldStatus) {
  const ShearIterate last{true, false, {}};
  const Vec3 far{{3.0, 0, 0}}, near{{0.1, 0, 0}};
  const ShearChoice stick = choose_shear(last, far, up, limit, GetParam(), Keep::stick);
  EXPECT_FALSE(stick.slips);
  EXPECT_FALSE(stick.settled);
  EXPECT_EQ(stick.traction[0], 3.0);
  const ShearChoice slip = choose_shear(last, near, up, limit, GetParam(), Keep::slip);
  EXPECT_TRUE(slip.slips);
  EXPECT_FALSE(slip.settled);
  EXPECT_NEAR(slip.traction[0], limit, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Shares, Switching, ::testing::Values(1.0, 0.6, 0.06, 6e-4));

// A stiff spring whose motion turns back overshoots to the other side of the cone: where the return
// map slips, the switching sticks first.
TEST(SwitchingOfAStiffSpring, SticksWhereTheMotionTurnsBack) {
  const ShearIterate last{true, true, {{{1, 0, 0}}, 0.0}};
  const Vec3 thrown{{-10.0 * limit, 0, 0}};
  EXPECT_FALSE(choose_shear(last, thrown, up, limit, 0.01).slips);
  EXPECT_TRUE(choose_shear(last, thrown, up, limit, 1.0).slips);
}

// Without an iterate to go on from the return map decides.
TEST(SwitchingOfANewPoint, IsTheReturnMap) {
  const ShearChoice choice = contact::choose_shear({}, Vec3{{0, 2.0, 0}}, up, limit, 0.01);
  EXPECT_TRUE(choice.slips);
  EXPECT_TRUE(choice.settled);
}

} // namespace
