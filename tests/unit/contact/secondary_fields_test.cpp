// SPDX-License-Identifier: BSD-3-Clause
// What the secondary shows: its nodal tractions times the areas of its corners balance the
// primary's force, whatever the faces; a uniform pressure stays uniform where the meshes match.
#include "dual_scene.hpp"

#include <gtest/gtest.h>
#include <tuple>

using namespace abut;
using namespace abut::contact;
using abut::contact::testing::DualScene;
using abut::contact::testing::Faces;

namespace {

using Case = std::tuple<Faces, Multipliers, double>; ///< ..., friction

class SecondaryFields : public ::testing::TestWithParam<Case> {
protected:
  static DualScene make() {
    const auto& [faces, multipliers, friction] = GetParam();
    ContactOptions o = abut::contact::testing::options(faces, friction);
    o.multipliers = multipliers;
    return DualScene(faces.primary, faces.secondary, o, 0.03, 3, 0.02, 0.2);
  }
};
INSTANTIATE_TEST_SUITE_P(
    Cases, SecondaryFields,
    ::testing::Combine(::testing::ValuesIn(abut::contact::testing::all_faces()),
                       ::testing::Values(Multipliers::per_point, Multipliers::smoothed,
                                         Multipliers::dual),
                       ::testing::Values(0.0, 0.3)));

/// Whether a surface node is a corner of its faces.
std::vector<bool> corners_of(const mesh::Surface& s) {
  std::vector<bool> corner(s.node.size(), false);
  for (Local f = 0; f < s.num_faces(); ++f)
    for (int a = 0; a < fem::face_corners(s.type[std::size_t(f)]); ++a)
      corner[std::size_t(s.nodes[std::size_t(s.offset[std::size_t(f)] + a)])] = true;
  return corner;
}

} // namespace

TEST_P(SecondaryFields, BalanceThePrimary) {
  DualScene scene = make();
  scene.system.evaluate(*scene.pair, false, 0.0);
  scene.pair->accept();
  scene.move(0.01, {{0.02, 0.01, -0.01}});
  scene.system.evaluate(*scene.pair, false);
  ASSERT_GT(scene.pair->summary().active_points, 4);
  Vec3 force = Vec3::zero(), shown = Vec3::zero();
  for (const Global n : scene.upper.node)
    for (int i = 0; i < 3; ++i)
      force[i] -= scene.system.residual[std::size_t(3 * n + i)];
  const NodalSums s = scene.pair->nodal_sums(Side::secondary);
  const std::vector<bool> corner = corners_of(scene.lower);
  double pressure = 0.0;
  for (std::size_t n = 0; n < corner.size(); ++n) {
    EXPECT_GE(s.pressure[n], 0.0);
    EXPECT_EQ(s.pressure[n] > 0.0, s.pressed[n] > 0.0);
    pressure += s.pressure[n];
    for (int i = 0; corner[n] && i < 3; ++i)
      shown[i] += s.traction[3 * n + std::size_t(i)];
  }
  EXPECT_GT(pressure, 0.0);
  EXPECT_LT(norm(shown + force), 1e-12 * norm(force));
}

namespace {

/// A plate on a plate of the same 3 x 3 faces, pushed in by a tenth.
struct Matching {
  explicit Matching(ContactOptions o)
      : upper(abut_test::grid_surface(3, 3, 0, 1, 0, 1, true, 0)),
        lower(abut_test::grid_surface(3, 3, 0, 1, 0, 1, false, 16, {}, 100)), system(32, 3),
        pair(Comm(MPI_COMM_WORLD), upper, lower, (o.penalty = 10.0, o), timers) {
    for (std::size_t n = 0; n < 16; ++n)
      system.u[3 * n + 2] = -0.1;
    system.evaluate(pair, false);
  }

  mesh::Surface upper, lower;
  PhaseTimers timers;
  abut_test::DenseSystem system;
  Interaction pair;
};

} // namespace

TEST(SecondaryFields, AreUniformWhereMeshesMatch) {
  for (Formulation f :
       {Formulation::node_on_facet, Formulation::facet_on_facet, Formulation::sliding_elastic}) {
    ContactOptions o;
    o.formulation = f;
    const Matching plates(o);
    const NodalSums s = plates.pair.nodal_sums(Side::secondary), p = plates.pair.nodal_sums();
    for (std::size_t n = 0; n < 16; ++n) {
      EXPECT_NEAR(s.pressure[n] / s.weight[n], 1.0, 1e-12);
      EXPECT_NEAR(s.traction[3 * n + 2] / s.weight[n], -1.0, 1e-12);
      EXPECT_NEAR(p.traction[3 * n + 2] / p.weight[n], 1.0, 1e-12);
      EXPECT_NEAR(s.gap[n] / s.seen[n], -0.1, 1e-12);
      EXPECT_EQ(s.status[n], s.pressed[n]); // slips everywhere
    }
  }
}
