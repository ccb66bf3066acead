// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"
#include "cohesive_law.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;

namespace {

/// A rigid plate of area 1 above a plane, with glue between them.
struct GluedPlates {
  explicit GluedPlates(contact::Formulation formulation) {
    contact::ContactOptions options;
    options.name = "glue";
    options.formulation = formulation;
    options.penalty = 100.0;
    pair =
        std::make_unique<contact::Interaction>(Comm(MPI_COMM_WORLD), upper, lower, options, timers);
    pair->set_normal_law(CohesiveLaw{40.0, 0.05});
  }
  /// Force on the plate at an opening and a tilt about y.
  double force(double opening, double tilt = 0.0, bool tangent = false) {
    for (int a = 0; a < upper.num_nodes(); ++a)
      system.u[std::size_t(3 * a + 2)] = opening + tilt * upper.x[std::size_t(3 * a)];
    system.evaluate(*pair, tangent);
    double sum = 0.0;
    for (int a = 0; a < upper.num_nodes(); ++a)
      sum -= system.residual[std::size_t(3 * a + 2)];
    return sum;
  }
  mesh::Surface upper = abut_test::grid_surface(3, 3, 0, 1, 0, 1, true, 0);
  mesh::Surface lower = abut_test::grid_surface(2, 2, -1, 2, -1, 2, false, 16, {}, 100);
  PhaseTimers timers;
  abut_test::DenseSystem system{25, 3};
  std::unique_ptr<contact::Interaction> pair;
};

} // namespace

class CohesiveLawTest : public testing::TestWithParam<contact::Formulation> {};
INSTANTIATE_TEST_SUITE_P(All, CohesiveLawTest,
                         testing::Values(contact::Formulation::node_on_facet,
                                         contact::Formulation::facet_on_facet,
                                         contact::Formulation::sliding_elastic));

TEST_P(CohesiveLawTest, PullsUntilItLetsGo) {
  GluedPlates plates(GetParam());
  EXPECT_NEAR(plates.force(-0.01), 1.0, 1e-13); // penalty * penetration
  EXPECT_NEAR(plates.force(0.03), -1.2, 1e-13); // - stiffness * opening
  EXPECT_NEAR(plates.force(0.0499), -1.996, 1e-13);
  EXPECT_EQ(plates.force(0.0501), 0.0);
  EXPECT_EQ(plates.pair->summary().active_points, 0);
}

TEST_P(CohesiveLawTest, TangentIsTheDerivativeOfTheForce) {
  GluedPlates plates(GetParam());
  plates.force(0.02, 0.01, true); // all pull, each a little differently
  ASSERT_EQ(plates.pair->summary().active_points, plates.pair->summary().points);
  double stiffness = 0.0;
  for (std::size_t a = 0; a < 16; ++a)
    for (std::size_t b = 0; b < 16; ++b)
      stiffness += plates.system.tangent[(3 * a + 2) * 75 + 3 * b + 2];
  const double h = 1e-6;
  const double slope = (plates.force(0.02 + h, 0.01) - plates.force(0.02 - h, 0.01)) / (2 * h);
  EXPECT_NEAR(stiffness, -slope, 1e-7 * stiffness);
  EXPECT_NEAR(stiffness, 40.0, 0.1);
}
