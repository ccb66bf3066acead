// SPDX-License-Identifier: BSD-3-Clause
// The nodal law on plates and patches moved by hand: its weights, uniform states, friction, ends.
#include "abut/contact/interaction.hpp"
#include "abut/core/error.hpp"
#include "abut/fem/quadrature.hpp"
#include "dual_scene.hpp"
#include "spaces/dual_weights.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut_test::DenseSystem;
using abut_test::grid_surface;
using fem::FaceType;

namespace {

ContactOptions options(Formulation formulation, double friction = 0.0) {
  ContactOptions o;
  o.name = "pair";
  o.multipliers = Multipliers::dual;
  o.penalty = 100.0;
  o.formulation = formulation;
  o.friction = friction;
  return o;
}

/// A plate of area 1 with 2 x 2 faces over a plane, both flat and moved by hand.
struct Plates {
  explicit Plates(const ContactOptions& o, double low = -2.0, double high = 3.0)
      : lower(grid_surface(5, 5, low, high, -2, 3, false, 9, {}, 100)), system(9 + 36, 3),
        pair(Comm(MPI_COMM_WORLD), upper, lower, o, timers) {}

  Vec3 force(double x, double y, double z) {
    for (std::size_t a = 0; a < 9; ++a) {
      system.u[3 * a] = x;
      system.u[3 * a + 1] = y;
      system.u[3 * a + 2] = z;
    }
    system.evaluate(pair, false);
    Vec3 sum = Vec3::zero();
    for (std::size_t a = 0; a < 9; ++a)
      for (int i = 0; i < 3; ++i)
        sum[i] -= system.residual[3 * a + std::size_t(i)];
    return sum;
  }
  /// Nodal pressures of the corners, in the order of the surface's nodes.
  std::vector<double> pressures() const {
    const NodalSums s = pair.nodal_sums();
    std::vector<double> p;
    for (std::size_t i = 0; i < s.weight.size(); ++i)
      p.push_back(s.pressure[i] / s.weight[i]);
    return p;
  }

  mesh::Surface upper = grid_surface(2, 2, 0, 1, 0, 1, true, 0);
  mesh::Surface lower;
  PhaseTimers timers;
  DenseSystem system;
  Interaction pair;
};

class DualLaws : public ::testing::TestWithParam<Formulation> {};
INSTANTIATE_TEST_SUITE_P(Formulations, DualLaws,
                         ::testing::Values(Formulation::node_on_facet, Formulation::facet_on_facet,
                                           Formulation::sliding_elastic));

} // namespace

TEST(DualWeights, AreBiorthogonalAndSumToOne) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.5, 2.0);
  for (FaceType type : {FaceType::quad4, FaceType::tri3}) {
    const int n = fem::face_corners(type);
    const fem::Rule<2> rule = fem::face_rule(type, 3);
    std::vector<double> N, w;
    for (int q = 0; q < rule.size(); ++q) {
      double values[fem::max_face_nodes];
      fem::dispatch_face(type, [&](auto s) { decltype(s)::values(rule.xi[q].data(), values); });
      N.insert(N.end(), values, values + n);
      w.push_back(rule.weight[q] * uniform(random)); // a face that is not a parallelogram
    }
    double C[16], least = 1.0;
    ASSERT_TRUE(dual_coefficients(n, rule.size(), N.data(), w.data(), C));
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        double product = 0.0, lumped = 0.0;
        for (int q = 0; q < rule.size(); ++q) {
          double psi = 0.0;
          for (int c = 0; c < n; ++c)
            psi += C[a * n + c] * N[q * n + c];
          least = std::min(least, psi);
          product += w[q] * psi * N[q * n + b];
          lumped += w[q] * N[q * n + a];
        }
        EXPECT_NEAR(product, a == b ? lumped : 0.0, 1e-13);
      }
    for (int c = 0; c < n; ++c) {
      double sum = 0.0; // of the functions' coefficients: sum psi = sum N = 1
      for (int a = 0; a < n; ++a)
        sum += C[a * n + c];
      EXPECT_NEAR(sum, 1.0, 1e-13);
    }
    EXPECT_LT(least, -0.1) << "they are not the corner functions";
  }
}

