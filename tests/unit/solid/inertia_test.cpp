// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/quadrature.hpp"
#include "abut/solid/mass.hpp"
#include "abut/solid/mass_kernel.hpp"
#include "abut/solid/nodal_motion.hpp"
#include "small_mesh.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using fem::CellType;

namespace {

constexpr CellType cells[] = {CellType::hex8, CellType::hex20, CellType::hex27,
                              CellType::tet4, CellType::tet10, CellType::wedge6};

std::vector<double> flat(const std::vector<Vec3>& x) {
  std::vector<double> out;
  for (const Vec3& p : x)
    out.insert(out.end(), p.v, p.v + 3);
  return out;
}

/// As the kernel has it; x: (n,3).
std::vector<double> element_mass(CellType type, const std::vector<double>& x, double density) {
  std::vector<double> m(static_cast<std::size_t>(solid::mass_size(fem::info(type).nodes)));
  fem::dispatch_cell(type, [&](auto shape) {
    constexpr int n = decltype(shape)::nodes;
    double by_component[3][n];
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        by_component[i][a] = x[std::size_t(3 * a + i)];
    solid::element_mass(solid::MassCell<decltype(shape)::type>(), by_component, density, m.data());
  });
  return m;
}

/// Mass by the highest rule there is.
std::vector<double> fine_mass(CellType type, const std::vector<double>& x, double density) {
  std::vector<double> m(static_cast<std::size_t>(solid::mass_size(fem::info(type).nodes)), 0.0);
  const fem::Rule<3> rule = fem::cell_rule(type, fem::max_points_per_direction);
  fem::dispatch_cell(type, [&](auto shape) {
    constexpr int n = decltype(shape)::nodes;
    for (int p = 0; p < rule.size(); ++p) {
      double N[n], dN[n][3];
      shape.values(rule.xi[p].data(), N);
      shape.derivatives(rule.xi[p].data(), dN);
      Mat3 j = Mat3::zero();
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k)
            j[i][k] += x[std::size_t(3 * a + i)] * dN[a][k];
      for (int a = 0; a < n; ++a)
        for (int b = 0; b <= a; ++b)
          m[std::size_t(solid::mass_index(a, b))] +=
              density * rule.weight[p] * det(j) * N[a] * N[b];
    }
  });
  return m;
}

/// One step of a vibration of frequency 1 over dt, as the equation of motion has it.
struct Vibration {
  TimeIntegration rule;
  double dt, u = 0.0, v = 0.0, a = 0.0;

  void step() {
    // Linear in u': solved by two evaluations.
    const auto equation = [&](double next) {
      const Rates r = rule.newmark(dt, next - u, {v, a});
      return next + rule.past_force() * u + rule.inertia() * r.acceleration +
             rule.past_inertia() * a;
    };
    const double at_zero = equation(0.0), next = at_zero / (at_zero - equation(1.0));
    const Rates r = rule.newmark(dt, next - u, {v, a});
    u = next;
    v = r.velocity;
    a = r.acceleration;
  }
};

} // namespace

// A random straight-edged form of every cell: the rule integrates the mass exactly.
TEST(Mass, ExactForEveryCell) {
  std::mt19937 engine(7);
  for (const CellType type : cells)
    for (int i = 0; i < 5; ++i) {
      const auto x = flat(test::straight_nodes(type, test::distorted_corners(type, 0.15, engine)));
      const std::vector<double> fine = fine_mass(type, x, 2.5);
      const std::vector<double> m = element_mass(type, x, 2.5);
      double largest = 0.0;
      for (const double value : fine)
        largest = std::max(largest, std::fabs(value));
      for (std::size_t k = 0; k < m.size(); ++k)
        EXPECT_NEAR(m[k], fine[k], 1e-13 * largest) << fem::info(type).name;
    }
}

