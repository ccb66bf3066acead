// SPDX-License-Identifier: BSD-3-Clause
// Formulations, friction over steps and the options of an interface, on plates moved by hand.
#include "abut/contact/interaction.hpp"
#include "abut/core/error.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;
using abut_test::DenseSystem;
using abut_test::grid_surface;
using contact::Formulation;
using contact::FrictionMap;

namespace {

contact::ContactOptions with_penalty(double penalty) {
  contact::ContactOptions o;
  o.name = "pair";
  o.penalty = penalty;
  return o;
}

/// A plate of area 1 with 2 x 2 faces over a plane of 5 x 5, both flat and moved by hand.
struct Plates {
  explicit Plates(const contact::ContactOptions& options, double gap = 0.0)
      : upper(grid_surface(2, 2, 0, 1, 0, 1, true, 0, [&](double* x) { x[2] = gap; })),
        system(9 + 36, 3), pair(std::make_unique<contact::Interaction>(Comm(MPI_COMM_WORLD), upper,
                                                                       lower, options, timers)) {}

  /// Force on the plate when it stands at (x, y, z) from its start.
  Vec3 force(double x, double y, double z, double time = 1.0) {
    for (std::size_t a = 0; a < 9; ++a) {
      system.u[3 * a] = x;
      system.u[3 * a + 1] = y;
      system.u[3 * a + 2] = z;
    }
    system.evaluate(*pair, false, time);
    Vec3 sum = Vec3::zero();
    for (std::size_t a = 0; a < 9; ++a)
      for (int i = 0; i < 3; ++i)
        sum[i] -= system.residual[3 * a + std::size_t(i)];
    return sum;
  }

  mesh::Surface upper;
  mesh::Surface lower = grid_surface(5, 5, -2, 3, -2, 3, false, 9, {}, 100);
  PhaseTimers timers;
  DenseSystem system;
  std::unique_ptr<contact::Interaction> pair;
};

struct Law {
  Formulation formulation;
  FrictionMap map;
  contact::Enforcement enforcement = contact::Enforcement::penalty;
};

contact::ContactOptions with_friction(const Law& law) {
  contact::ContactOptions o = with_penalty(100.0);
  o.formulation = law.formulation;
  o.friction_map = law.map;
  o.enforcement = law.enforcement;
  o.friction = 0.5;
  return o;
}

class Friction : public testing::TestWithParam<Law> {};
INSTANTIATE_TEST_SUITE_P(
    Laws, Friction,
    testing::Values(Law{Formulation::node_on_facet, FrictionMap::automatic},
                    Law{Formulation::facet_on_facet, FrictionMap::automatic},
                    Law{Formulation::sliding_elastic, FrictionMap::inclined_ray},
                    Law{Formulation::sliding_elastic, FrictionMap::incremental}));

} // namespace

// Pressed by 0.01 (force 1), the elastic slip at the cone is 0.005.
TEST_P(Friction, SticksElasticallyThenSlipsOnTheCone) {
  Plates plates(with_friction(GetParam()));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->accept();
  Vec3 f = plates.force(0.003, 0.0, -0.01);
  EXPECT_NEAR(f[2], 1.0, 1e-12);
  EXPECT_NEAR(f[0], -0.3, 1e-12);
  EXPECT_EQ(plates.pair->summary().stick_points, plates.pair->summary().points);
  plates.pair->accept();
  f = plates.force(0.2, 0.0, -0.01);
  EXPECT_NEAR(f[0], -0.5, 1e-12);
  EXPECT_EQ(plates.pair->summary().slip_points, plates.pair->summary().points);
  plates.pair->accept();
  EXPECT_NEAR(plates.pair->summary().max_slip, 0.195, 1e-12);
  EXPECT_NEAR(plates.pair->summary().dissipation, 0.5 * 0.195, 1e-12);
  f = plates.force(0.197, 0.0, -0.01); // back within the elastic range: from -0.5 by 0.3
  EXPECT_NEAR(f[0], -0.2, 1e-12);
  EXPECT_EQ(plates.pair->summary().stick_points, plates.pair->summary().points);
}

