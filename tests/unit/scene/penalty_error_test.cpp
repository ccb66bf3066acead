// SPDX-License-Identifier: BSD-3-Clause
// Elastic energies over t by hand, a tenth of them in the springs.
#include "abut/scene/penalty_error.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

using namespace abut;

namespace {

scene::PenaltyError after(int steps, const std::function<double(double)>& energy) {
  scene::PenaltyWatch watch;
  for (int i = 0; i <= steps; ++i) {
    scene::State s;
    s.time = double(i) / steps;
    s.energy.stored = 0.9 * energy(s.time);
    for (const double share : {0.075, 0.025}) {
      contact::ContactSummary& c = s.contacts.emplace_back();
      c.softness = share * energy(s.time);
      c.max_penetration = 0.2;
      c.normal = 5.0;
    }
    watch.look(s);
  }
  return watch.error();
}

} // namespace

TEST(PenaltyError, OfALinearModelIsTheShareOfTheEnergy) {
  for (const int steps : {1, 2, 7}) {
    const scene::PenaltyError error = after(steps, [](double t) { return 2.0 * t * t; });
    EXPECT_NEAR(error.whole, 0.1, 1e-12);
    EXPECT_NEAR(error.contacts[0], 0.075, 1e-12);
    EXPECT_NEAR(error.contacts[1], 0.025, 1e-12);
    EXPECT_NEAR(error.penetration_over_approach[0], 0.2 / (2.0 * 2.0 / 5.0), 1e-12);
  }
}

TEST(PenaltyError, CountsFromTheFirstTouch) {
  const auto energy = [](double t) { return t > 0.5 ? (t - 0.5) * (t - 0.5) : 0.0; };
  EXPECT_NEAR(after(10, energy).whole, 0.1, 1e-12);
}

TEST(PenaltyError, IsLargerWhereTheModelStiffens) {
  // F like d^2: E like d^3, the force is off by 2 dd/d and dd/d = 2/3 w/E
  EXPECT_NEAR(after(1000, [](double t) { return t * t * t; }).whole, 4.0 / 3.0 * 0.1, 1e-3);
  EXPECT_NEAR(after(1000, [](double t) { return std::exp(20.0 * t); }).whole, 0.2, 5e-3);
}

TEST(PenaltyError, IsTheShareWhereLoadRestsOrFalls) {
  EXPECT_NEAR(after(10, [](double t) { return std::fmin(t * t, 0.25) + 1e-9 * t * t * t; }).whole,
              0.1, 1e-9);
  EXPECT_NEAR(after(10, [](double t) { return 1.0 - 0.5 * t * t * t; }).whole, 0.1, 1e-12);
  EXPECT_EQ(after(10, [](double) { return 0.0; }).whole, 0.0);
}

TEST(PenaltyError, IsNoneWhereNothingElseGives) {
  scene::PenaltyWatch watch;
  scene::State s;
  s.contacts.resize(1);
  s.contacts[0].softness = 1.0;
  watch.look(s);
  EXPECT_EQ(watch.error().whole, 0.0);
  s.energy.kinetic = 3.0;
  watch.look(s);
  EXPECT_NEAR(watch.error().whole, 0.25, 1e-15);
}