// Entries in closed form: products of those of lines, triangles and tetrahedra.
TEST(Mass, LinearCells) {
  const double density = 3.0;
  for (const CellType type : {CellType::hex8, CellType::tet4, CellType::wedge6}) {
    const int n = fem::info(type).nodes;
    std::vector<double> x(3 * std::size_t(n));
    for (int a = 0; a < n; ++a)
      fem::dispatch_cell(type, [&](auto s) { decltype(s)::node(a, &x[3 * std::size_t(a)]); });
    const std::vector<double> m = element_mass(type, x, density);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        double expected = density;
        const auto same = [&](std::size_t i) {
          return x[3 * std::size_t(a) + i] == x[3 * std::size_t(b) + i];
        };
        if (type == CellType::tet4) // V/20 off the diagonal, V = 1/6
          expected *= (a == b ? 2.0 : 1.0) / 120.0;
        if (type == CellType::hex8) // lines of length 2
          for (std::size_t i = 0; i < 3; ++i)
            expected *= same(i) ? 2.0 / 3.0 : 1.0 / 3.0;
        if (type == CellType::wedge6) // A/12 off the diagonal, A = 1/2
          expected *= (a % 3 == b % 3 ? 2.0 : 1.0) / 24.0 * (same(2) ? 2.0 / 3.0 : 1.0 / 3.0);
        EXPECT_NEAR(m[std::size_t(solid::mass_index(a, b))], expected, 1e-15 * density)
            << fem::info(type).name << ' ' << a << ' ' << b;
      }
  }
}

// A uniform velocity and a spin have the momentum and the energy of the body that moves so.
TEST(Mass, MomentumOfRigidMotion) {
  std::mt19937 engine(3);
  const Vec3 shift{{0.4, -0.2, 0.7}}, spin{{0.3, 0.8, -0.5}};
  for (const CellType type : cells) {
    const int n = fem::info(type).nodes;
    const auto nodes = test::straight_nodes(type, test::distorted_corners(type, 0.1, engine));
    const mesh::Mesh mesh = test::separate_elements(type, {nodes});
    const solid::MassProperties p = solid::mass_properties(mesh, {0}, 1.5);
    const std::vector<double> m = element_mass(type, flat(nodes), 1.5);
    Vec3 linear = Vec3::zero(), angular = Vec3::zero();
    double energy = 0.0;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        const double mass = m[std::size_t(solid::mass_index(a, b))];
        const Vec3 v = shift + cross(spin, nodes[std::size_t(b)] - p.center);
        linear += mass * v;
        angular += mass * cross(nodes[std::size_t(a)] - p.center, v);
        energy += 0.5 * mass * dot(shift + cross(spin, nodes[std::size_t(a)] - p.center), v);
      }
    EXPECT_GT(p.mass, 0.1);
    EXPECT_LT(norm(linear - p.mass * shift), 1e-14 * p.mass);
    EXPECT_LT(norm(angular - p.inertia * spin), 1e-14 * p.mass);
    EXPECT_NEAR(energy, 0.5 * (p.mass * dot(shift, shift) + dot(spin, p.inertia * spin)),
                1e-14 * p.mass);
  }
}

// Infinitely fast vibrations shrink by the spectral radius in each step: for generalised-alpha the
// three eigenvalues of a step are then all minus the radius.
TEST(TimeIntegration, SpectralRadius) {
  for (const double radius : {0.0, 0.3, 0.5, 0.8, 0.95}) {
    const auto rule = TimeIntegration::with_spectral_radius(radius);
    EXPECT_NEAR(rule.gamma, 0.5 - rule.alpha_m + rule.alpha_f, 1e-15); // second order
    const double dt = 1e6;
    Mat3 step; // of (u, dt v, dt^2 a), which grow alike
    for (int j = 0; j < 3; ++j) {
      Vibration one{rule, dt, j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 / dt : 0.0,
                    j == 2 ? 1.0 / (dt * dt) : 0.0};
      one.step();
      step[0][j] = one.u;
      step[1][j] = one.v * dt;
      step[2][j] = one.a * dt * dt;
    }
    EXPECT_NEAR(step[0][0] + step[1][1] + step[2][2], -3.0 * radius, 1e-9);
    EXPECT_NEAR(det(step), -radius * radius * radius, 1e-9);
  }
  const auto trapezoidal = TimeIntegration::with_spectral_radius(1.0);
  EXPECT_EQ(trapezoidal.beta, 0.25);
  EXPECT_EQ(trapezoidal.gamma, 0.5);
  EXPECT_FALSE(trapezoidal.has_past());
}

