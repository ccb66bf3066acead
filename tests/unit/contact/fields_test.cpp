// SPDX-License-Identifier: BSD-3-Clause
// Contact beside other fields of a node: a fourth and fifth field are left alone, and contact is
// what it is without them, bit for bit.
#include "abut_test/same_values.hpp"
#include "dual_scene.hpp"

#include <gtest/gtest.h>
#include <tuple>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut_test::DenseSystem;
using abut_test::same_values;

namespace {

using Case = std::tuple<int, Formulation, Multipliers, double>; ///< fields, ..., friction

class Fields : public ::testing::TestWithParam<Case> {
protected:
  static ContactOptions options() {
    ContactOptions o;
    o.penalty = 20.0;
    o.formulation = std::get<1>(GetParam());
    o.enforcement = Enforcement::augmented_lagrangian;
    o.multipliers = std::get<2>(GetParam());
    o.friction = std::get<3>(GetParam());
    return o;
  }
  static DualScene make() {
    return DualScene(fem::FaceType::quad4, fem::FaceType::quad8, options(), 0.05, 2, 0.04, 0.2);
  }
};

/// The displacements of a scene with other fields behind them that must not matter.
DenseSystem widened(const DenseSystem& three, int fields) {
  DenseSystem wide(three.nodes, fields);
  for (int n = 0; n < three.nodes; ++n)
    for (int f = 0; f < fields; ++f)
      wide.u[std::size_t(n * fields + f)] =
          f < 3 ? three.u[std::size_t(3 * n + f)] : 1e3 * (n + f);
  return wide;
}

/// The value for each pair of scalar rows of the wide system; zero beyond the displacements.
double entry(const DenseSystem& three, int fields, int row, int column) {
  const int f = row % fields, g = column % fields;
  const int r = 3 * (row / fields) + f, c = 3 * (column / fields) + g;
  return f < 3 && g < 3 ? three.tangent[std::size_t(r) * 3 * std::size_t(three.nodes) +
                                        std::size_t(c)]
                        : 0.0;
}

} // namespace

TEST_P(Fields, OthersAreLeftAlone) {
  const int fields = std::get<0>(GetParam());
  DualScene scene = make(), beside = make();
  DenseSystem wide = widened(scene.system, fields);
  for (const double phase : {0.0, 0.4}) { // a step that ends in contact, and into the next
    scene.move(0.01, {{phase * 0.1, 0.02, -0.02}}, phase);
    wide = widened(scene.system, fields);
    scene.system.evaluate(*scene.pair, true);
    wide.evaluate(*beside.pair, true);
    if (phase == 0.0) {
      scene.pair->accept();
      beside.pair->accept();
    }
  }
  EXPECT_GT(scene.pair->summary().active_points, 4);
  int touched = 0;
  std::vector<double> residual, tangent; // as they must be
  for (int r = 0; r < wide.nodes * fields; ++r) {
    const int f = r % fields;
    const double force =
        f < 3 ? scene.system.residual[std::size_t(3 * (r / fields) + f)] : 0.0;
    residual.push_back(force);
    touched += force != 0.0;
    for (int c = 0; c < wide.nodes * fields; ++c)
      tangent.push_back(entry(scene.system, fields, r, c));
  }
  EXPECT_TRUE(same_values(wide.residual, residual));
  EXPECT_TRUE(same_values(wide.tangent, tangent));
  EXPECT_GT(touched, 20);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Fields,
    ::testing::Combine(::testing::Values(4, 5),
                       ::testing::Values(Formulation::node_on_facet, Formulation::facet_on_facet,
                                         Formulation::sliding_elastic),
                       ::testing::Values(Multipliers::per_point, Multipliers::smoothed,
                                         Multipliers::dual),
                       ::testing::Values(0.0, 0.3)));
