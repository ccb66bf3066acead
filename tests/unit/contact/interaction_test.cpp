// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"
#include "abut/core/error.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;
using abut_test::DenseSystem;
using abut_test::grid_surface;

namespace {

constexpr double pi = 3.14159265358979323846;

contact::ContactOptions with_penalty(double penalty) {
  contact::ContactOptions o;
  o.name = "pair";
  o.penalty = penalty;
  return o;
}

/// Concentric map of the square [-1,1]^2 on the unit disc, then on the southern or northern cap of
/// the unit sphere of angle `reach`; `depth` moves the pole.
void cap(double* x, double reach, bool south, double depth) {
  const double s = std::max(std::fabs(x[0]), std::fabs(x[1]));
  const double l = std::hypot(x[0], x[1]);
  const double r = l > 0.0 ? s / l : 0.0, angle = s * reach;
  const double u = x[0] * r, v = x[1] * r, scale = s > 0.0 ? std::sin(angle) / s : reach;
  x[0] = u * scale;
  x[1] = v * scale;
  x[2] = (1.0 - std::cos(angle)) * (south ? 1.0 : -1.0) - depth * (south ? 1.0 : -1.0);
}

/// Vertical force of a unit sphere pressed by 0.1 into a plane, eps = 1, nothing solved.
double sphere_force(int n, bool sphere_is_primary, int points,
                    contact::Formulation formulation = contact::Formulation::facet_on_facet) {
  PhaseTimers timers;
  contact::ContactOptions o = with_penalty(1.0);
  o.points = points;
  o.formulation = formulation;
  o.reach = 0.2 * n; // 0.24 in length: deeper than the sphere goes
  const double depth = 0.1, reach = 0.6;
  auto sphere =
      grid_surface(n, n, -1, 1, -1, 1, true, 0, [&](double* x) { cap(x, reach, true, depth); });
  const int m = sphere_is_primary ? 1 : n;
  auto plane = grid_surface(m, m, -0.6, 0.6, -0.6, 0.6, false, sphere.num_nodes(), {}, 100000);
  DenseSystem system(sphere.num_nodes() + plane.num_nodes(), 3);
  contact::Interaction pair(Comm(MPI_COMM_WORLD), sphere_is_primary ? sphere : plane,
                            sphere_is_primary ? plane : sphere, o, timers);
  system.evaluate(pair, false);
  EXPECT_GT(pair.summary().active_points, 20);
  EXPECT_LT(pair.summary().active_points, pair.summary().points);
  return std::fabs(pair.summary().force[2]);
}

} // namespace

// A0.1: exact forces, each its own for its formulation; O(h^2) of the facets.
TEST(Interaction, RigidSphereInPlaneSpherePrimary) {
  const double exact = pi * 0.1 * 0.1; // eps pi R d^2
  const double coarse = std::fabs(sphere_force(24, true, 4) / exact - 1.0);
  const double fine = std::fabs(sphere_force(72, true, 4) / exact - 1.0);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, coarse / 5.0); // 9 for a clean second order
  EXPECT_GT(coarse, 1e-5);
}

TEST(Interaction, RigidSphereInPlanePlanePrimary) {
  const double exact =
      pi * 0.1 * 0.1 * (1.0 - 0.1); // eps pi d^2 (R - d), closest point on the sphere
  const double coarse = std::fabs(sphere_force(24, false, 4) / exact - 1.0);
  const double fine = std::fabs(sphere_force(72, false, 4) / exact - 1.0);
  EXPECT_LT(fine, 2e-3);
  EXPECT_LT(fine, coarse / 4.0);
}

