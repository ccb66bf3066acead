// SPDX-License-Identifier: BSD-3-Clause
// Augmentations that bring nothing: which cause is named.
#include "dual_scene.hpp"
#include "multipliers/plateau.hpp"

#include <gtest/gtest.h>
#include <string>

using namespace abut;
using namespace abut::contact;

namespace {

/// gaps and changes of augmentations so far, the last ones now.
struct Story {
  std::vector<double> gap, change;
  bool gap_asked = true;
  double tolerance = 1e-3; // of the change

  Judged at(std::size_t i) const {
    return {gap[i], change[i], change[i] < tolerance, !gap_asked || gap[i] < 1e-4};
  }
};

PlateauCause cause(const Story& s, const std::vector<Violation>& violations, bool dual = true,
                   const std::vector<Global>& sets = {}) {
  PlateauWatch watch(Comm(MPI_COMM_WORLD));
  for (std::size_t i = 0; i + 1 < s.gap.size(); ++i)
    watch.add(s.at(i), sets.empty() ? 1 : sets[i]);
  watch.look_anew();
  for (const Violation& v : violations)
    watch.violated(v);
  return watch.cause(s.at(s.gap.size() - 1), false, dual, false);
}

const Story slow = {{1e-2, 9e-3, 8e-3}, {0.1, 0.09, 0.08}};
const Story fast = {{1e-2, 1e-3, 2e-4}, {0.1, 0.01, 2e-3}};

} // namespace

TEST(PlateauTest, NoneWhereTheMeasureFalls) {
  EXPECT_EQ(cause(fast, {{2e-4, 1.0, true, true}}), PlateauCause::none);
  EXPECT_EQ(cause({{1e-2, 1e-2}, {0.1, 0.1}}, {}), PlateauCause::none) << "one augmentation";
  EXPECT_EQ(cause({{1e-5, 1e-5, 1e-5}, {1e-4, 1e-4, 1e-4}}, {}), PlateauCause::none) << "done";
  EXPECT_EQ(cause({{5e-7, 5e-7, 5e-7}, {1e-7, 1e-7, 1e-7}, true, 0.0}, {}), PlateauCause::none)
      << "rounding";
  Story change_falls = {{1e-2, 1e-2, 1e-2}, {0.1, 0.01, 2e-3}, false};
  EXPECT_EQ(cause(change_falls, {}), PlateauCause::none) << "nobody asks for the gap";
}

TEST(PlateauTest, NamesWhatTheDeepestPlacesShare) {
  const Violation deep = {8e-3, 1.0, false, false}, shallow = {1e-3, 9.0, true, true};
  Violation held = deep, partly = deep;
  held.held = partly.partly_covered = true;
  EXPECT_EQ(cause(slow, {held, held, deep, shallow}), PlateauCause::held_nodes);
  EXPECT_EQ(cause(slow, {partly, partly, deep, shallow}), PlateauCause::partly_covered);
  EXPECT_EQ(cause(slow, {deep, deep, held, shallow}), PlateauCause::stiff_primary);
  EXPECT_EQ(cause(slow, {deep, deep, held, shallow}, false), PlateauCause::short_waves);
  Story settles = slow;
  settles.change = {0.1, 0.01, 2e-3};
  EXPECT_EQ(cause(settles, {deep}), PlateauCause::unknown);
}

TEST(PlateauTest, SetsThatComeBack) {
  const Story story = {{1e-2, 9e-3, 9e-3, 9e-3, 9e-3, 9e-3}, {.1, .1, .1, .1, .1, .1}};
  EXPECT_EQ(cause(story, {}, true, {1, 2, 1, 2, 2}), PlateauCause::changing_set);
  EXPECT_EQ(cause(story, {}, true, {1, 2, 3, 3, 3}), PlateauCause::stiff_primary);
  EXPECT_EQ(cause(story, {}, true, {1, 1, 1, 1, 1}), PlateauCause::stiff_primary);
}

// The pair is moved to and fro between augmentations: the second time that a set comes back its
// multipliers go half of the way.
TEST(PlateauTest, SetsThatComeBackTakeHalfSteps) {
  ContactOptions o;
  o.penalty = 7.0;
  o.multipliers = Multipliers::per_point;
  o.enforcement = Enforcement::augmented_lagrangian;
  abut::contact::testing::DualScene scene(fem::FaceType::quad4, fem::FaceType::quad4, o, 0.02);
  const auto at = [&](double z) {
    scene.move(0.0, {{0.0, 0.0, z}});
    scene.system.evaluate(*scene.pair, false);
    scene.pair->iterate_taken(); // until then the status is held
    scene.system.evaluate(*scene.pair, false);
    return scene.pair->summary().active_points;
  };
  const auto way = [&] { // that the multipliers go, over the way to the pressures
    std::vector<double> multiplier, pressure;
    for (const Site& p : scene.pair->points().sites()) {
      multiplier.push_back(p.multiplier);
      pressure.push_back(p.state.pressure);
    }
    scene.pair->augment();
    double moved = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < multiplier.size(); ++i) {
      moved += std::fabs(scene.pair->points().sites()[i].multiplier - multiplier[i]);
      whole += std::fabs(pressure[i] - multiplier[i]);
    }
    EXPECT_GT(whole, 0.01);
    return moved / whole;
  };
  const Global low = at(0.0);
  EXPECT_NEAR(way(), 1.0, 1e-12);
  EXPECT_LT(at(0.4), low);
  EXPECT_NEAR(way(), 1.0, 1e-12);
  EXPECT_EQ(at(0.0), low);
  EXPECT_NEAR(way(), 1.0, 1e-12);
  at(0.4);
  EXPECT_NEAR(way(), 0.5, 1e-12);
}

TEST(PlateauTest, EveryCauseHasWords) {
  EXPECT_EQ(std::string(describe(PlateauCause::none)), "");
  for (const PlateauCause c :
       {PlateauCause::held_nodes, PlateauCause::partly_covered, PlateauCause::changing_set,
        PlateauCause::stiff_primary, PlateauCause::short_waves, PlateauCause::unknown})
    EXPECT_GT(std::string(describe(c)).size(), 20u);
}