TEST_P(Friction, AnsweringForceIsAgainstTheSlip) {
  Plates plates(with_friction(GetParam()));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->accept();
  const double angle = 37.0 / 180.0 * std::acos(-1.0);
  const Vec3 f = plates.force(0.1 * std::cos(angle), 0.1 * std::sin(angle), -0.01);
  EXPECT_NEAR(f[0], -0.5 * std::cos(angle), 1e-12);
  EXPECT_NEAR(f[1], -0.5 * std::sin(angle), 1e-12);
}

TEST_P(Friction, HeldShearDoesNotCreep) {
  Plates plates(with_friction(GetParam()));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->accept();
  const double start = plates.force(0.0025, 0.0, -0.01)[0];
  plates.pair->accept();
  double now = start;
  for (int step = 0; step < 100; ++step) {
    now = plates.force(0.0025, 0.0, -0.01)[0];
    plates.pair->accept();
  }
  EXPECT_NEAR(start, -0.25, 1e-12);
  EXPECT_NEAR(now, start, 1e-13);
}

TEST_P(Friction, RejectedStepsLeaveNothing) {
  Plates plates(with_friction(GetParam()));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->accept();
  const Vec3 first = plates.force(0.003, 0.001, -0.01);
  plates.force(0.4, -0.3, -0.02); // slips over other faces
  plates.pair->augment();
  plates.force(0.5, 0.2, 0.1); // opens
  plates.pair->reject();
  const Vec3 again = plates.force(0.003, 0.001, -0.01);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(first[i], again[i],
                1e-13); // the search starts afresh: rounding of x times the penalty
}

// A point that comes into contact on the way has slipped in contact for a part of the step only.
TEST_P(Friction, FirstContactShearsByItsShareOfTheStep) {
  Plates plates(with_friction(GetParam()), 0.03);
  plates.force(0.0, 0.0, 0.0);
  plates.pair->accept();
  EXPECT_EQ(plates.pair->summary().active_points, 0);
  const Vec3 f = plates.force(0.004, 0.0, -0.04); // a quarter of the way in contact
  EXPECT_NEAR(f[2], 1.0, 1e-12);
  EXPECT_NEAR(f[0], -0.1, 1e-12);
  plates.pair->accept();
  EXPECT_NEAR(plates.force(0.004, 0.0, -0.04)[0], -0.1, 1e-12); // and stays
  EXPECT_NEAR(plates.force(0.005, 0.0, -0.04)[0], -0.2, 1e-12);
}

TEST_P(Friction, AugmentationTakesAwayTheElasticSlip) {
  Law law = GetParam();
  law.enforcement = contact::Enforcement::augmented_lagrangian;
  Plates plates(with_friction(law));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->augment();
  plates.force(0.0, 0.0, 0.0); // closed without penetration, pressed by 1
  EXPECT_LT(plates.pair->augmentation().change, 1e-12);
  plates.pair->accept();
  plates.force(0.003, 0.0, 0.0);
  EXPECT_NEAR(plates.pair->augmentation().gap, 0.003 / 0.5, 1e-12); // motion in stick
  plates.pair->augment();
  EXPECT_NEAR(plates.force(0.0, 0.0, 0.0)[0], -0.3, 1e-12); // back at the anchor, with the force
  plates.pair->iterate_taken();                             // until then the status is held
  plates.force(0.1, 0.0, 0.0);
  plates.pair->augment();
  const Vec3 f = plates.force(0.1, 0.0, 0.0);
  EXPECT_NEAR(f[0], -0.5, 1e-12);
  EXPECT_NEAR(f[2], 1.0, 1e-12);
}

TEST_P(Friction, StatusIsHeldUntilAnIterateIsTakenAfterAnAugmentation) {
  Law law = GetParam();
  law.enforcement = contact::Enforcement::augmented_lagrangian;
  Plates plates(with_friction(law));
  plates.force(0.0, 0.0, -0.01);
  plates.pair->accept();
  plates.force(0.004, 0.0, -0.01); // sticks: 0.4 < 0.5
  plates.pair->augment();
  plates.force(0.004, 0.0, -0.01); // trial 0.8 < mu (1 + 1)
  EXPECT_EQ(plates.pair->summary().stick_points, plates.pair->summary().points);
  plates.pair->augment();
  plates.force(0.03, 0.0, -0.01); // far beyond the cone, but held
  EXPECT_EQ(plates.pair->summary().stick_points, plates.pair->summary().points);
  plates.pair->iterate_taken();
  plates.force(0.03, 0.0, -0.010001); // the next evaluation decides
  EXPECT_EQ(plates.pair->summary().slip_points, plates.pair->summary().points);
}