// Rays: the sphere's points see the plane along their own normals, the plane's points see the
// sphere from above; node_on_facet is the closest point again. Both sides, each its own exact
// force.
TEST(InteractionFormulations, RigidSphereInPlane) {
  const auto ray = contact::Formulation::sliding_elastic,
             nodal = contact::Formulation::node_on_facet;
  const struct {
    contact::Formulation formulation;
    bool sphere_is_primary;
    double exact;
  } cases[] = {{ray, true, pi * 0.01},
               {ray, false, pi * 0.01 * (1.0 - 0.1 / 3.0)},
               {nodal, true, pi * 0.01},
               {nodal, false, pi * 0.01 * (1.0 - 0.1)}};
  for (const auto& c : cases) {
    const double coarse =
        std::fabs(sphere_force(24, c.sphere_is_primary, 4, c.formulation) / c.exact - 1.0);
    const double fine =
        std::fabs(sphere_force(72, c.sphere_is_primary, 4, c.formulation) / c.exact - 1.0);
    EXPECT_LT(fine, 2e-3) << int(c.formulation) << c.sphere_is_primary << ' ' << coarse;
    EXPECT_LT(fine, coarse / 4.0) << int(c.formulation) << c.sphere_is_primary;
  }
}

namespace {

/// Rigid block B x 1 on a rigid plane, eps = 1, raised by `up` and turned by the small angle `tilt`
/// about y; vertical force and moment about y.
std::array<double, 2>
mattress(int n, int points, double up, double tilt,
         contact::Formulation formulation = contact::Formulation::facet_on_facet) {
  PhaseTimers timers;
  contact::ContactOptions o = with_penalty(1.0);
  o.points = points;
  o.formulation = formulation;
  auto block = grid_surface(n, 1, -0.5, 0.5, 0.0, 1.0, true, 0);
  auto plane = grid_surface(1, 1, -3, 3, -3, 3, false, block.num_nodes(), {}, 1000);
  DenseSystem system(block.num_nodes() + plane.num_nodes(), 3);
  for (int a = 0; a < block.num_nodes(); ++a)
    system.u[std::size_t(3 * a + 2)] = up + tilt * block.x[std::size_t(3 * a)];
  contact::Interaction pair(Comm(MPI_COMM_WORLD), block, plane, o, timers);
  system.evaluate(pair, false);
  std::array<double, 2> result{0.0, 0.0};
  for (int a = 0; a < block.num_nodes(); ++a) {
    result[0] -= system.residual[std::size_t(3 * a + 2)]; // force on the block
    result[1] -= system.residual[std::size_t(3 * a + 2)] * block.x[std::size_t(3 * a)];
  }
  return result;
}

} // namespace

// A0.2: K_z = eps B D, K_theta = eps D B^3/12 with two Gauss points or more.
TEST(Interaction, MattressStiffness) {
  for (int points : {2, 3, 4}) {
    const auto pressed = mattress(3, points, -0.1, 0.0), tilted = mattress(3, points, -0.1, 0.02);
    EXPECT_NEAR(pressed[0], 0.1, 1e-14);
    EXPECT_NEAR(pressed[1], 0.0, 1e-14);
    EXPECT_NEAR(tilted[1], -0.02 / 12.0, 1e-15);
  }
  // One point a facet sits where nodal quadrature misses the mark too: K_theta (1 - 1/n^2).
  EXPECT_NEAR(mattress(4, 1, -0.1, 0.02)[1], -0.02 / 12.0 * (1.0 - 1.0 / 16.0), 1e-15);
}

// Nodal quadrature overestimates the rotational stiffness by 1 + 2/n^2, n facets over the width.
TEST(InteractionFormulations, MattressOnNodes) {
  for (int n : {2, 4, 8}) {
    const auto tilted = mattress(n, 2, -0.1, 0.02, contact::Formulation::node_on_facet);
    EXPECT_NEAR(tilted[0], 0.1, 1e-14);
    EXPECT_NEAR(tilted[1], -0.02 / 12.0 * (1.0 + 2.0 / (n * n)), 1e-15);
  }
}

