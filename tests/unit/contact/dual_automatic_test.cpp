// SPDX-License-Identifier: BSD-3-Clause
// Residual and tangent of the nodal law against the law written down a second time and
// differentiated automatically, from displacements to forces.
#include <Sacado.hpp>

namespace abut {
using Fad = Sacado::Fad::DFad<double>;
inline double value_of(const Fad& x) {
  return x.val();
}
} // namespace abut

#include "dual_reference.hpp"
#include "dual_scene.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualReference;
using abut::contact::testing::DualScene;
using abut::contact::testing::Faces;
using abut::contact::testing::faces_of_both_averages;
using abut::contact::testing::is_symmetric;
using abut::contact::testing::options;
using fem::FaceType;

namespace {

constexpr double rounding = 1e-12; ///< of sums over some hundred points, relative

/// The interface and its reference, moved through the same history.
struct Twins {
  DualScene scene;
  DualReference reference;

  Twins(const Faces& f, double friction, double depth, double wave = 0.06, double turn = 0.3)
      : scene(f.primary, f.secondary, options(f, friction), depth, 3, wave, turn),
        reference(scene.upper, scene.lower, options(f, friction)) {}

  void move(double size, const Vec3& shift, double phase) {
    scene.move(size, shift, phase);
    compare();
  }
  void compare() {
    scene.system.evaluate(*scene.pair, false);
    const auto r = reference.residual(scene.system.u);
    double error = 0.0, most = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      error = std::max(error, std::fabs(r[i] - scene.system.residual[i]));
      most = std::max(most, std::fabs(r[i]));
    }
    EXPECT_LE(error, rounding * most);
  }
  void augment() {
    scene.pair->augment();
    reference.augment(scene.system.u);
    scene.system.evaluate(*scene.pair, false);
    scene.pair->iterate_taken(); // until then the status is held
    compare();
  }
  void accept() {
    scene.pair->accept();
    reference.accept(scene.system.u);
  }

  int closed() const {
    return reference.count(DualReference::frictionless) + reference.count(DualReference::stick) +
           reference.count(DualReference::slip);
  }

  /// Largest difference of the tangents over the largest entry.
  double tangent_error() {
    scene.system.evaluate(*scene.pair, true);
    const std::size_t n = scene.system.u.size();
    std::vector<Fad> u;
    for (std::size_t i = 0; i < n; ++i)
      u.emplace_back(int(n), int(i), scene.system.u[i]);
    const std::vector<Fad> r = reference.residual(u);
    double error = 0.0, most = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double exact = r[i].hasFastAccess() ? r[i].dx(int(j)) : 0.0;
        error = std::max(error, std::fabs(exact - scene.system.tangent[i * n + j]));
        most = std::max(most, std::fabs(exact));
      }
    EXPECT_GT(most, 0.01);
    return error / most;
  }

  double asymmetry() const {
    const std::size_t n = scene.system.u.size();
    double error = 0.0, most = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double k = scene.system.tangent[i * n + j];
        error = std::max(error, std::fabs(k - scene.system.tangent[j * n + i]));
        most = std::max(most, std::fabs(k));
      }
    return error / most;
  }
};

class DualAutomatic : public ::testing::TestWithParam<Faces> {};
INSTANTIATE_TEST_SUITE_P(Faces, DualAutomatic, ::testing::ValuesIn(faces_of_both_averages()));

} // namespace

TEST_P(DualAutomatic, WithoutFriction) {
  Twins t(GetParam(), 0.0, 0.06);
  t.move(0.01, {{0.02, 0.01, 0.0}}, 0.0);
  t.augment();
  t.move(0.02, {{0.02, 0.01, 0.02}}, 0.5);
  EXPECT_GT(t.closed(), 3);
  EXPECT_GT(t.reference.count(DualReference::open), 0);
  EXPECT_LT(t.tangent_error(), rounding);
  if (is_symmetric(GetParam())) {
    EXPECT_LT(t.asymmetry(), 1e-12);
  }
}

