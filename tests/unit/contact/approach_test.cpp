// SPDX-License-Identifier: BSD-3-Clause
// Springs as soft as the bodies, at points, where a step starts from a deep overlap.
#include "abut_test/same_values.hpp"
#include "dual_scene.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut_test::same_values;

namespace {

constexpr double modulus = 2.0, inverse_depth = 3.0; ///< E, A/V: springs of E A/V = 6
constexpr double soft = modulus * inverse_depth;

struct Approach : ::testing::TestWithParam<std::tuple<Multipliers, double>> {
  static ContactOptions options(double penalty, Multipliers multipliers) {
    ContactOptions o;
    o.name = "pair";
    o.penalty = penalty;
    o.enforcement = Enforcement::augmented_lagrangian;
    o.multipliers = multipliers;
    o.friction = std::get<1>(GetParam());
    return o;
  }
  /// A scene between bodies that are elastic.
  static std::unique_ptr<DualScene> scene(double penalty,
                                          Multipliers multipliers = std::get<0>(GetParam())) {
    const ContactOptions given = options(penalty, multipliers);
    auto s = std::make_unique<DualScene>(fem::FaceType::quad4, fem::FaceType::quad4, given, 0.05);
    for (mesh::Surface* side : {&s->upper, &s->lower}) {
      side->modulus.assign(side->type.size(), modulus);
      side->inverse_depth.assign(side->type.size(), inverse_depth);
    }
    s->pair =
        std::make_unique<Interaction>(Comm(MPI_COMM_WORLD), s->upper, s->lower, given, s->timers);
    return s;
  }
  /// The same with the law at points.
  static std::unique_ptr<DualScene> at_points(double penalty) {
    return scene(penalty, Multipliers::per_point);
  }
  static std::vector<double> residual(DualScene& s) {
    s.system.evaluate(*s.pair, false);
    return s.system.residual;
  }
};

TEST_P(Approach, HasPointsOnSpringsAsSoftAsTheBodiesUntilItEnds) {
  const auto stiff = scene(40.0 * soft), same = at_points(soft);
  const std::vector<double> before = residual(*stiff);
  EXPECT_TRUE(stiff->pair->overloaded());
  stiff->pair->begin_solve(SolveKind::approach);
  const std::vector<double> during = residual(*stiff), expected = residual(*same);
  EXPECT_FALSE(same->pair->overloaded());
  EXPECT_FALSE(stiff->pair->overloaded());
  double most = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(during[i], expected[i], 1e-14);
    most = std::max(most, std::fabs(before[i] - during[i]));
  }
  EXPECT_GT(most, 1e-2);
  stiff->pair->begin_solve(SolveKind::newton);
  EXPECT_TRUE(same_values(residual(*stiff), before));
}

TEST_P(Approach, LandsWithTheLawAtPointsOnItsOwnSprings) {
  const bool nodal = std::get<0>(GetParam()) == Multipliers::dual;
  const auto s = scene(40.0 * soft), same = at_points(40.0 * soft);
  const std::vector<double> before = residual(*s);
  EXPECT_EQ(s->pair->lands(), nodal);
  s->pair->begin_solve(SolveKind::landing);
  const std::vector<double> during = residual(*s), expected = residual(*same);
  double most = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(during[i], expected[i], 1e-12);
    most = std::max(most, std::fabs(before[i] - during[i]));
  }
  EXPECT_EQ(most > 1e-3, nodal);
  s->pair->begin_solve(SolveKind::newton);
  const std::vector<double> after = residual(*s); // the search has started anew
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i], before[i], 1e-13);
}

TEST_P(Approach, EvaluationElsewhereLeavesNoTrace) {
  const auto s = scene(40.0 * soft);
  residual(*s);
  s->pair->iterate_taken();
  s->pair->begin_solve(SolveKind::approach);
  const std::vector<double> u = s->system.u;
  s->system.evaluate(*s->pair, true);
  const std::vector<double> tangent = s->system.tangent, before = s->system.residual;
  for (const double shift : {0.3, -0.05}) {
    for (std::size_t i = 0; i < u.size(); ++i)
      s->system.u[i] = u[i] + shift * std::sin(double(i));
    s->system.evaluate(*s->pair, true);
    EXPECT_NE(s->system.residual, before);
  }
  s->system.u = u;
  s->system.evaluate(*s->pair, true);
  EXPECT_TRUE(same_values(s->system.residual, before));
  EXPECT_TRUE(same_values(s->system.tangent, tangent));
}

TEST_P(Approach, IsForContactThatWasNotThereAtTheLastStep) {
  const auto s = scene(40.0 * soft);
  residual(*s);
  ASSERT_TRUE(s->pair->overloaded());
  s->pair->accept();
  s->pair->begin_step();
  residual(*s);
  EXPECT_FALSE(s->pair->overloaded()); // bodies that bear such a pressure did so before
}

TEST_P(Approach, LeavesSofterSpringsAlone) {
  const auto s = scene(0.5 * soft), same = at_points(0.5 * soft);
  s->pair->begin_solve(SolveKind::approach);
  EXPECT_TRUE(same_values(residual(*s), residual(*same)));
}

INSTANTIATE_TEST_SUITE_P(Spaces, Approach,
                         ::testing::Combine(::testing::Values(Multipliers::per_point,
                                                              Multipliers::smoothed,
                                                              Multipliers::dual),
                                            ::testing::Values(0.0, 0.3)));

} // namespace
