// SPDX-License-Identifier: BSD-3-Clause
// One point on springs over Newton iterations, steps and augmentations.
#include "point_on_springs.hpp"

using namespace abut;
using namespace abut::contact;
using namespace abut::contact::testing;

namespace {

struct Kind {
  Map map;
  bool ray;
};
constexpr Kind maps[] = {
    {Map::inclined, true}, {Map::incremental, true}, {Map::incremental, false}};
constexpr double degree = 3.14159265358979323846 / 180.0;

bool sticks(PointRule rule) {
  return rule == PointRule::anchored || rule == PointRule::incremental_stick;
}

void shift(Nodes& x, const Vec3& by) {
  for (Vec3& v : x)
    v += by;
}

} // namespace

// Check 11: loads around the limit of stick, springs of very different stiffness.
TEST(PointHistory, LoadSweepAroundTheLimitHasNoCycles) {
  int most = 0, solved = 0, stuck = 0, slipped = 0;
  for (const Kind& kind : maps)
    for (const double phi : {5.0, 10.0})
      for (const double sign : {-1.0, 1.0})
        for (const Vec3& spring : {Vec3{{5, 5, 500}}, Vec3{{500, 500, 5}}, Vec3{{50, 50, 500}}}) {
          auto start = PointOnSprings::planes(phi * degree, kind.map, kind.ray);
          start.s.c.weight = 4.0;
          start.spring = spring;
          ASSERT_GE(start.solve(), 0);
          start.end_step();
          ASSERT_GE(start.solve(), 0);
          const auto run = [&](double load) {
            auto p = start;
            shift(p.target_x, {{sign * load, 0.0, 0.0}});
            const int iterations = p.solve();
            return std::make_pair(iterations, p.s.c.rule);
          };
          double low = 0.0, high = 2.0;
          for (int k = 0; k < 14; ++k) {
            const double middle = 0.5 * (low + high);
            (sticks(run(middle).second) ? low : high) = middle;
          }
          for (int k = 0; k <= 30; ++k) {
            const auto [iterations, rule] = run(low * (0.8 + 0.4 * k / 30.0));
            EXPECT_GE(iterations, 0) << int(kind.map) << kind.ray << ' ' << phi << ' ' << sign;
            most = std::max(most, iterations);
            solved += iterations >= 0;
            (sticks(rule) ? stuck : slipped) += 1;
          }
        }
  EXPECT_GT(stuck, solved / 4);
  EXPECT_GT(slipped, solved / 4);
  std::printf("  %d solves, at most %d iterations, %d stick, %d slip\n", solved, most, stuck,
              slipped);
}

// Check 12: small prescribed steps on parallel planes.
TEST(PointHistory, SteadySlidingHasNoSawTooth) {
  for (const Kind& kind : maps)
    for (const double step : {0.5, 0.1, 0.02}) {
      auto p = PointOnSprings::planes(0.0, kind.map, kind.ray);
      const double limit = 0.5 * 5.0, elastic = limit / 50.0; // mu p, mu p/eps
      double way = 0.0;
      const auto advance = [&](double sign) {
        shift(p.s.x, {{sign * step * elastic, 0.0, 0.0}});
        const PointRule rule = p.decide();
        EXPECT_NE(rule, PointRule::open);
        const double shear = p.shear()[0];
        p.end_step();
        return shear;
      };
      while (way < 6.0) {
        way += step;
        const double shear = advance(1.0);
        EXPECT_NEAR(shear, -std::min(way, 1.0) * limit, 1e-12 * limit);
      }
      // Back: the shear must come down from the cone and reach the other side after 2 mu p/eps.
      for (double back = step; back < 4.0; back += step)
        EXPECT_NEAR(advance(-1.0), std::min(back - 1.0, 1.0) * limit, 1e-11 * limit);
    }
}

// The literal map starts from no shear after each slip: teeth of 50 steps from 0 to the limit and
// one that slips by a step only.
TEST(PointHistory, LiteralMapLosesHalfTheFrictionInSmallSteps) {
  auto p = PointOnSprings::planes(0.0, Map::literal, true);
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < 10 * 51; ++k) {
    shift(p.s.x, {{0.02 * 0.05, 0.0, 0.0}});
    p.decide();
    sum -= p.shear()[0] / 2.5;
    ++count;
    p.end_step();
  }
  EXPECT_NEAR(sum / count, 0.5, 0.02); // the last stick may fall on either side of the limit
}

// Checks 7 and 15: Newton converges, and its order is two, with both faces on springs.
TEST(PointHistory, NewtonIsQuadratic) {
  for (const Kind& kind : maps)
    for (const bool slip : {false, true})
      for (const bool augmented : {false, true}) {
        auto p = PointOnSprings::planes(8.0 * degree, kind.map, kind.ray);
        p.free_secondary = true;
        p.spring = {{60.0, 60.0, 60.0}};
        p.s.c.weight = 2.0;
        for (std::size_t a = 0; a < 4; ++a) { // warp both
          p.s.x[a][2] += a % 2 ? 0.02 : -0.02;
          p.s.y[a][2] += a % 2 ? -0.05 : 0.04;
        }
        p.target_x = p.s.x;
        p.target_y = p.s.y;
        ASSERT_GE(p.solve(), 0);
        p.end_step();
        if (augmented)
          p.augment();
        shift(p.target_x, slip ? Vec3{{0.3, 0.2, 0.05}} : Vec3{{0.02, 0.01, 0.05}});
        ASSERT_GE(p.solve(1e-13), 0) << int(kind.map) << kind.ray << slip << augmented;
        ASSERT_EQ(sticks(p.s.c.rule), !slip);
        // Perturb the solution and return to it, so that no change of status interferes.
        for (std::size_t a = 0; a < 4; ++a) {
          p.s.x[a] += Vec3{{1e-3 * double(a), -1e-3, 1e-3}};
          p.s.y[a] += Vec3{{1e-3, 2e-3 * double(a), -1e-3}};
        }
        ASSERT_GE(p.solve(1e-13), 0);
        const auto& h = p.history;
        EXPECT_LE(h.size(), 6u);
        for (std::size_t k = 0; k + 1 < h.size(); ++k)
          EXPECT_LT(h[k + 1], 20.0 * h[k] * h[k] + 1e-13) << k << ' ' << h[k] << ' ' << h[k + 1];
      }
}

