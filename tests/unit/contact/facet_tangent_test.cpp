// SPDX-License-Identifier: BSD-3-Clause
// The closed-form tangent of facet-on-facet contact against automatic differentiation through the
// whole evaluation, projection included, over warped quadratic faces.
#include <Sacado.hpp>

namespace abut {
using Fad = Sacado::Fad::SFad<double, 54>;
inline double value_of(const Fad& x) {
  return x.val();
}
} // namespace abut

#include "abut/contact/facet_gap.hpp"
#include "abut/search/closest_point.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace abut;
using fem::FaceType;

namespace {

/// Pressure law t = <lambda - eps gap> (eq. 573 with the bracket on the whole).
template <class T> T contact_pressure(double multiplier, double penalty, const T& gap) {
  const T t = multiplier - penalty * gap;
  return value_of(t) > 0.0 ? t : T(0.0);
}

/// Internal-side residual of one point (eq. 581): r[p] -= w t B_p normal, with B = N on the primary
/// and -N on the secondary nodes. Node order: primary (n1), secondary (n2); r is (n1+n2, 3).
/// weight: quadrature weight times the reference area measure.
template <class T>
void facet_force(int n1, const double* N1, int n2, const contact::FacetGap<T>& q, double weight,
                 const T& pressure, T* r) {
  for (int i = 0; i < 3; ++i) {
    const T f = weight * pressure * q.normal[i];
    for (int a = 0; a < n1; ++a)
      r[3 * a + i] -= N1[a] * f;
    for (int b = 0; b < n2; ++b)
      r[3 * (n1 + b) + i] += q.N[b] * f;
  }
}

struct Scene {
  FaceType primary, secondary;
  int n1, n2;
  Vec3 x[9], y[9];
  double N1[9];
  double xi[2];
};

void face_nodes_in_plane(FaceType type, Vec3* x) {
  fem::dispatch_face(type, [&](auto shape) {
    for (int a = 0; a < decltype(shape)::nodes; ++a) {
      double p[2];
      decltype(shape)::node(a, p);
      x[a] = {{p[0], p[1], 0.0}};
    }
  });
}

/// Two warped faces about 10 degrees apart; the point of the primary lies at -gap below.
Scene make_scene(FaceType primary, FaceType secondary, double depth, double bulge, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.08, 0.08);
  Scene s;
  s.primary = primary;
  s.secondary = secondary;
  s.n1 = fem::face_nodes(primary);
  s.n2 = fem::face_nodes(secondary);
  face_nodes_in_plane(primary, s.x);
  face_nodes_in_plane(secondary, s.y);
  for (int a = 0; a < s.n1; ++a) {
    Vec3& x = s.x[a];
    if (fem::is_triangle(primary))
      x = {{2.0 * x[0] - 0.7, 2.0 * x[1] - 0.7, 0.0}};
    x = {{x[1], x[0], 0.17 * x[0] - depth}}; // facing down, tilted
    for (int i = 0; i < 3; ++i)
      x[i] += noise(random);
  }
  for (int b = 0; b < s.n2; ++b) {
    Vec3& y = s.y[b];
    if (fem::is_triangle(secondary))
      y = {{2.4 * y[0] - 0.9, 2.4 * y[1] - 0.9, 0.0}};
    y[0] *= 1.3;
    y[2] = -bulge * (y[0] * y[0] + 0.5 * y[1] * y[1] + 0.3 * y[0] * y[1]);
    for (int i = 0; i < 3; ++i)
      y[i] += noise(random);
  }
  const double point[2] = {fem::is_triangle(primary) ? 0.35 : 0.1,
                           fem::is_triangle(primary) ? 0.3 : -0.15};
  fem::dispatch_face(primary, [&](auto f) { decltype(f)::values(point, s.N1); });
  Vec3 at = Vec3::zero();
  for (int a = 0; a < s.n1; ++a)
    at += s.N1[a] * s.x[a];
  double start[2];
  fem::dispatch_face(secondary, [&](auto f) { decltype(f)::center(start); });
  const search::Projection p = search::project(secondary, s.y, at, start);
  EXPECT_TRUE(p.converged);
  s.xi[0] = p.xi[0];
  s.xi[1] = p.xi[1];
  return s;
}

/// Residual with derivatives by all nodal coordinates.
void automatic(const Scene& s, double multiplier, double penalty, double weight, Fad* r) {
  const int n = s.n1 + s.n2;
  Vec<Fad, 3> x[9], y[9], at = Vec<Fad, 3>::zero();
  for (int p = 0; p < n; ++p)
    for (int i = 0; i < 3; ++i) {
      if (p < s.n1)
        x[p][i] = Fad(54, 3 * p + i, s.x[p][i]);
      else
        y[p - s.n1][i] = Fad(54, 3 * p + i, s.y[p - s.n1][i]);
    }
  for (int a = 0; a < s.n1; ++a)
    at += s.N1[a] * x[a];
  Fad xi[2] = {Fad(s.xi[0]), Fad(s.xi[1])};
  for (int k = 0; k < 4; ++k) {
    fem::FacePoint<Fad> point;
    fem::face_point(s.secondary, y, xi, point);
    Fad step[2];
    search::projection_step(point, at, step);
    xi[0] += step[0];
    xi[1] += step[1];
  }
  const auto q = contact::facet_gap<Fad>(s.secondary, y, at, xi);
  const Fad t = contact_pressure(multiplier, penalty, q.gap);
  for (int i = 0; i < 3 * n; ++i)
    r[i] = 0.0;
  facet_force(s.n1, s.N1, s.n2, q, weight, t, r);
}