TEST(DualWeights, OnePointCannotTellCornersApart) {
  const double N[4] = {0.25, 0.25, 0.25, 0.25}, w = 1.0;
  double C[16];
  EXPECT_FALSE(dual_coefficients(4, 1, N, &w, C));
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      EXPECT_EQ(C[4 * a + b], a == b ? 1.0 : 0.0);
}

TEST_P(DualLaws, UniformGapGivesUniformPressure) {
  Plates plates(options(GetParam()));
  const Vec3 f = plates.force(0.13, 0.07, -0.01);
  EXPECT_NEAR(f[2], 1.0, 1e-13); // eps times the depth times the area
  for (double p : plates.pressures())
    EXPECT_NEAR(p, 1.0, 1e-12);
  EXPECT_NEAR(plates.pair.summary().max_pressure, 1.0, 1e-12);
  EXPECT_NEAR(plates.pair.summary().penalty_energy, 0.5 * 100.0 * 1e-4, 1e-15);
  for (const PointRecord& r : plates.pair.points().records())
    EXPECT_NEAR(r.pressure, 1.0, 1e-12);
}

TEST_P(DualLaws, AugmentationClosesTheGap) {
  ContactOptions o = options(GetParam());
  o.enforcement = Enforcement::augmented_lagrangian;
  Plates plates(o);
  plates.force(0.0, 0.0, -0.01);
  EXPECT_NEAR(plates.pair.augmentation().gap, 0.01 / 0.5, 1e-13);
  EXPECT_NEAR(plates.pair.augmentation().change, 1.0, 1e-13);
  plates.pair.augment();
  EXPECT_NEAR(plates.force(0.0, 0.0, 0.0)[2], 1.0, 1e-12);
  EXPECT_LT(plates.pair.augmentation().change, 1e-12);
  plates.pair.reject(); // the multipliers are those of the start
  EXPECT_EQ(plates.force(0.0, 0.0, 0.0)[2], 0.0);
  EXPECT_NEAR(plates.force(0.0, 0.0, -0.01)[2], 1.0, 1e-12);
  plates.pair.augment();
  EXPECT_NEAR(plates.force(0.0, 0.0, 0.005)[2], 0.5, 1e-12); // open, but pressed by the multiplier
  EXPECT_EQ(plates.force(0.0, 0.0, 0.02)[2], 0.0);
}

/// A gap of 2e-4 of a face that costs 5e-7 of energy.
TEST(DualGap, IsSmallBesideWhatTheBodiesGive) {
  ContactOptions o = options(Formulation::facet_on_facet);
  o.enforcement = Enforcement::augmented_lagrangian;
  for (const bool given : {false, true}) {
    if (given)
      o.gap_tolerance = 1e-3;
    mesh::Surface upper = grid_surface(2, 2, 0, 1, 0, 1, true, 0);
    upper.modulus.assign(4, 1e4);
    upper.inverse_depth.assign(4, 1.0);
    PhaseTimers timers;
    Interaction pair(Comm(MPI_COMM_WORLD), upper,
                     grid_surface(5, 5, -2, 3, -2, 3, false, 9, {}, 100), o, timers);
    DenseSystem system(9 + 36, 3);
    for (std::size_t a = 0; a < 9; ++a)
      system.u[3 * a + 2] = -1e-4;
    system.evaluate(pair, false);
    EXPECT_TRUE(pair.augmentation().converged);
    EXPECT_TRUE(pair.augmentation([] { return 1e-3; }).converged);
    EXPECT_EQ(pair.augmentation([] { return 1e-4; }).converged, given);
    EXPECT_TRUE(pair.augmentation([] { return 0.0; }).converged); // nothing elastic to compare with
  }
}

