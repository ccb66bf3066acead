// SPDX-License-Identifier: BSD-3-Clause
// Contact that begins late and ends early.
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
  return o;
}

ContactOptions in_window(ContactOptions o) {
  o.window = {1.0, 2.0};
  return o;
}

struct ContactWindow : ::testing::TestWithParam<std::tuple<Multipliers, Formulation, double>> {
  ContactWindow()
      : o(options(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam()))),
        always(FaceType::quad4, FaceType::quad4, o, 0.06, 3, 0.03),
        late(FaceType::quad4, FaceType::quad4, in_window(o), 0.06, 3, 0.03) {}

  static const std::vector<double>& forces(DualScene& scene, double t) {
    scene.system.evaluate(*scene.pair, false, t);
    return scene.system.residual;
  }
  static double largest(const std::vector<double>& f) {
    double most = 0.0;
    for (const double x : f)
      most = std::max(most, std::fabs(x));
    return most;
  }
  /// Brings both to the place where one starts and the other does so later.
  void begin() {
    for (DualScene* scene : {&always, &late})
      scene->move(0.003, {{0.0, 0.0, 0.01}});
    forces(always, 0.5);
    EXPECT_EQ(largest(forces(late, 0.5)), 0.0);
    EXPECT_EQ(late.pair->connectivity().cells(), 0);
    EXPECT_EQ(late.pair->candidates().cells(), 0);
    EXPECT_FALSE(late.pair->acts());
    late.pair->accept();
  }
  void expect_same(double t) {
    const std::vector<double> expected = forces(always, t);
    EXPECT_GT(largest(expected), 1e-3);
    const std::vector<double>& found = forces(late, t);
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(found[i], expected[i], 1e-13);
  }
  void move_on(double x) {
    for (DualScene* scene : {&always, &late})
      scene->move(0.004, {{x, 0.0, -0.01}});
  }

  ContactOptions o;
  DualScene always, late;
};

INSTANTIATE_TEST_SUITE_P(
    Spaces, ContactWindow,
    ::testing::Combine(::testing::Values(Multipliers::per_point, Multipliers::smoothed,
                                         Multipliers::dual),
                       ::testing::Values(Formulation::facet_on_facet, Formulation::sliding_elastic),
                       ::testing::Values(0.0, 0.3)));

} // namespace

TEST_P(ContactWindow, StartsFromTheLastConvergedPlace) {
  begin();
  move_on(0.004);
  expect_same(1.5);
  for (DualScene* scene : {&always, &late}) {
    scene->pair->augmentation();
    scene->pair->augment();
  }
  expect_same(1.5);
  for (DualScene* scene : {&always, &late})
    scene->pair->accept();
  move_on(0.012);
  expect_same(2.0);
}

TEST_P(ContactWindow, CutStepsLeaveNothing) {
  begin();
  late.move(0.02, {{0.05, 0.0, -0.03}});
  EXPECT_GT(largest(forces(late, 1.5)), 1e-3);
  late.pair->reject();
  move_on(0.004);
  expect_same(1.25);
  for (DualScene* scene : {&always, &late})
    scene->pair->accept();
  move_on(0.008);
  EXPECT_EQ(largest(forces(late, 2.5)), 0.0); // beyond the end, but this step is cut too
  late.pair->reject();
  expect_same(1.75);
}

TEST_P(ContactWindow, EndsWithoutATrace) {
  begin();
  move_on(0.03);
  expect_same(1.5);
  late.pair->accept();
  const double dissipated = late.pair->summary().dissipation;
  EXPECT_EQ(dissipated > 0.0, o.friction > 0.0);
  EXPECT_EQ(largest(forces(late, 2.5)), 0.0);
  late.pair->accept();
  EXPECT_EQ(late.pair->summary().active_points, 0);
  EXPECT_DOUBLE_EQ(late.pair->summary().dissipation, dissipated);
  EXPECT_EQ(late.pair->augmentation().change, 0.0);
  // As new: it begins like one that begins for the first time.
  DualScene fresh(FaceType::quad4, FaceType::quad4, in_window(o), 0.06, 3, 0.03);
  for (DualScene* scene : {&fresh, &late}) {
    scene->move(0.003, {{0.0, 0.0, 0.01}});
    forces(*scene, 0.5);
    scene->pair->accept();
    scene->move(0.004, {{0.004, 0.0, -0.01}});
  }
  const std::vector<double> expected = forces(fresh, 1.5);
  const std::vector<double>& found = forces(late, 1.5);
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_NEAR(found[i], expected[i], 1e-13);
}
