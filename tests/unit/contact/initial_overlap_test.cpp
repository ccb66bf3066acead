// SPDX-License-Identifier: BSD-3-Clause
// An overlap at the start means the same at points and at nodes, on surfaces that do not match:
// what is adjusted presses nowhere, what is resolved grows from nothing to what is kept.
#include "dual_scene.hpp"

#include <gtest/gtest.h>
#include <tuple>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut::contact::testing::Faces;

namespace {

using Case = std::tuple<Faces, Multipliers>;

class InitialOverlaps : public ::testing::TestWithParam<Case> {
protected:
  /// Wavy surfaces that overlap in part; size of all nodal forces at t, without moving anything.
  static double force(InitialOverlap treatment, double t, double offset = 0.0) {
    ContactOptions o = abut::contact::testing::options(std::get<0>(GetParam()));
    o.multipliers = std::get<1>(GetParam());
    o.initial_overlap = treatment;
    o.initial_gap = InitialGap::mesh; // else resolved surfaces are round, kept ones are not
    o.offset = offset;
    DualScene scene(std::get<0>(GetParam()).primary, std::get<0>(GetParam()).secondary, o, 0.01);
    scene.system.evaluate(*scene.pair, false, 0.0);
    scene.system.evaluate(*scene.pair, false, t);
    double sum = 0.0;
    for (const double f : scene.system.residual)
      sum += f * f;
    return std::sqrt(sum);
  }
};
INSTANTIATE_TEST_SUITE_P(
    Cases, InitialOverlaps,
    ::testing::Combine(::testing::ValuesIn(abut::contact::testing::all_faces()),
                       ::testing::Values(Multipliers::per_point, Multipliers::smoothed,
                                         Multipliers::dual)));

} // namespace

TEST_P(InitialOverlaps, AreResolvedFromNothingToAll) {
  const double kept = force(InitialOverlap::keep, 0.0);
  ASSERT_GT(kept, 1e-3);
  EXPECT_LT(force(InitialOverlap::resolve, 0.0), 1e-13);
  EXPECT_NEAR(force(InitialOverlap::resolve, 0.25), 0.25 * kept, 1e-12);
  EXPECT_NEAR(force(InitialOverlap::resolve, 1.0), kept, 1e-12);
}

TEST_P(InitialOverlaps, AreAdjustedForGood) {
  EXPECT_LT(force(InitialOverlap::adjust, 0.0), 1e-13);
  EXPECT_LT(force(InitialOverlap::adjust, 1.0), 1e-13);
}

TEST_P(InitialOverlaps, AnOffsetIsResolvedToo) {
  const double kept = force(InitialOverlap::keep, 0.0, 0.02);
  EXPECT_LT(force(InitialOverlap::resolve, 0.0, 0.02), 1e-13);
  EXPECT_NEAR(force(InitialOverlap::resolve, 0.5, 0.02), 0.5 * kept, 1e-12);
  EXPECT_NEAR(force(InitialOverlap::resolve, 1.0, 0.02), kept, 1e-12);
}

class Starts : public ::testing::TestWithParam<Case> {
protected:
  /// Gaps of all sites that take part at t, without moving anything, of wavy surfaces that overlap
  /// in part.
  static std::vector<double> gaps(ContactOptions o, double t,
                                  std::function<double(double)> interference = {}) {
    o.formulation = std::get<0>(GetParam()).formulation;
    o.multipliers = std::get<1>(GetParam());
    o.penalty = 7.0;
    DualScene scene(std::get<0>(GetParam()).primary, std::get<0>(GetParam()).secondary, o, 0.01);
    scene.pair->set_schedules({}, {}, std::move(interference));
    scene.system.evaluate(*scene.pair, false, 0.0);
    scene.system.evaluate(*scene.pair, false, t);
    std::vector<double> list;
    for (const Site& site : scene.pair->points().sites())
      if (site.area > 0.0)
        list.push_back(site.gap);
    return list;
  }
};
INSTANTIATE_TEST_SUITE_P(
    Cases, Starts,
    ::testing::Combine(::testing::ValuesIn(abut::contact::testing::all_faces()),
                       ::testing::Values(Multipliers::per_point, Multipliers::smoothed,
                                         Multipliers::dual)));