TEST_P(DualLaws, UserUpdateSeesNodes) {
  ContactOptions o = options(GetParam());
  o.enforcement = Enforcement::augmented_lagrangian;
  Plates plates(o);
  int calls = 0;
  plates.pair.set_update([&](const Site& node, double& pressure, Vec3&) {
    ++calls;
    EXPECT_NEAR(node.gap, -0.01, 1e-14);
    EXPECT_NEAR(node.penalty, 100.0, 1e-12);
    EXPECT_NEAR(pressure, 1.0, 1e-12);
    pressure *= 0.5;
  });
  plates.force(0.0, 0.0, -0.01);
  plates.pair.augment();
  EXPECT_EQ(calls, 9);
  EXPECT_NEAR(plates.force(0.0, 0.0, 0.0)[2], 0.5, 1e-12);
}

// Pressed by 0.01 (force 1), the elastic slip at the cone is 0.005.
TEST_P(DualLaws, SticksElasticallyThenSlipsOnTheCone) {
  Plates plates(options(GetParam(), 0.5));
  plates.force(0.0, 0.0, -0.01);
  plates.pair.accept();
  Vec3 f = plates.force(0.003, 0.0, -0.01);
  EXPECT_NEAR(f[2], 1.0, 1e-12);
  EXPECT_NEAR(f[0], -0.3, 1e-12);
  EXPECT_EQ(plates.pair.summary().stick_points, plates.pair.summary().points);
  plates.pair.accept();
  f = plates.force(0.2, 0.0, -0.01);
  EXPECT_NEAR(f[0], -0.5, 1e-12);
  EXPECT_TRUE(plates.pair.settled());
  EXPECT_EQ(plates.pair.summary().slip_points, plates.pair.summary().points);
  plates.pair.accept();
  EXPECT_NEAR(plates.pair.summary().max_slip, 0.195, 1e-12);
  EXPECT_NEAR(plates.pair.summary().dissipation, 0.5 * 0.195, 1e-12);
  const double held = plates.force(0.197, 0.0, -0.01)[0]; // back: from -0.5 by 0.3
  EXPECT_NEAR(held, -0.2, 1e-12);
  for (int step = 0; step < 50; ++step) {
    plates.pair.accept();
    EXPECT_NEAR(plates.force(0.197, 0.0, -0.01)[0], held, 1e-13);
  }
}

