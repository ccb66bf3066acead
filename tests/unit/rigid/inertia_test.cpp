// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/inertia.hpp"
#include "abut/rigid/rotation.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using rigid::Inertia;
using rigid::Mass;

namespace {

Mass body(const Vec3& moments, const Vec3& arm = Vec3::zero()) {
  Mass m;
  m.mass = 2.0;
  m.arm = arm;
  for (int i = 0; i < 3; ++i)
    m.inertia[i][i] = moments[i];
  return m;
}

/// Solves a x = b for six unknowns.
std::array<double, 6> solve(double (&a)[6][6], std::array<double, 6> b) {
  for (int k = 0; k < 6; ++k) {
    int p = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[p][k]))
        p = i;
    std::swap(a[k], a[p]);
    std::swap(b[std::size_t(k)], b[std::size_t(p)]);
    for (int i = k + 1; i < 6; ++i) {
      const double f = a[i][k] / a[k][k];
      for (int j = k; j < 6; ++j)
        a[i][j] -= f * a[k][j];
      b[std::size_t(i)] -= f * b[std::size_t(k)];
    }
  }
  for (int k = 5; k >= 0; --k) {
    for (int j = k + 1; j < 6; ++j)
      b[std::size_t(k)] -= a[k][j] * b[std::size_t(j)];
    b[std::size_t(k)] /= a[k][k];
  }
  return b;
}

/// A body that nothing acts on, stepped by Newton's method with the tangent that is tested.
struct Flight {
  Inertia inertia;
  Vec3 place = Vec3::zero();
  int iterations = 0;

  Flight(const Mass& mass, double radius, const Vec3& velocity, const Vec3& spin)
      : inertia(mass, TimeIntegration::with_spectral_radius(radius), {}, false) {
    inertia.start(place, Mat3::identity(), velocity, spin);
    const Inertia::Tangent k = inertia.tangent(); // the mass
    accelerate(k);
  }

  void accelerate(const Inertia::Tangent& k) {
    const auto a = newton(k);
    inertia.accelerate({{a[0], a[1], a[2]}}, {{a[3], a[4], a[5]}});
  }

  std::array<double, 6> newton(const Inertia::Tangent& k) const {
    double a[6][6];
    std::array<double, 6> b{};
    const Vec3 f = inertia.force(), m = inertia.moment();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        a[i][j] = k.force_by_displacement[i][j];
        a[i][3 + j] = k.force_by_rotation[i][j];
        a[3 + i][j] = k.moment_by_displacement[i][j];
        a[3 + i][3 + j] = k.moment_by_rotation[i][j];
      }
      b[std::size_t(i)] = -f[i];
      b[std::size_t(3 + i)] = -m[i];
    }
    return solve(a, b);
  }

  void step(double dt) {
    const Mat3 start = inertia.accepted_rotation();
    Vec3 u = place, w = Vec3::zero();
    for (int k = 0; k < 12; ++k) {
      inertia.move(dt, u, rigid::rotation(w) * start, w);
      if (norm(inertia.force()) + norm(inertia.moment()) < 1e-11)
        break;
      const auto d = newton(inertia.tangent());
      u += Vec3{{d[0], d[1], d[2]}};
      w += Vec3{{d[3], d[4], d[5]}};
      iterations = std::max(iterations, k + 1);
    }
    inertia.accept();
    place = u;
  }
};

} // namespace

// A symmetric top without moments: its axis goes round the angular momentum L at the rate L/I1.
TEST(RigidInertia, SymmetricTopPrecesses) {
  const Vec3 moments{{1.0, 1.0, 1.6}}, spin{{0.6, 0.0, 1.5}};
  const Vec3 L{{0.6, 0.0, 2.4}};
  for (const double radius : {1.0, 0.6}) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
      Flight top(body(moments), radius, Vec3::zero(), spin);
      const int steps = 100 << k;
      for (int i = 0; i < steps; ++i)
        top.step(5.0 / steps);
      EXPECT_LE(top.iterations, 6);
      const Vec3 axis = top.inertia.accepted_rotation() * Vec3{{0.0, 0.0, 1.0}};
      const Vec3 expected = rigid::rotation(5.0 * L) * Vec3{{0.0, 0.0, 1.0}};
      error[k] = norm(axis - expected);
      EXPECT_LT(norm(top.inertia.angular_momentum(top.place) - L), 1e-11);
      if (radius == 1.0) {
        EXPECT_NEAR(top.inertia.kinetic_energy(), 0.5 * (0.36 + 3.6), 1e-11);
      }
    }
    EXPECT_GT(error[1], 1e-6);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1) << radius;
  }
}