TEST_P(DualAutomatic, Overhanging) {
  for (const double friction : {0.0, 0.3}) {
    Twins t(GetParam(), friction, 0.1);
    t.move(0.01, {{0.7, 0.45, 0.0}}, 0.0);
    t.augment();
    t.accept();
    t.move(0.015, {{0.71, 0.46, 0.0}}, 0.2);
    EXPECT_GT(t.reference.count(DualReference::uncovered), 0);
    if (GetParam().formulation != Formulation::node_on_facet) {
      EXPECT_GT(t.reference.count(DualReference::merged), 0);
    }
    EXPECT_GT(t.closed(), 3);
    EXPECT_LT(t.tangent_error(), rounding);
    if (friction == 0.0 && is_symmetric(GetParam())) {
      EXPECT_LT(t.asymmetry(), 1e-12);
    }
  }
}

TEST_P(DualAutomatic, StickAndSlipAndOpen) {
  Twins t(GetParam(), 0.35, 0.06);
  t.move(0.01, {{0.02, 0.01, 0.0}}, 0.0);
  t.augment();
  t.move(0.01, {{0.02, 0.01, -0.01}}, 0.0);
  t.accept();
  t.move(0.012, {{0.024, 0.02, -0.01}}, 0.1);
  t.augment(); // with shear that turns from here on
  t.accept();
  t.move(0.014, {{0.026, 0.026, 0.0}}, 0.2);
  EXPECT_GT(t.reference.count(DualReference::stick), 0);
  EXPECT_GT(t.reference.count(DualReference::slip), 0);
  if (GetParam().weighted_gap == WeightedGap::dual) { // with N none opens here
    EXPECT_GT(t.reference.count(DualReference::open), 0);
  }
  EXPECT_LT(t.tangent_error(), rounding);
}

// Nodes that come into contact in the step: their slip counts from there.
TEST_P(DualAutomatic, FirstContact) {
  Twins t(GetParam(), 1.0, -0.2);
  t.move(0.0, Vec3::zero(), 0.0);
  EXPECT_EQ(t.closed(), 0);
  t.accept();
  t.move(0.02, {{0.03, 0.03, -0.25}}, 0.4);
  EXPECT_GT(t.closed(), 3);
  EXPECT_LT(t.tangent_error(), rounding);
}

// With multipliers read from the corners law and tangent are those of the theory, which
// Tangent::automatic differentiates point by point.
TEST_P(DualAutomatic, SmoothedIsTheTheorysTangent) {
  for (const double friction : {0.0, 0.35}) {
    ContactOptions o = options(GetParam(), friction);
    o.multipliers = Multipliers::smoothed;
    o.weighted_gap = WeightedGap::dual; // theirs is another
    std::vector<double> tangent[2];
    for (const bool automatic : {false, true}) {
      o.tangent = automatic ? Tangent::automatic : Tangent::analytic;
      DualScene s(GetParam().primary, GetParam().secondary, o, 0.06, 3, 0.06, 0.3);
      s.move(0.01, {{0.02, 0.01, 0.0}}, 0.0);
      s.system.evaluate(*s.pair, false);
      s.pair->augment();
      s.system.evaluate(*s.pair, false);
      s.pair->accept();
      s.move(0.014, {{0.03, 0.025, 0.0}}, 0.2);
      s.system.evaluate(*s.pair, true);
      tangent[automatic] = s.system.tangent;
      double least = 1e300, most = 0.0;
      for (const Site& p : s.pair->points().sites())
        if (p.state.pressed()) {
          least = std::min(least, p.multiplier);
          most = std::max(most, p.multiplier);
        }
      EXPECT_GT(most, 2.0 * least + 1e-3);
      EXPECT_GT(s.pair->summary().active_points, 3);
    }
    double error = 0.0, most = 0.0;
    for (std::size_t i = 0; i < tangent[0].size(); ++i) {
      error = std::max(error, std::fabs(tangent[0][i] - tangent[1][i]));
      most = std::max(most, std::fabs(tangent[1][i]));
    }
    EXPECT_GT(most, 0.01);
    EXPECT_LT(error, rounding * most);
  }
}