TEST(InteractionOptions, CurvesScalePenaltyAndFriction) {
  contact::ContactOptions o = with_friction({Formulation::sliding_elastic, FrictionMap::automatic});
  Plates plates(o);
  plates.pair->set_schedules([](double t) { return 1.0 + t; }, [](double t) { return 0.5 * t; });
  plates.force(0.0, 0.0, -0.01, 0.0);
  plates.pair->accept();
  const Vec3 f = plates.force(0.5, 0.0, -0.01, 0.4);
  EXPECT_NEAR(f[2], 1.4, 1e-12);
  EXPECT_NEAR(f[0], -1.4 * 0.5 * 0.2, 1e-12);
}

TEST(InteractionOptions, TiedPointsPullAndKeepTheirDistance) {
  for (const auto formulation :
       {Formulation::node_on_facet, Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    contact::ContactOptions o = with_penalty(100.0);
    o.formulation = formulation;
    o.tied = true;
    Plates plates(o, 0.02); // 0.04 of a face: within tie_distance
    EXPECT_NEAR(norm(plates.force(0.0, 0.0, 0.0)), 0.0, 1e-13);
    plates.pair->accept();
    const Vec3 f = plates.force(0.001, -0.002, 0.003);
    EXPECT_NEAR(f[0], -0.1, 1e-12);
    EXPECT_NEAR(f[1], 0.2, 1e-12);
    EXPECT_NEAR(f[2], -0.3, 1e-12);
    Plates far(o, 0.06);
    far.force(0.0, 0.0, 0.0);
    EXPECT_EQ(norm(far.force(0.0, 0.0, -0.5)), 0.0); // never tied, never in contact
  }
}

TEST(InteractionOptions, TensionHoldsWhatWasInContact) {
  contact::ContactOptions o = with_penalty(100.0);
  o.tension = true;
  Plates plates(o, 0.01);
  EXPECT_EQ(plates.force(0, 0, 0)[2], 0.0); // open: nothing pulls
  plates.pair->accept();
  EXPECT_NEAR(plates.force(0, 0, -0.02)[2], 1.0, 1e-12);
  plates.pair->accept();
  EXPECT_NEAR(plates.force(0, 0, 0.01)[2], -2.0, 1e-12);
}

// The plane rises beyond x = 1: the force tells whether the points there have a new face.
TEST(InteractionOptions, PartnersStayAfterSoManySearchesOfAStep) {
  contact::ContactOptions o = with_penalty(100.0);
  o.formulation = Formulation::node_on_facet;
  o.segment_updates = 1;
  Plates plates(o);
  for (std::size_t n = 0; n < plates.lower.node.size(); ++n)
    plates.system.u[3 * std::size_t(plates.lower.node[n]) + 2] =
        0.2 * std::max(0.0, plates.lower.x[3 * n] - 1.0);
  const auto begin_solve = [&](SolveKind kind) { plates.pair->begin_solve(kind); };
  plates.pair->begin_step();
  begin_solve(SolveKind::newton);
  EXPECT_NEAR(plates.force(-0.1, 0.0, -0.01)[2], 1.0, 1e-12);
  plates.pair->iterate_taken();
  EXPECT_NEAR(plates.force(0.3, 0.0, -0.01)[2], 1.0, 1e-12);
  begin_solve(SolveKind::after_augmentation);
  EXPECT_NEAR(plates.force(0.3, 0.0, -0.01)[2], 1.0, 1e-12);
  plates.pair->begin_step();
  begin_solve(SolveKind::newton);
  EXPECT_GT(plates.force(0.3, 0.0, -0.01)[2], 2.0);
}

TEST(InteractionOptions, OffsetCountsAsClosed) {
  for (const auto formulation : {Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    contact::ContactOptions o = with_friction({formulation, FrictionMap::automatic});
    o.offset = 0.05;
    Plates plates(o, 0.1);
    EXPECT_EQ(plates.force(0, 0, -0.049)[2], 0.0);
    plates.pair->accept();
    EXPECT_NEAR(plates.force(0, 0, -0.06)[2], 1.0, 1e-12);
    plates.pair->accept();
    EXPECT_NEAR(plates.force(0.002, 0, -0.06)[0], -0.2, 1e-12);
    EXPECT_NEAR(plates.force(0.5, 0, -0.06)[0], -0.5, 1e-12);
  }
}

TEST(InteractionOptions, InitialOverlap) {
  contact::ContactOptions o = with_penalty(100.0);
  Plates kept(o, -0.02);
  EXPECT_NEAR(kept.force(0, 0, 0, 0.0)[2], 2.0, 1e-12);
  o.initial_overlap = contact::InitialOverlap::adjust;
  Plates adjusted(o, -0.02);
  EXPECT_NEAR(adjusted.force(0, 0, 0, 0.0)[2], 0.0, 1e-13);
  EXPECT_NEAR(adjusted.force(0, 0, -0.01, 1.0)[2], 1.0, 1e-12);
  EXPECT_NEAR(adjusted.pair->summary().initial_overlap, 0.02, 1e-15);
  o.initial_overlap = contact::InitialOverlap::resolve;
  Plates resolved(o, -0.02);
  resolved.pair->set_end(2.0);
  EXPECT_NEAR(resolved.force(0, 0, 0, 0.0)[2], 0.0, 1e-13);
  EXPECT_NEAR(resolved.force(0, 0, 0, 0.5)[2], 0.5, 1e-12);
  EXPECT_NEAR(resolved.force(0, 0, 0, 2.0)[2], 2.0, 1e-12);
}

TEST(InteractionOptions, PassesShareTheForce) {
  PhaseTimers timers;
  auto upper = grid_surface(2, 2, 0, 1, 0, 1, true, 0);
  auto lower = grid_surface(3, 3, 0, 1, 0, 1, false, 9, {}, 100);
  contact::Interaction first(Comm(MPI_COMM_WORLD), upper, lower, with_penalty(100.0), timers, 0.5);
  contact::Interaction second(Comm(MPI_COMM_WORLD), lower, upper, with_penalty(100.0), timers, 0.5);
  DenseSystem system(9 + 16, 3);
  for (std::size_t a = 0; a < 9; ++a)
    system.u[3 * a + 2] = -0.01;
  double sum = 0.0;
  for (contact::Interaction* pass : {&first, &second}) {
    system.evaluate(*pass, false);
    for (std::size_t a = 0; a < 9; ++a)
      sum -= system.residual[3 * a + 2];
    EXPECT_NEAR(pass->summary().max_pressure, 1.0, 1e-12);
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(InteractionOptions, CallbackReplacesTheUpdate) {
  contact::ContactOptions o = with_penalty(100.0);
  o.enforcement = contact::Enforcement::augmented_lagrangian;
  Plates plates(o);
  plates.pair->set_update([](const contact::Site&, double& pressure, Vec3&) { pressure *= 0.5; });
  plates.force(0, 0, -0.01);
  plates.pair->augment();
  EXPECT_NEAR(plates.force(0, 0, -0.01)[2], 1.5, 1e-12);
}

// A strip folded back over itself: its ends meet, its neighbours do not.
TEST(InteractionOptions, SelfContactOfAFold) {
  for (const auto formulation : {Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    PhaseTimers timers;
    contact::ContactOptions o = with_penalty(100.0);
    o.formulation = formulation;
    o.primary = o.secondary = "skin";
    const double pi = std::acos(-1.0), radius = 0.1;
    // Inner side of a hairpin: a straight leg, half a circle, a straight leg.
    const auto fold = [&](double* x) {
      const double s = x[0];
      if (s < 1.0)
        x[0] = s, x[2] = 0.0;
      else if (s < 2.0)
        x[0] = 1.0 + radius * std::sin(pi * (s - 1.0)),
        x[2] = radius * (1.0 - std::cos(pi * (s - 1.0)));
      else
        x[0] = 3.0 - s, x[2] = 2.0 * radius;
    };
    auto skin = grid_surface(24, 1, 0, 3, 0, 1, false, 0, fold);
    skin.inverse_depth.assign(skin.type.size(), 1.0 / 0.05);
    DenseSystem system(50, 3);
    contact::Interaction pair(Comm(MPI_COMM_WORLD), skin, skin, o, timers);
    system.evaluate(pair, false);
    EXPECT_EQ(pair.summary().active_points, 0) << "neighbours must not meet";
    for (std::size_t a = 0; a < 50; ++a) // the upper leg comes down to 0.01 below the lower one
      if (skin.x[3 * a + 2] > 0.19)
        system.u[3 * a + 2] = -0.21;
    system.evaluate(pair, false);
    double down = 0.0, all = 0.0;
    for (std::size_t a = 0; a < 50; ++a) {
      all += system.residual[3 * a + 2];
      if (skin.x[3 * a + 2] < 1e-9)
        down += system.residual[3 * a + 2];
    }
    EXPECT_GT(pair.summary().active_points, 0);
    EXPECT_NEAR(all, 0.0, 1e-12);
    EXPECT_NEAR(down, 2.0, 0.15); // both legs carry points: twice the penalty over unit area
  }
}

// The upper side of a plate and the lower side of another one beneath it face each other through
// both plates. How far that is from contact their thickness tells.
TEST(InteractionOptions, BacksOfThinBodiesDoNotMeet) {
  for (const auto formulation :
       {Formulation::node_on_facet, Formulation::facet_on_facet, Formulation::sliding_elastic})
    for (const double thickness : {0.1, 0.39, 0.41, 10.0})
      for (const bool of_primary : {false, true}) {
        PhaseTimers timers;
        contact::ContactOptions o = with_penalty(100.0);
        o.formulation = formulation;
        auto above = grid_surface(2, 2, 0, 1, 0, 1, false, 0, [](double* x) { x[2] = 0.2; });
        auto below = grid_surface(2, 2, 0, 1, 0, 1, true, 9, {}, 100);
        (of_primary ? above : below).thickness.assign(4, thickness);
        DenseSystem system(18, 3);
        contact::Interaction pair(Comm(MPI_COMM_WORLD), above, below, o, timers);
        system.evaluate(pair, false);
        EXPECT_EQ(pair.summary().active_points > 0, thickness > 0.4) << thickness;
      }
}

// With multipliers, a point that came into contact in this step is not pulled back to where the
// step began: its traction stays while the gap closes. From the next step on it sticks.
TEST_P(Friction, AugmentationDoesNotUndoTheWayBeforeContact) {
  Law law = GetParam();
  law.enforcement = contact::Enforcement::augmented_lagrangian;
  Plates plates(with_friction(law), 0.03);
  plates.force(0.0, 0.0, 0.0);
  plates.pair->accept();
  EXPECT_NEAR(plates.force(0.004, 0.0, -0.04)[0], -0.1, 1e-12);
  plates.pair->augment();
  for (int k = 0; k < 5; ++k) {
    plates.force(0.004, 0.0, -0.03); // closed
    EXPECT_NEAR(plates.pair->augmentation().change, 0.0, 1e-11);
    plates.pair->augment();
  }
  EXPECT_NEAR(plates.force(0.004, 0.0, -0.03)[0], -0.1, 1e-12);
  plates.pair->accept();
  EXPECT_NEAR(plates.force(0.004, 0.0, -0.03)[0], -0.1, 1e-12);
  EXPECT_NEAR(plates.force(0.005, 0.0, -0.03)[0], -0.2, 1e-12);
}

// A plate that jumps through the plane by many face sizes in one step is still held.
TEST(InteractionOptions, FastPointsDoNotPassThrough) {
  for (const auto formulation :
       {Formulation::node_on_facet, Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    contact::ContactOptions o = with_penalty(100.0);
    o.formulation = formulation;
    Plates plates(o, 0.1);
    plates.force(0.0, 0.0, 0.0);
    plates.pair->accept();
    EXPECT_NEAR(plates.force(0.0, 0.0, -9.0)[2], 890.0, 1e-9);
    plates.pair->reject();
    EXPECT_NEAR(plates.force(0.0, 0.0, -9.0)[2], 890.0, 1e-9);
    // What lay behind from the start does not pull: no crossing, and beyond the reach.
    Plates behind(o, -9.0);
    EXPECT_EQ(behind.force(0.0, 0.0, 0.0)[2], 0.0);
    EXPECT_EQ(behind.force(0.0, 0.0, -9.0)[2], 0.0);
  }
}