// About the middle axis a body tumbles over and over: momentum and energy stay to rounding over
// thousands of steps, each solved to 1e-11.
TEST(RigidInertia, MiddleAxisTumbles) {
  const Vec3 spin{{0.001, 2.0, 0.0}};
  Flight racket(body({{1.0, 2.0, 3.0}}), 1.0, {{0.03, 0.0, 0.01}}, spin);
  const double energy = racket.inertia.kinetic_energy();
  const Vec3 L = racket.inertia.angular_momentum(racket.place);
  int turns = 0;
  double last = 1.0;
  const int steps = 4000;
  const double dt = 0.025;
  for (int i = 0; i < steps; ++i) {
    racket.step(dt * (1.0 + 0.3 * std::sin(i))); // steps need not be alike
    const double now =
        (transpose(racket.inertia.accepted_rotation()) * racket.inertia.angular_velocity())[1];
    turns += now * last < 0.0;
    last = now;
    ASSERT_NEAR(racket.inertia.kinetic_energy(), energy, 1e-9 * energy);
    ASSERT_LT(norm(racket.inertia.angular_momentum(racket.place) - L), steps * dt * 2e-11);
  }
  EXPECT_GE(turns, 4);
}

// The center need not be the center of mass: that one flies straight on.
TEST(RigidInertia, CenterOfMassFliesStraight) {
  const Vec3 arm{{0.4, -0.3, 0.2}}, velocity{{0.5, 0.1, -0.2}}, spin{{0.7, 0.4, 1.1}};
  double error[2];
  for (int k = 0; k < 2; ++k) {
    Flight flight(body({{1.0, 1.5, 2.2}}, arm), 1.0, velocity, spin);
    const Vec3 p = flight.inertia.linear_momentum();
    EXPECT_LT(norm(p - 2.0 * (velocity + cross(spin, arm))), 1e-15);
    const int steps = 60 << k;
    for (int i = 0; i < steps; ++i)
      flight.step(3.0 / steps);
    EXPECT_LT(norm(flight.inertia.linear_momentum() - p), 1e-10);
    const Vec3 at = flight.place + flight.inertia.accepted_rotation() * arm;
    error[k] = norm(at - arm - 1.5 * p);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1);
}

TEST(RigidInertia, TangentIsTheDerivative) {
  for (const bool held : {false, true}) {
    Mass mass = body({{1.0, 1.5, 2.2}}, {{0.4, -0.3, 0.2}});
    mass.inertia[0][1] = mass.inertia[1][0] = 0.2;
    Inertia inertia(mass, TimeIntegration::with_spectral_radius(0.5), {held, false, held}, false);
    inertia.start(Vec3::zero(), Mat3::identity(), {{0.5, 0.1, -0.2}}, {{0.7, 0.4, 1.1}});
    const Vec3 first{{0.3, -0.4, 0.2}};
    inertia.move(0.4, {{0.1, 0.2, -0.1}}, rigid::rotation(first), first);
    inertia.accept();
    const Mat3 start = inertia.accepted_rotation();
    const Vec3 u{{0.2, 0.5, -0.3}}, w{{0.6, 0.3, -0.5}};
    const auto at = [&](const Vec3& du, const Vec3& dw, Vec3& f, Vec3& m) {
      inertia.move(0.7, u + du, rigid::rotation(w + dw) * start, w + dw);
      f = inertia.force();
      m = inertia.moment();
    };
    Vec3 f, m;
    at(Vec3::zero(), Vec3::zero(), f, m);
    const Inertia::Tangent k = inertia.tangent();
    const double h = 1e-6;
    for (int j = 0; j < 6; ++j) {
      Vec3 d[2] = {Vec3::zero(), Vec3::zero()}, more[2], less[2];
      d[j / 3][j % 3] = h;
      at(d[0], d[1], more[0], more[1]);
      at(-d[0], -d[1], less[0], less[1]);
      for (int i = 0; i < 3; ++i) {
        const Mat3& kf = j < 3 ? k.force_by_displacement : k.force_by_rotation;
        const Mat3& km = j < 3 ? k.moment_by_displacement : k.moment_by_rotation;
        EXPECT_NEAR(kf[i][j % 3], (more[0][i] - less[0][i]) / (2 * h), 1e-8);
        EXPECT_NEAR(km[i][j % 3], (more[1][i] - less[1][i]) / (2 * h), 1e-8);
      }
    }
  }
}