// A0.4 and sign: the pair's forces cancel, and they push the bodies apart.
TEST(Interaction, ForcesBalanceAndPushApart) {
  PhaseTimers timers;
  auto wavy = [](double* x) { x[2] = -0.05 + 0.04 * std::sin(3 * x[0]) * std::cos(2 * x[1]); };
  auto bowl = [](double* x) { x[2] = 0.03 * std::cos(2 * x[0]) - 0.03; };
  auto upper = grid_surface(5, 4, -1, 1, -1, 1, true, 0, wavy);
  auto lower = grid_surface(7, 6, -1.2, 1.2, -1.2, 1.2, false, upper.num_nodes(), bowl, 1000);
  DenseSystem system(upper.num_nodes() + lower.num_nodes(), 3);
  contact::Interaction pair(Comm(MPI_COMM_WORLD), upper, lower, with_penalty(10.0), timers);
  system.evaluate(pair, true);
  double sum[3] = {}, on_upper = 0.0, size = 0.0;
  for (int a = 0; a < system.nodes; ++a)
    for (int i = 0; i < 3; ++i) {
      sum[i] += system.residual[std::size_t(3 * a + i)];
      size += std::fabs(system.residual[std::size_t(3 * a + i)]);
    }
  for (int a = 0; a < upper.num_nodes(); ++a)
    on_upper -= system.residual[std::size_t(3 * a + 2)];
  EXPECT_GT(on_upper, 0.05);
  for (double s : sum)
    EXPECT_LT(std::fabs(s), 1e-13 * size);
  EXPECT_NEAR(pair.summary().force[2], on_upper, 1e-13);

  // The assembled tangent against central differences of the assembled residual.
  std::vector<double> direction(system.u.size());
  for (std::size_t i = 0; i < direction.size(); ++i)
    direction[i] = std::sin(1.0 + 7.0 * double(i));
  const std::vector<double> k = system.tangent;
  const double h = 1e-6;
  std::vector<double> slope(direction.size());
  for (int side : {1, -1}) {
    for (std::size_t i = 0; i < direction.size(); ++i)
      system.u[i] = side * h * direction[i];
    system.evaluate(pair, false);
    for (std::size_t i = 0; i < slope.size(); ++i)
      slope[i] += side * system.residual[i] / (2 * h);
  }
  double error = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    double kd = 0.0;
    for (std::size_t j = 0; j < slope.size(); ++j)
      kd += k[i * slope.size() + j] * direction[j];
    error += std::pow(kd - slope[i], 2);
    norm += slope[i] * slope[i];
  }
  EXPECT_LT(std::sqrt(error / norm), 1e-6);
}

// S30: points above edges and corners of the secondary have one partner, whatever the face order.
TEST(Interaction, PointsOverEdgesCountOnce) {
  PhaseTimers timers;
  for (double shift : {0.0, 1e-16, -1e-12, 0.25}) {
    contact::ContactOptions o = with_penalty(1.0);
    o.points = 1; // face centres
    auto upper = grid_surface(4, 4, -0.5, 0.5, -0.5, 0.5, true, 0, [&](double* x) {
      x[0] += 0.125 + shift, x[1] += 0.125, x[2] = -0.01;
    });
    auto lower = grid_surface(8, 8, -1, 1, -1, 1, false, upper.num_nodes(), {}, 1000);
    DenseSystem system(upper.num_nodes() + lower.num_nodes(), 3);
    contact::Interaction pair(Comm(MPI_COMM_WORLD), upper, lower, o, timers);
    system.evaluate(pair, false);
    EXPECT_EQ(pair.summary().active_points, 16);
    EXPECT_NEAR(pair.summary().force[2], 0.01, 1e-15);
  }
}

