// SPDX-License-Identifier: BSD-3-Clause
// The tangent of the nodal law against central differences of its residual.
#include "dual_scene.hpp"

#include <gtest/gtest.h>
#include <iostream>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut::contact::testing::Faces;
using abut::contact::testing::faces_of_both_averages;
using abut::contact::testing::is_symmetric;
using abut::contact::testing::options;
using fem::FaceType;

namespace {

/// Largest difference of the tangent to central differences over its largest entry.
double tangent_error(DualScene& s) {
  s.system.evaluate(*s.pair, true);
  const std::vector<double> k = s.system.tangent;
  const std::size_t n = s.system.u.size();
  double error = 0.0, size = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    const double u = s.system.u[j], h = 1e-6;
    s.system.u[j] = u + h;
    s.system.evaluate(*s.pair, false);
    const std::vector<double> plus = s.system.residual;
    s.system.u[j] = u - h;
    s.system.evaluate(*s.pair, false);
    s.system.u[j] = u;
    for (std::size_t i = 0; i < n; ++i) {
      error = std::max(error, std::fabs(k[i * n + j] - (plus[i] - s.system.residual[i]) / (2 * h)));
      size = std::max(size, std::fabs(k[i * n + j]));
    }
  }
  EXPECT_GT(size, 0.01);
  return error / size;
}

double asymmetry(const DualScene& s) {
  const std::size_t n = s.system.u.size();
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      error = std::max(error, std::fabs(s.system.tangent[i * n + j] - s.system.tangent[j * n + i]));
      size = std::max(size, std::fabs(s.system.tangent[i * n + j]));
    }
  return error / size;
}

class DualTangent : public ::testing::TestWithParam<Faces> {};
INSTANTIATE_TEST_SUITE_P(Faces, DualTangent, ::testing::ValuesIn(faces_of_both_averages()));

} // namespace

// Rounding of the residual, some 1e-16 of forces of 1e-2, over the step of 1e-6; h^2 is below.
constexpr double tolerance = 2e-8;

TEST_P(DualTangent, WithoutFriction) {
  DualScene s(GetParam().primary, GetParam().secondary, options(GetParam()));
  s.move(0.01, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  s.pair->augment();
  s.move(0.02, {{0.02, 0.01, 0.0}}, 0.5);
  s.pair->iterate_taken(); // until then the status is held
  s.system.evaluate(*s.pair, true);
  EXPECT_GT(s.pair->summary().active_points, 10);
  EXPECT_LT(tangent_error(s), tolerance);
  EXPECT_EQ(s.pair->symmetric(), is_symmetric(GetParam()));
  if (is_symmetric(GetParam())) {
    EXPECT_LT(asymmetry(s), 1e-13);
  } else if (GetParam().formulation == Formulation::facet_on_facet) {
    EXPECT_GT(asymmetry(s), 1e-3);
  }
}

TEST_P(DualTangent, Sticking) {
  DualScene s(GetParam().primary, GetParam().secondary, options(GetParam(), 5.0), 0.1);
  s.move(0.01, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  s.pair->augment();
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.move(0.015, {{0.03, 0.02, -0.01}}, 0.2);
  s.system.evaluate(*s.pair, false);
  s.pair->accept(); // with shear that turns in the next step
  s.move(0.02, {{0.03, 0.03, -0.01}}, 0.4);
  s.system.evaluate(*s.pair, false);
  EXPECT_GT(s.pair->summary().stick_points, 10);
  EXPECT_GT(s.pair->summary().tangential, 0.01 * std::fabs(s.pair->summary().force[2]));
  EXPECT_LT(tangent_error(s), tolerance);
  EXPECT_FALSE(s.pair->symmetric());
}

TEST_P(DualTangent, Slipping) {
  DualScene s(GetParam().primary, GetParam().secondary, options(GetParam(), 0.2));
  s.move(0.01, {{0.02, 0.01, 0.0}});
  s.system.evaluate(*s.pair, false);
  s.pair->accept();
  s.move(0.015, {{0.06, 0.05, -0.02}}, 0.2);
  s.system.evaluate(*s.pair, false);
  EXPECT_GT(s.pair->summary().slip_points, 10);
  s.pair->accept();
  s.move(0.02, {{0.05, 0.1, -0.02}}, 0.4);
  s.system.evaluate(*s.pair, false);
  EXPECT_GT(s.pair->summary().slip_points, 10);
  EXPECT_LT(tangent_error(s), tolerance);
}

// Nodes that come into contact in the step: their slip counts from there.
TEST_P(DualTangent, FirstContact) {
  DualScene s(GetParam().primary, GetParam().secondary, options(GetParam(), 5.0), -0.2);
  s.move(0.0, Vec3::zero());
  s.system.evaluate(*s.pair, false);
  EXPECT_EQ(s.pair->summary().active_points, 0);
  s.pair->accept();
  s.move(0.02, {{0.03, 0.03, -0.23}}, 0.4);
  s.system.evaluate(*s.pair, false);
  EXPECT_GT(s.pair->summary().stick_points, 10);
  EXPECT_LT(tangent_error(s), tolerance);
}
