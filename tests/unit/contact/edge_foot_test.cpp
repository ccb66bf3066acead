// SPDX-License-Identifier: BSD-3-Clause
// Points behind re-entrant edges and corners of the secondary, which project on none of its faces:
// their derivatives by automatic differentiation, and that what pushes them has no jump.
#include <Sacado.hpp>

namespace abut {
using Fad = Sacado::Fad::SFad<double, 81>;
inline double value_of(const Fad& x) {
  return x.val();
}
} // namespace abut

#include "abut/contact/interaction.hpp"
#include "abut/contact/node_columns.hpp"
#include "abut/search/meet_face.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"
#include "point_cases.hpp"

#include <mpi.h>

using namespace abut;
using namespace abut::contact;
using namespace abut::contact::testing;
using abut_test::DenseSystem;
using abut_test::grid_surface;

namespace {

std::vector<double> automatic(const Case& s) {
  const int n = 3 * s.columns();
  std::vector<Vec<Fad, 3>> u(18);
  for (int a = 0; a < s.columns(); ++a)
    for (int i = 0; i < 3; ++i)
      u[std::size_t(a)][i] =
          Fad(81, 3 * a + i, a < s.n1 ? s.x[std::size_t(a)][i] : s.y[std::size_t(a - s.n1)][i]);
  std::vector<Fad> r(81, Fad(0.0));
  const Vec<Fad, 3>* y = u.data() + s.n1;
  const ContactPoint c = s.point();
  point_force(c, point_traction<Fad>(c, u.data(), y, y), r.data());
  std::vector<double> k(std::size_t(n) * std::size_t(n), 0.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      k[std::size_t(i * n + j)] = r[std::size_t(i)].dx(j);
  return k;
}

/// Puts the foot on an edge; false where the closest point of the edge is one of its ends.
bool put_on_edge(Case& s, int e) {
  const int corners = fem::face_corners(s.c.face), next = (e + 1) % corners;
  const bool curved = fem::face_nodes(s.c.face) > corners;
  const Vec3 &from = s.y[std::size_t(e)], &to = s.y[std::size_t(next)];
  const Vec3 middle = curved ? s.y[std::size_t(corners + e)] : 0.5 * (from + to);
  const double t = search::closest_on_edge(from, middle, to, s.primary().x);
  double a[2], b[2];
  search::node_parameters(s.c.face, e, a);
  search::node_parameters(s.c.face, next, b);
  for (int i = 0; i < 2; ++i)
    s.c.xi[i] = 0.5 * ((1.0 - t) * a[i] + (1.0 + t) * b[i]);
  s.c.foot = {Foot::On::edge, static_cast<signed char>(e)};
  return std::fabs(t) < 1.0;
}

/// Runs body over all pairs of faces and all edges and corners of the secondary.
template <class Body> int sweep(PointRule rule, const Body& body) {
  int edges = 0;
  for (const FaceType f1 : all_types)
    for (const FaceType f2 : all_types)
      for (const double multiplier : {0.0, 4.0})
        for (int e = 0; e < fem::face_corners(f2); ++e) {
          Case s = make_case(f1, f2, {});
          s.c.rule = rule;
          s.c.multiplier = multiplier;
          if (multiplier > 0.0)
            carry(s, 1.0, -0.7, 0.4);
          if (put_on_edge(s, e)) {
            ++edges;
            body(s);
          }
          s.c.foot.on = Foot::On::corner;
          search::node_parameters(f2, e, s.c.xi);
          body(s);
        }
  return edges;
}

constexpr double eps = 1.0, side = 0.02, slope = 0.3;

/// A small face at (x, y), looking down, behind two or four faces of unit size; force on it over
/// eps and its area.
struct Behind {
  PhaseTimers timers;
  mesh::Surface upper, lower;
  DenseSystem system;
  Interaction pair;

  Behind(double x, double y, double depth, const std::function<void(double*)>& place)
      : upper(grid_surface(1, 1, x - side / 2, x + side / 2, y - side / 2, y + side / 2, true, 0,
                           [depth](double* p) { p[2] = -depth; })),
        lower(grid_surface(2, 2, -1, 1, -1, 1, false, 4, place, 1000)), system(13, 3),
        pair(Comm(MPI_COMM_WORLD), upper, lower, options(), timers) {
    system.evaluate(pair, true);
  }
  static ContactOptions options() {
    ContactOptions o;
    o.name = "pair";
    o.penalty = eps;
    o.points = 1;
    return o;
  }
  Vec3 push() const {
    Vec3 sum = Vec3::zero();
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i)
        sum[i] -= system.residual[std::size_t(3 * a + i)] / (eps * side * side);
    return sum;
  }
};

void valley(double* p) {
  p[2] = slope * std::fabs(p[0]);
}
void pit(double* p) {
  p[2] = slope * (std::fabs(p[0]) + std::fabs(p[1]));
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

} // namespace

TEST(EdgeFoot, DerivativesEqualAutomaticOnes) {
  for (const PointRule rule :
       {PointRule::frictionless, PointRule::incremental_stick, PointRule::incremental_slip}) {
    double worst = 0.0;
    const int edges = sweep(rule, [&](const Case& s) {
      ASSERT_GT(s.traction().pressure, 0.0);
      worst = std::max(worst, distance(s.tangent(), automatic(s)));
    });
    EXPECT_GT(edges, 100);
    EXPECT_LT(worst, 1e-12) << int(rule);
    EXPECT_GT(worst, 0.0);
  }
}

TEST(EdgeFoot, FrictionlessIsSymmetric) {
  sweep(PointRule::frictionless, [&](const Case& s) {
    const auto k = s.tangent();
    auto transposed = k;
    const auto n = std::size_t(3 * s.columns());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        transposed[i * n + j] = k[j * n + i];
    EXPECT_LT(distance(transposed, k), 1e-13);
  });
}

// Tractions that nodes of the law have given turn with the contact normal.
TEST(EdgeFoot, GivenTractionsTurnAlong) {
  sweep(PointRule::frictionless, [&](Case s) {
    s.c.penalty = 0.0;
    s.c.multiplier = 3.0;
    std::vector<double> k(s.tangent().size(), 0.0);
    ASSERT_TRUE(given_traction_tangent(s.point(), Vec3::zero(), s.x.data(), s.y.data(), k.data()));
    EXPECT_LT(distance(k, automatic(s)), 1e-12);
  });
}

// Behind the edge at x = 0 the closest point lies on it, behind the corner at x = y = 0 on that.
TEST(EdgeFoot, PushesToTheNearestEdgeOrCorner) {
  for (const double x : {-0.04, -0.01, 0.0, 0.03})
    expect_near(Behind(x, 0.4, 0.2, valley).push(), {{-x, 0.0, 0.2}}, 1e-12);
  expect_near(Behind(0.02, 0.4, 0.2, pit).push(),
              {{-0.02, 0.4 / (1 + slope * slope) - 0.4 - slope * 0.2 / (1 + slope * slope),
                slope * (0.4 - slope * 0.2) / (1 + slope * slope) + 0.2}},
              1e-12);
  for (const double x : {-0.02, 0.01})
    expect_near(Behind(x, 0.015, 0.2, pit).push(), {{-x, -0.015, 0.2}}, 1e-12);
}

// From one face over the edge to the other: the push changes by no more than the point moves, for
// the closest point of what lies before a valley does not move faster. With faces alone it would
// jump by twice their slope, and with no margin fall to zero.
TEST(EdgeFoot, NoJumpFromFaceToFace) {
  const double step = 0.004;
  Vec3 last = Behind(-0.12, 0.4, 0.2, valley).push();
  for (double x = -0.12 + step; x < 0.12; x += step) {
    const Vec3 now = Behind(x, 0.4, 0.2, valley).push();
    EXPECT_LT(norm(now - last), 1.0001 * step) << x;
    EXPECT_GT(now[2], 0.15);
    last = now;
  }
}

// Where the surface ends there is no partner beyond.
TEST(EdgeFoot, RimsHoldNothing) {
  const auto flat = [](double* p) { p[2] = 0.0; };
  EXPECT_EQ(Behind(1.05, 0.4, 0.2, flat).pair.summary().active_points, 0);
  EXPECT_EQ(Behind(1.05, 0.0, 0.2, flat).pair.summary().active_points, 0);
  EXPECT_EQ(Behind(0.95, 0.4, 0.2, flat).pair.summary().active_points, 1);
}

TEST(EdgeFoot, TangentEqualsDifferences) {
  for (const auto place : {valley, pit}) {
    Behind scene(0.02, 0.015, 0.2, place);
    ASSERT_EQ(scene.pair.summary().active_points, 1);
    const std::vector<double> k = scene.system.tangent;
    const std::size_t n = scene.system.u.size();
    std::vector<double> direction(n), difference(n, 0.0), product(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      direction[i] = std::sin(1.0 + 7.0 * double(i));
    const double h = 1e-6;
    for (const int sign : {1, -1}) {
      for (std::size_t i = 0; i < n; ++i)
        scene.system.u[i] = sign * h * direction[i];
      scene.system.evaluate(scene.pair, false);
      for (std::size_t i = 0; i < n; ++i)
        difference[i] += sign * scene.system.residual[i] / (2.0 * h);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        product[i] += k[i * n + j] * direction[j];
    EXPECT_LT(distance(product, difference), 1e-6);
  }
}