TEST(Interaction, SameFacingSurfacesDoNotMeet) {
  PhaseTimers timers;
  auto upper = grid_surface(2, 2, -1, 1, -1, 1, false, 0, [](double* x) { x[2] = -0.1; });
  auto lower = grid_surface(2, 2, -1, 1, -1, 1, false, upper.num_nodes(), {}, 1000);
  DenseSystem system(upper.num_nodes() + lower.num_nodes(), 3);
  contact::Interaction pair(Comm(MPI_COMM_WORLD), upper, lower, with_penalty(1.0), timers);
  system.evaluate(pair, false);
  EXPECT_EQ(pair.summary().active_points, 0);
  EXPECT_DOUBLE_EQ(pair.wrong_facing_share(), 1.0);
}

TEST(Interaction, AugmentationFollowsTheLaw) {
  PhaseTimers timers;
  auto upper = grid_surface(1, 1, -0.5, 0.5, -0.5, 0.5, true, 0, [](double* x) { x[2] = -0.02; });
  auto lower = grid_surface(1, 1, -1, 1, -1, 1, false, upper.num_nodes(), {}, 1000);
  DenseSystem system(upper.num_nodes() + lower.num_nodes(), 3);
  contact::Interaction pair(Comm(MPI_COMM_WORLD), upper, lower, with_penalty(5.0), timers);
  system.evaluate(pair, false);
  EXPECT_NEAR(pair.summary().force[2], 0.1, 1e-15);
  contact::Augmentation report = pair.augmentation();
  pair.augment(); // lambda = 0.1
  EXPECT_NEAR(report.change, 1.0, 1e-15);
  EXPECT_NEAR(report.gap, 0.02, 1e-15);
  EXPECT_FALSE(report.converged);
  system.u[2] = 0.0;
  for (int a = 0; a < 4; ++a)
    system.u[std::size_t(3 * a + 2)] = 0.02; // gap closed exactly
  system.evaluate(pair, false);
  EXPECT_NEAR(pair.summary().force[2], 0.1, 1e-15); // held by the multiplier alone
  report = pair.augmentation();
  EXPECT_LT(report.change, 1e-14);
  EXPECT_TRUE(report.converged);
  pair.reject(); // back to no multiplier
  system.u[2] += 1e-3;
  system.evaluate(pair, false);
  EXPECT_LT(pair.summary().force[2], 1e-12);
}

TEST(Interaction, BothRigidNeedsPenalty) {
  PhaseTimers timers;
  auto upper = grid_surface(1, 1, -0.5, 0.5, -0.5, 0.5, true, 0);
  auto lower = grid_surface(1, 1, -1, 1, -1, 1, false, 4, {}, 1000);
  contact::ContactOptions o;
  o.name = "pair";
  EXPECT_THROW(contact::Interaction(Comm(MPI_COMM_WORLD), upper, lower, o, timers), InputError);
}

// The penalty scales with E A/V; the softer body and the primary's depth decide.
TEST(Interaction, AutomaticPenalty) {
  PhaseTimers timers;
  auto upper = grid_surface(1, 1, -0.5, 0.5, -0.5, 0.5, true, 0, [](double* x) { x[2] = -0.02; });
  auto lower = grid_surface(1, 1, -1, 1, -1, 1, false, 4, {}, 1000);
  upper.modulus = {7.0};
  upper.inverse_depth = {4.0};
  lower.modulus = {3.0};
  lower.inverse_depth = {0.5};
  contact::ContactOptions o;
  o.name = "pair";
  o.penalty_factor = 2.0;
  DenseSystem system(8, 3);
  contact::Interaction soft(Comm(MPI_COMM_WORLD), upper, lower, o, timers);
  system.evaluate(soft, false);
  EXPECT_DOUBLE_EQ(soft.points().sites()[0].penalty, 2.0 * 3.0 * 4.0);
  upper.modulus = {0.0};
  contact::Interaction rigid(Comm(MPI_COMM_WORLD), upper, lower, o, timers);
  system.evaluate(rigid, false);
  EXPECT_DOUBLE_EQ(rigid.points().sites()[0].penalty, 2.0 * 3.0 * 0.5);
}
