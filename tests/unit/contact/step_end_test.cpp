// SPDX-License-Identifier: BSD-3-Clause
// uzawa: end_of_step, where multipliers change once at the end of a step, in every space.
#include "dual_scene.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using fem::FaceType;

namespace {

ContactOptions options(Multipliers space, Formulation formulation, double friction) {
  ContactOptions o;
  o.penalty = 7.0;
  o.multipliers = space;
  o.formulation = formulation;
  o.friction = friction;
  o.enforcement = Enforcement::augmented_lagrangian;
  o.uzawa = Uzawa::end_of_step;
  return o;
}

struct StepEnd : ::testing::TestWithParam<std::tuple<Multipliers, Formulation, double>> {
  StepEnd()
      : scene(FaceType::quad4, FaceType::quad4,
              options(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())),
              0.06, 3, 0.03) {}

  double force() {
    scene.system.evaluate(*scene.pair, false);
    double sum = 0.0;
    for (Local n = 0; n < scene.upper.num_nodes(); ++n)
      sum -= scene.system.residual[std::size_t(3 * n + 2)];
    return sum;
  }
  DualScene scene;
};

struct ShearAtStepEnd : StepEnd {};

auto cases(const std::vector<double>& frictions) {
  return ::testing::Combine(
      ::testing::Values(Multipliers::per_point, Multipliers::smoothed, Multipliers::dual),
      ::testing::Values(Formulation::facet_on_facet, Formulation::sliding_elastic),
      ::testing::ValuesIn(frictions));
}

INSTANTIATE_TEST_SUITE_P(Spaces, StepEnd, cases({0.0, 0.3}));
INSTANTIATE_TEST_SUITE_P(Spaces, ShearAtStepEnd, cases({0.3}));

} // namespace

// At the same place the springs press once more on top of what they pressed: exactly so where each
// point or node has its own law, up to the average with smoothed ones.
TEST_P(StepEnd, PressuresBecomeMultipliers) {
  scene.move(0.0, {{0.0, 0.0, -0.02}});
  const double first = force();
  ASSERT_GT(first, 0.01);
  const ContactSummary before = scene.pair->summary();
  scene.pair->accept();
  const ContactSummary after = scene.pair->summary();
  EXPECT_DOUBLE_EQ(after.penalty_energy, before.penalty_energy); // of the step that has ended
  EXPECT_DOUBLE_EQ(after.max_point_pressure, before.max_point_pressure);
  EXPECT_GT(after.penalty_energy, 0.0);
  const double tolerance =
      std::get<0>(GetParam()) == Multipliers::smoothed ? 0.05 * first : 1e-12 * first;
  EXPECT_NEAR(force(), 2.0 * first, tolerance);
}

TEST_P(StepEnd, RejectedStepLeavesThem) {
  scene.move(0.0, {{0.0, 0.0, -0.02}});
  force();
  scene.pair->accept();
  const double second = force();
  scene.move(0.01, {{0.01, 0.0, -0.05}});
  force();
  scene.pair->reject();
  scene.move(0.0, {{0.0, 0.0, -0.02}});
  EXPECT_DOUBLE_EQ(force(), second);
}

// What sticks keeps its shear, what slips stays on its cone: no motion, no other shear.
TEST_P(ShearAtStepEnd, OfAStandingPairStays) {
  scene.move(0.0, {{0.0, 0.0, -0.02}});
  force();
  scene.pair->accept();
  scene.move(0.0, {{0.004, 0.0, -0.02}});
  force();
  const double tangential = scene.pair->summary().tangential;
  EXPECT_GT(tangential, 1e-4);
  scene.pair->accept();
  force();
  EXPECT_GE(scene.pair->summary().tangential, 0.99 * tangential);
}

// Points that are tied keep what they hold along the surface too.
TEST(TiedStepEnd, WholeTractionBecomesMultiplier) {
  for (const Formulation formulation :
       {Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    ContactOptions o = options(Multipliers::per_point, formulation, 0.0);
    o.tied = true;
    const double overlap = formulation == Formulation::facet_on_facet ? 0.0 : 0.02;
    DualScene scene(FaceType::quad4, FaceType::quad4, o, overlap, 3, 0.0);
    const auto forces = [&] {
      scene.system.evaluate(*scene.pair, false);
      Vec3 sum = Vec3::zero();
      for (Local n = 0; n < scene.upper.num_nodes(); ++n)
        for (int i = 0; i < 3; ++i)
          sum[i] -= scene.system.residual[std::size_t(3 * n + i)];
      return sum;
    };
    forces();
    scene.move(0.0, {{0.01, 0.0, 0.005}});
    const Vec3 first = forces();
    ASSERT_LT(first[0], -0.01);
    ASSERT_LT(first[2], -0.01);
    scene.pair->accept();
    const Vec3 second = forces();
    for (int i : {0, 2})
      EXPECT_NEAR(second[i], 2.0 * first[i], 1e-12);
  }
}
