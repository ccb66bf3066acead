// SPDX-License-Identifier: BSD-3-Clause
// A0.3: a uniform gap is imposed; the nodal forces on the secondary are compared with the exact
// integrals of its shape functions. The defect is a property of the mesh ratio and the rule.
#include "abut/contact/interaction.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;

namespace {

/// Largest relative error of the secondary nodal forces for a strip of n1 over one of n2 facets.
double defect(int n1, int n2, int points) {
  PhaseTimers timers;
  contact::ContactOptions o;
  o.name = "strip";
  o.penalty = 1.0;
  o.points = points;
  auto primary =
      abut_test::grid_surface(n1, 1, 0, 1, 0, 1, true, 0, [](double* x) { x[2] = -0.01; });
  auto secondary = abut_test::grid_surface(n2, 1, 0, 1, 0, 1, false, primary.num_nodes(), {}, 1000);
  abut_test::DenseSystem system(primary.num_nodes() + secondary.num_nodes(), 3);
  contact::Interaction pair(Comm(MPI_COMM_WORLD), primary, secondary, o, timers);
  system.evaluate(pair, false);
  double worst = 0.0;
  for (int b = 0; b < secondary.num_nodes(); ++b) {
    const int i = b % (n2 + 1);
    const double exact = 0.01 * 0.5 * (i == 0 || i == n2 ? 0.5 : 1.0) / n2;
    const double force = system.residual[std::size_t(3 * (primary.num_nodes() + b) + 2)];
    worst = std::max(worst, std::fabs(force / exact - 1.0));
  }
  return worst;
}

} // namespace

TEST(QuadratureDefect, MatchesTheTableOfMeshRatios) {
  struct Row {
    int n1, n2;
    double q[6];
  };
  const Row table[] = {{3, 2, {.1111, .0172, .0155, .0047, .0061, .0022}},
                       {2, 3, {.2500, .0245, .0258, .0386, .0131, .0015}},
                       {4, 3, {.0625, .0061, .0064, .0096, .0033, .0004}},
                       {3, 4, {.3333, .1111, .0864, .0184, .0153, .0064}},
                       {5, 3, {.0400, .0039, .0041, .0062, .0021, .0002}},
                       {3, 5, {.4444, .1352, .0129, .0066, .0181, .0140}},
                       {2, 8, {3.0, 1.0, .778, .165, .138, .058}}};
  for (const Row& row : table)
    for (int q = 1; q <= 6; ++q)
      EXPECT_NEAR(defect(row.n1, row.n2, q), row.q[q - 1], row.q[q - 1] > 0.05 ? 5.1e-4 : 5.1e-5)
          << row.n1 << ':' << row.n2 << " q" << q;
}

TEST(QuadratureDefect, VanishesForMatchingAndNestedPrimary) {
  for (int q = 2; q <= 6; ++q) {
    EXPECT_LT(defect(3, 3, q), 1e-13);
    EXPECT_LT(defect(8, 2, q), 1e-13);
  }
}