TEST(TimeIntegration, OrderTwoAndEnergy) {
  for (const double radius : {0.0, 0.5, 0.8, 1.0}) {
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const int steps = 200 << k;
      Vibration x{TimeIntegration::with_spectral_radius(radius), 10.0 / steps, 1.0, 0.0, -1.0};
      for (int i = 0; i < steps; ++i)
        x.step();
      error[k] = std::hypot(x.u - std::cos(10.0), x.v + std::sin(10.0));
      if (radius == 1.0)
        EXPECT_NEAR(x.u * x.u + x.v * x.v, 1.0, steps * steps * 1e-16); // v by steps of dt a/2
      else
        EXPECT_LT(x.u * x.u + x.v * x.v, 1.0 - 1e-7);
    }
    EXPECT_GT(error[1], 1e-5);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.05) << radius;
  }
}

// Led numbers: what is quadratic in time is differentiated exactly, whatever the steps. A state
// that is not accepted leaves nothing.
TEST(NodalMotion, LedNumbers) {
  solid::NodalMotion motion(TimeIntegration(), {solid::Lead::prescribed, solid::Lead::free});
  const auto u = [](double t) { return 1.0 + 2.0 * t - 1.5 * t * t; };
  motion.start(0.0, {1.0, 0.0}, {2.0, 0.0});
  motion.set_acceleration({-3.0, 0.0});
  for (const double t : {0.1, 0.35, 0.4, 1.0}) {
    const double wrong[2] = {7.0, -5.0};
    motion.move(2.0 * t, wrong);
    const double right[2] = {u(t), 0.0};
    motion.move(t, right);
    EXPECT_NEAR(motion.velocity()[0], 2.0 - 3.0 * t, 1e-13);
    EXPECT_NEAR(motion.acceleration()[0], -3.0, 1e-12);
    EXPECT_EQ(motion.acceleration()[1], 0.0);
    motion.accept();
    motion.move(t, wrong); // no time goes by
    EXPECT_NEAR(motion.velocity()[0], 2.0 - 3.0 * t, 1e-13);
    EXPECT_EQ(motion.slopes()(0), 1.0);
  }
}

// After a kink the rates of a led number come to rest.
TEST(NodalMotion, KinkDiesOut) {
  solid::NodalMotion motion(TimeIntegration(), {solid::Lead::rigid});
  double t = 0.0, at_once = 0.0;
  for (int i = 0; i < 20; ++i) {
    t += 0.1;
    const double u = std::min(t, 0.5);
    motion.move(t, &u);
    motion.accept();
    at_once = std::max(at_once, std::fabs(motion.acceleration()[0]));
  }
  EXPECT_GT(at_once, 5.0);
  EXPECT_LT(std::fabs(motion.velocity()[0]), 1e-12);
  EXPECT_LT(std::fabs(motion.acceleration()[0]), 1e-10);
}

TEST(NodalMotion, SlopeIsTheDerivative) {
  for (const double radius : {0.4, 1.0}) {
    solid::NodalMotion motion(TimeIntegration::with_spectral_radius(radius),
                              {solid::Lead::free, solid::Lead::prescribed});
    motion.start(0.0, {0.0, 0.0}, {1.0, -1.0});
    const double first[2] = {0.2, -0.1};
    motion.move(0.3, first);
    motion.accept();
    double a[2][2];
    for (int k = 0; k < 2; ++k) {
      const double u[2] = {0.3 + k, 0.1 + k};
      motion.move(0.5, u);
      for (std::size_t i = 0; i < 2; ++i)
        a[k][i] = motion.acceleration()[i];
    }
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(a[1][i] - a[0][i], motion.slopes()(i), 1e-12 * motion.slopes()(i));
  }
}