struct Result {
  double error, size, asymmetry, pressure, gap;
};

Result compare(const Scene& s, double multiplier, double penalty) {
  const int n = 3 * (s.n1 + s.n2);
  const double weight = 0.37;
  Vec3 at = Vec3::zero();
  for (int a = 0; a < s.n1; ++a)
    at += s.N1[a] * s.x[a];
  const auto q = contact::facet_gap<double>(s.secondary, s.y, at, s.xi);
  const double t = contact_pressure(multiplier, penalty, q.gap);
  std::vector<double> k(std::size_t(n) * n, 0.0);
  if (t > 0.0) {
    EXPECT_TRUE(contact::facet_tangent(s.n1, s.N1, s.n2, q, weight, penalty, t, k.data()));
  }
  std::vector<Fad> r(54);
  automatic(s, multiplier, penalty, weight, r.data());
  Result result{0.0, 0.0, 0.0, t, q.gap};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double exact = r[std::size_t(i)].dx(j), ours = k[std::size_t(i * n + j)];
      result.error += (ours - exact) * (ours - exact);
      result.size += exact * exact;
      result.asymmetry += std::pow(ours - k[std::size_t(j * n + i)], 2);
    }
  result.error = std::sqrt(result.error);
  result.size = std::sqrt(result.size);
  result.asymmetry = std::sqrt(result.asymmetry);
  return result;
}

constexpr FaceType all_types[] = {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3,
                                  FaceType::tri6};

} // namespace

TEST(FacetTangent, EqualsAutomaticDifferentiationInPenalty) {
  for (const FaceType f1 : all_types)
    for (const FaceType f2 : all_types)
      for (const double bulge : {0.15, -0.12})
        for (unsigned seed = 1; seed <= 6; ++seed) {
          const Scene s = make_scene(f1, f2, 0.7, bulge, seed);
          const Result r = compare(s, 0.0, 100.0);
          ASSERT_GT(r.pressure, 1.0) << "the point must be in contact";
          EXPECT_LT(r.error, 1e-11 * r.size) << int(f1) << ' ' << int(f2) << ' ' << seed;
          EXPECT_LT(r.asymmetry, 1e-13 * r.size);
        }
}

TEST(FacetTangent, EqualsAutomaticDifferentiationWithMultiplier) {
  for (const FaceType f1 : all_types)
    for (const FaceType f2 : all_types)
      for (unsigned seed = 11; seed <= 16; ++seed) {
        const Scene closed = make_scene(f1, f2, 0.4, 0.1, seed);
        const Result a = compare(closed, 70.0, 100.0);
        ASSERT_GT(a.pressure, 70.0);
        EXPECT_LT(a.error, 1e-11 * a.size);
        const Scene open = make_scene(f1, f2, -0.5, 0.1, seed); // open, yet lambda holds it active
        const Result b = compare(open, 70.0, 50.0);
        ASSERT_GT(b.gap, 0.0);
        ASSERT_GT(b.pressure, 0.0);
        EXPECT_LT(b.error, 1e-11 * b.size);
      }
}

TEST(FacetTangent, IsZeroWhenOpen) {
  const Result r = compare(make_scene(FaceType::quad8, FaceType::quad9, -0.5, 0.1, 3), 0.0, 100.0);
  EXPECT_GT(r.gap, 0.1);
  EXPECT_EQ(r.pressure, 0.0);
  EXPECT_EQ(r.size, 0.0);
}

TEST(FacetTangent, OmittedCurvatureTermsWouldBeSeen) {
  // The same scene with kappa set to zero is wrong by far more than the tolerance above.
  const Scene s = make_scene(FaceType::quad4, FaceType::quad9, 0.5, 0.15, 2);
  Vec3 at = Vec3::zero();
  for (int a = 0; a < s.n1; ++a)
    at += s.N1[a] * s.x[a];
  auto q = contact::facet_gap<double>(s.secondary, s.y, at, s.xi);
  const double t = contact_pressure(0.0, 100.0, q.gap);
  const int n = 3 * (s.n1 + s.n2);
  std::vector<double> k(std::size_t(n) * n, 0.0), flat = k;
  contact::facet_tangent(s.n1, s.N1, s.n2, q, 1.0, 100.0, t, k.data());
  q.curvature[0][0] = q.curvature[1][1] = 0.0;
  contact::facet_tangent(s.n1, s.N1, s.n2, q, 1.0, 100.0, t, flat.data());
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    difference += std::pow(k[i] - flat[i], 2);
    size += k[i] * k[i];
  }
  EXPECT_GT(std::sqrt(difference / size), 1e-3);
}

TEST(FacetTangent, RefusesTheCentreOfCurvature) {
  Vec3 y[9];
  face_nodes_in_plane(FaceType::quad9, y);
  for (Vec3& v : y)
    v[2] = 0.25 * (v[0] * v[0] + v[1] * v[1]); // concave bowl, radius 2 at the bottom
  const double xi[2] = {0.0, 0.0}, N1[1] = {1.0};
  const auto q = contact::facet_gap<double>(FaceType::quad9, y, Vec3{{0.0, 0.0, 2.0}}, xi);
  EXPECT_NEAR(q.gap, 2.0, 1e-14);
  std::vector<double> k(30 * 30, 0.0);
  EXPECT_FALSE(contact::facet_tangent(1, N1, 9, q, 1.0, 1.0, 1.0, k.data()));
}