// Check 17: when augmentation has closed the gap the maps tell the same forces.
TEST(PointHistory, AugmentedMapsAgree) {
  std::vector<std::vector<double>> forces;
  for (const Kind kind :
       {Kind{Map::inclined, true}, Kind{Map::incremental, true}, Kind{Map::literal, true}}) {
    auto p = PointOnSprings::planes(10.0 * degree, kind.map, kind.ray);
    p.spring = {{5.0, 5.0, 5.0}};
    shift(p.target_x, {{0.5, 0.3, 0.2}});
    shift(p.s.x, {{0.05, 0.03, 0.02}});
    for (int k = 0; k < 60; ++k) {
      ASSERT_GE(p.solve(1e-13), 0) << int(kind.map) << ' ' << k;
      ASSERT_FALSE(sticks(p.s.c.rule)) << "the point must slip";
      p.augment();
    }
    EXPECT_LT(std::fabs(p.s.traction().gap), 1e-12);
    auto f = p.s.force();
    f.resize(12);
    forces.push_back(f);
  }
  EXPECT_LT(distance(forces[0], forces[2]), 1e-10);
  EXPECT_LT(distance(forces[1], forces[2]), 1e-10);
}

// The share of the slip before contact leaves no shear: a point that comes down obliquely.
TEST(PointHistory, FirstContactCountsTheSlipInContactOnly) {
  for (const Kind& kind : maps) {
    auto p = PointOnSprings::planes(0.0, kind.map, kind.ray, 0.5, 50.0, -0.3);
    p.anchored = false;
    ASSERT_EQ(p.decide(), PointRule::open);
    p.end_step();
    ASSERT_TRUE(p.s.c.first);
    shift(p.s.x, {{0.04, 0.0, 0.4}}); // .3 open, then .1 closed: a quarter of .04
    ASSERT_EQ(p.decide(), PointRule::incremental_stick);
    EXPECT_NEAR(p.shear()[0], -50.0 * 0.01, 1e-13);
    const double shear = p.shear()[0];
    p.end_step();
    p.decide();
    EXPECT_TRUE(sticks(p.s.c.rule));
    EXPECT_NEAR(p.shear()[0], shear, 1e-13) << "the next step starts from the same shear";
    EXPECT_NEAR(p.s.traction().pressure, 5.0, 1e-13);
  }
}

// The share goes to zero with the gap, from either side.
TEST(PointHistory, FirstContactShareIsContinuousInTheGap) {
  ContactPoint c;
  c.first = true;
  c.previous_gap = 0.3;
  c.penalty = 50.0;
  EXPECT_NEAR(contact_share(c, -0.1), 0.25, 1e-15);
  EXPECT_EQ(contact_share(c, 0.0), 1.0) << "just touching is held";
  c.multiplier = 5.0;
  EXPECT_NEAR(contact_share(c, -0.1), 0.25, 1e-15);
  EXPECT_NEAR(contact_share(c, -1e-9), 1e-9 / (0.3 + 1e-9), 1e-22);
  EXPECT_EQ(contact_share(c, 1e-9), 0.0);
  c.first = false;
  EXPECT_EQ(contact_share(c, 1e-9), 1.0);
}

// Augmentation in the step of first contact settles, and leaves the body where it came down.
TEST(PointHistory, AugmentingTheFirstContactKeepsTheWayBeforeIt) {
  for (const bool ray : {false, true}) {
    auto p = PointOnSprings::planes(0.0, Map::incremental, ray, 0.5, 50.0, -0.3);
    ASSERT_EQ(p.decide(), PointRule::open);
    p.end_step();
    p.spring = {{50.0, 50.0, 50.0}}; // of each node: 200 against the penalty 50
    shift(p.target_x, {{0.04, 0.0, 0.4}});
    double before = 0.0, change = 1.0, gap = 1.0;
    for (int k = 0; k < 120; ++k) {
      ASSERT_GE(p.solve(1e-13), 0);
      ASSERT_EQ(p.s.c.rule, PointRule::incremental_stick);
      const double shear = p.shear()[0];
      change = std::fabs(shear - before);
      before = shear;
      gap = std::fabs(p.s.traction().gap);
      p.augment();
    }
    EXPECT_LT(gap, 1e-9);
    EXPECT_LT(change, 1e-7);
    EXPECT_LT(before, -0.1) << "some shear there is";
    EXPECT_GT(p.s.x[0][0] + 1.0, 0.75 * 0.04) << "most of the .04 came before contact";
  }
}