TEST_P(Starts, AnInterferenceIsThatOfEverySiteThatIsNear) {
  const double within = 0.02, offset = 0.004;
  ContactOptions o;
  o.offset = offset;
  const std::vector<double> meshes = gaps(o, 0.0);
  o.fit_within = within;
  for (const double value : {0.03, -0.01}) {
    o.interference = value;
    const std::vector<double> half = gaps(o, 0.5), whole = gaps(o, 1.0),
                              given = gaps(o, 0.5, [](double t) { return 3.0 * t; });
    int fits = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const bool near = std::fabs(meshes[i]) <= within;
      fits += near;
      EXPECT_NEAR(half[i], near ? -0.5 * value : meshes[i], 1e-13);
      EXPECT_NEAR(whole[i], near ? -value : meshes[i], 1e-13);
      EXPECT_NEAR(given[i], near ? -1.5 * value : meshes[i], 1e-13);
    }
    EXPECT_GT(fits, 0);
    EXPECT_LT(fits, int(meshes.size()));
  }
}

TEST_P(Starts, SmallGapsAreClosedAndNothingElse) {
  ContactOptions o;
  o.initial_overlap = InitialOverlap::keep;
  const std::vector<double> meshes = gaps(o, 0.0);
  o.initial_gap = InitialGap::close;
  o.fit_within = 0.015;
  const std::vector<double> closed = gaps(o, 1.0);
  o.initial_overlap = InitialOverlap::adjust;
  const std::vector<double> adjusted = gaps(o, 1.0);
  int shifted = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const bool small = meshes[i] > 0.0 && meshes[i] <= *o.fit_within;
    shifted += small;
    EXPECT_NEAR(closed[i], small ? 0.0 : meshes[i], 1e-13);
    EXPECT_NEAR(adjusted[i], small ? 0.0 : std::max(0.0, meshes[i]), 1e-13);
  }
  EXPECT_GT(shifted, 0);
  EXPECT_LT(shifted, int(meshes.size()));
}

/// Flat plates of area 1 whose meshes overlap by `overlap`.
TEST(InitialOverlap, AnOffsetIsNotAdjusted) {
  for (const Multipliers space : {Multipliers::per_point, Multipliers::smoothed, Multipliers::dual})
    for (const double overlap : {0.0, 0.02, -0.03}) {
      ContactOptions o;
      o.name = "pair";
      o.penalty = 100.0;
      o.offset = 0.05;
      o.multipliers = space;
      o.initial_overlap = InitialOverlap::adjust;
      DualScene plates(fem::FaceType::quad4, fem::FaceType::quad4, o, overlap, 3, 0.0);
      plates.system.evaluate(*plates.pair, false, 0.0);
      const double closed = o.offset + std::min(overlap, 0.0); // gaps stay as they are
      EXPECT_NEAR(plates.pair->summary().force[2], 100.0 * closed, 1e-11);
      EXPECT_NEAR(plates.pair->summary().initial_overlap, std::max(overlap, 0.0), 1e-14);
      EXPECT_NEAR(plates.pair->summary().max_penetration, closed, 1e-12);
    }
}

TEST(InitialOverlap, ATieOfRoundSurfacesStrainsNothing) {
  for (const Formulation f : {Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    ContactOptions o;
    o.name = "pair";
    o.penalty = 100.0;
    o.formulation = f;
    o.offset = 0.01;
    o.tied = true;
    o.tie_distance = 1.0;
    o.multipliers = Multipliers::per_point;
    o.initial_gap = InitialGap::round;
    DualScene scene(fem::FaceType::quad4, fem::FaceType::quad4, o, 0.01, 3, 0.1);
    scene.system.evaluate(*scene.pair, false, 0.0);
    EXPECT_GT(scene.pair->summary().active_points, 0);
    EXPECT_GT(scene.pair->summary().facet_rise, 1e-4);
    for (const double force : scene.system.residual)
      EXPECT_NEAR(force, 0.0, 1e-13);
  }
}