TEST_P(DualLaws, HeldShearDoesNotCreepOnCurvedFaces) {
  DualScene s(FaceType::quad4, FaceType::quad8, options(GetParam(), 5.0), 0.1, 3, 0.1);
  s.move(0.0, Vec3::zero());
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.move(0.0, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  const double start = s.pair->summary().tangential;
  EXPECT_GT(start, 0.1);
  for (int step = 0; step < 50; ++step) {
    s.pair->accept();
    s.system.evaluate(*s.pair, false);
  }
  EXPECT_NEAR(s.pair->summary().tangential, start, 1e-10 * start);
}

// A rigid turn of everything, step by step, turns the forces along.
TEST_P(DualLaws, TractionsTurnWithTheBodies) {
  DualScene s(FaceType::quad4, FaceType::tri3, options(GetParam(), 5.0), 0.1);
  s.move(0.0, Vec3::zero());
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.move(0.0, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.system.evaluate(*s.pair, false);
  const std::vector<double> before = s.system.residual, u = s.system.u;
  const double angle = 0.4, c = std::cos(angle), d = std::sin(angle);
  const auto turn = [&](const double* v) { // about z, then about x
    const double x = c * v[0] - d * v[1], y = d * v[0] + c * v[1];
    return Vec3{{x, c * y - d * v[2], d * y + c * v[2]}};
  };
  for (const mesh::Surface* surface : {&s.upper, &s.lower})
    for (std::size_t a = 0; a < surface->node.size(); ++a) {
      double now[3];
      for (std::size_t i = 0; i < 3; ++i)
        now[i] = surface->x[3 * a + i] + u[3 * std::size_t(surface->node[a]) + i];
      const Vec3 turned = turn(now);
      for (std::size_t i = 0; i < 3; ++i)
        s.system.u[3 * std::size_t(surface->node[a]) + i] = turned.v[i] - surface->x[3 * a + i];
    }
  s.system.evaluate(*s.pair, false);
  EXPECT_GT(s.pair->summary().tangential, 0.1);
  for (std::size_t n = 0; n < before.size(); n += 3) {
    const Vec3 expected = turn(&before[n]);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(s.system.residual[n + i], expected.v[i], 1e-12);
  }
}

TEST_P(DualLaws, ForcesBalance) {
  DualScene s(FaceType::quad4, FaceType::quad4, options(GetParam(), 0.2), 0.05);
  s.move(0.01, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.move(0.02, {{0.06, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  Vec3 sum = Vec3::zero(), upper = Vec3::zero();
  for (std::size_t n = 0; n < s.system.residual.size(); ++n) {
    sum[int(n % 3)] += s.system.residual[n];
    if (n < 3 * s.upper.node.size())
      upper[int(n % 3)] -= s.system.residual[n];
  }
  EXPECT_GT(norm(upper), 0.1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(sum[i], 0.0, 1e-13);
    EXPECT_NEAR(upper[i], s.pair->summary().force[std::size_t(i)], 1e-13);
  }
}

// The plate hangs over the end of the plane by a part of a face: nodes without cover carry nothing
// of their own, the pressure of the others is still uniform, and the force is that of the cover.
// (Points of node_on_facet are nodes: there the cover is that of whole nodes.)
TEST(DualOverhang, KeepsUniformPressure) {
  for (Formulation formulation : {Formulation::facet_on_facet, Formulation::sliding_elastic})
    for (double end : {0.3, 0.55, 0.7, 0.9}) {
      ContactOptions o = options(formulation);
      o.points = 3;
      Plates plates(o, end - 5.0, end);
      const double force = plates.force(0.0, 0.0, -0.01)[2];
      const ContactSummary s = plates.pair.summary();
      EXPECT_LT(s.paired_points, s.points);
      EXPECT_EQ(s.active_points, s.paired_points);
      EXPECT_NEAR(force, s.area, 1e-12); // p = 1 on what is covered
      EXPECT_NEAR(s.max_pressure, 1.0, 1e-12) << end;
    }
}

// A corner and a node in the middle of a side cannot move along the normal; a third can, it is
// prescribed along the face only. Their neighbours speak for the first two.
TEST_P(DualLaws, PrescribedNodesHaveNoMultiplierOfTheirOwn) {
  ContactOptions o = options(GetParam());
  o.enforcement = Enforcement::augmented_lagrangian;
  Plates plates(o);
  std::vector<char> directions(9, 0);
  directions[0] = 7;
  directions[5] = 4;
  directions[7] = 3;
  plates.pair.set_prescribed(directions);
  std::vector<int> seen;
  plates.pair.set_update([&](const Site&, double& p, Vec3&) { seen.push_back(p > 0.0); });
  const Vec3 f = plates.force(0.13, 0.07, -0.01);
  EXPECT_NEAR(f[2], 1.0, 1e-13);
  for (double p : plates.pressures())
    EXPECT_NEAR(p, 1.0, 1e-12);
  plates.pair.augment();
  const int held = GetParam() == Formulation::node_on_facet; // there each node is a point
  EXPECT_EQ(seen, (std::vector<int>{held, 1, 1, 1, 1, held, 1, 1, 1}));
}

TEST(DualOptions, RefusesWhatItCannotDo) {
  const auto refused = [](const std::function<void(ContactOptions&)>& change) {
    ContactOptions o = options(Formulation::sliding_elastic, 0.3);
    change(o);
    EXPECT_THROW(Plates plates(o), InputError);
  };
  refused([](ContactOptions& o) { o.tied = true; });
  refused([](ContactOptions& o) { o.tension = true; });
  refused([](ContactOptions& o) { o.tangent = Tangent::automatic; });
  refused([](ContactOptions& o) { o.friction_map = FrictionMap::inclined_ray; });
}
