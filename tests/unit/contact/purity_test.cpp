// SPDX-License-Identifier: BSD-3-Clause
// A residual is a function of unknowns, history and iterate state: whatever is evaluated between
// two events leaves no trace, bit for bit.
#include "abut_test/same_values.hpp"
#include "dual_scene.hpp"

#include <gtest/gtest.h>
#include <string>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut_test::same_values;

namespace {

struct Kind {
  Formulation formulation;
  Multipliers multipliers;
  FrictionMap map;
  FrictionSwitching switching;
  double friction;
};

std::vector<Kind> kinds() {
  std::vector<Kind> list;
  for (const Formulation f :
       {Formulation::node_on_facet, Formulation::facet_on_facet, Formulation::sliding_elastic})
    for (const FrictionSwitching s :
         {FrictionSwitching::primal_dual, FrictionSwitching::return_map})
      for (const Multipliers m :
           {Multipliers::per_point, Multipliers::smoothed, Multipliers::dual}) {
        for (const double friction : {0.0, 0.3})
          list.push_back({f, m, FrictionMap::incremental, s, friction});
        if (f == Formulation::sliding_elastic && m != Multipliers::dual)
          for (const FrictionMap map : {FrictionMap::inclined_ray, FrictionMap::literal})
            list.push_back({f, m, map, s, 0.3});
      }
  return list;
}

class Purity : public ::testing::TestWithParam<Kind> {
protected:
  Purity() : scene(fem::FaceType::quad4, fem::FaceType::quad4, options(), 0.05, 3, 0.04, 0.2) {
    scene.pair->set_exact_tangent(false);
    // A step that ends in contact, and an iterate of the next one with points in every state.
    at(0, false);
    scene.pair->accept();
    at(1, true);
    scene.pair->iterate_taken();
  }

  static ContactOptions options() {
    const Kind k = GetParam();
    ContactOptions o;
    o.penalty = 20.0;
    o.formulation = k.formulation;
    o.enforcement = Enforcement::augmented_lagrangian;
    o.multipliers = k.multipliers;
    o.friction = k.friction;
    o.friction_map = k.map;
    o.friction_switching = k.switching;
    return o;
  }

  /// Residual, or tangent, at one of a few configurations.
  std::vector<double> at(int place, bool tangent) {
    const Vec3 shift[] = {{{0.0, 0.0, 0.0}},   {{0.02, 0.01, -0.01}}, {{0.05, 0.03, -0.02}},
                          {{0.3, -0.2, 0.03}}, {{0.02, 0.0, -0.3}},   {{0.0, 0.0, 2.0}}};
    scene.move(0.01, shift[place], 0.3 * place);
    scene.system.evaluate(*scene.pair, tangent);
    return tangent ? scene.system.tangent : scene.system.residual;
  }

  double largest(const std::vector<double>& v) const {
    double most = 0.0;
    for (double x : v)
      most = std::max(most, std::fabs(x));
    return most;
  }

  DualScene scene;
};

std::string name(const ::testing::TestParamInfo<Kind>& info) {
  return "kind_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Purity, ::testing::ValuesIn(kinds()), name);

} // namespace

TEST_P(Purity, EvaluationElsewhereLeavesNoTrace) {
  const std::vector<double> before = at(2, false);
  EXPECT_GT(largest(before), 1e-3);
  for (int elsewhere : {3, 4, 5, 4, 3, 0})
    at(elsewhere, false);
  EXPECT_TRUE(same_values(at(2, false), before));
}

TEST_P(Purity, TangentsLeaveNoTrace) {
  const std::vector<double> tangent = at(2, true), residual = scene.system.residual;
  EXPECT_GT(largest(tangent), 1e-3);
  EXPECT_TRUE(same_values(at(2, true), tangent)) << "a second tangent";
  at(3, true); // of a trial that is rejected
  EXPECT_TRUE(same_values(at(2, false), residual));
  EXPECT_TRUE(same_values(at(2, true), tangent));
}

TEST_P(Purity, HoldsInEverySolve) {
  for (const SolveKind kind :
       {SolveKind::prediction, SolveKind::newton, SolveKind::after_augmentation}) {
    scene.pair->begin_solve(kind);
    const std::vector<double> tangent = at(2, true), residual = scene.system.residual;
    EXPECT_GT(largest(residual), 1e-3);
    for (int elsewhere : {3, 4, 5})
      at(elsewhere, elsewhere == 4);
    EXPECT_TRUE(same_values(at(2, true), tangent));
    EXPECT_TRUE(same_values(scene.system.residual, residual));
  }
}

// As the check of a tangent does: both sides of the state, then the state again.
TEST_P(Purity, DifferencesLeaveNoTrace) {
  const std::vector<double> before = at(2, false);
  const std::vector<double> u = scene.system.u;
  for (const double side : {1e-7, -1e-7}) {
    for (std::size_t i = 0; i < u.size(); ++i)
      scene.system.u[i] = u[i] + side * std::sin(double(i));
    scene.system.evaluate(*scene.pair, false);
  }
  scene.system.u = u;
  scene.system.evaluate(*scene.pair, true);
  EXPECT_TRUE(same_values(scene.system.residual, before));
}

// Judging is no event either; augmenting is one.
TEST_P(Purity, JudgingLeavesNoTrace) {
  const std::vector<double> before = at(2, false);
  scene.pair->augmentation();
  at(3, false);
  scene.pair->augmentation();
  EXPECT_TRUE(same_values(at(2, false), before));
  const long version = scene.pair->state_version();
  scene.pair->augment();
  EXPECT_GT(scene.pair->state_version(), version);
  EXPECT_NE(at(2, false), before);
}

// The path to an iterate does not matter, what was taken on it does.
TEST_P(Purity, EventsAreAllThatIsRemembered) {
  DualScene other(fem::FaceType::quad4, fem::FaceType::quad4, options(), 0.05, 3, 0.04, 0.2);
  other.pair->set_exact_tangent(false);
  std::swap(scene.pair, other.pair); // the same story with trials between the events
  at(0, false);
  scene.pair->accept();
  for (int trial : {4, 2, 3})
    at(trial, true);
  at(1, true);
  scene.pair->iterate_taken();
  at(5, false);
  const std::vector<double> with_trials = at(2, false);
  std::swap(scene.pair, other.pair);
  EXPECT_TRUE(same_values(at(2, false), with_trials));
}
