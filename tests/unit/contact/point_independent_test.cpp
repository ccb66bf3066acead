// SPDX-License-Identifier: BSD-3-Clause
// Forces and tangents of points against a second implementation in extended precision that shares
// no code with the kernels: own shape functions, projection from scratch, rotation by the polar
// decomposition of the surface gradient, derivatives by central differences.
#include "point_cases.hpp"

#include <array>
#include <functional>

using namespace abut;
using namespace abut::contact;
using namespace abut::contact::testing;

namespace {

using Real = long double;
using V = std::array<Real, 3>;

V operator+(const V& a, const V& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
V operator-(const V& a, const V& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
V operator*(Real s, const V& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Real dot_of(const V& a, const V& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
V cross_of(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
V unit(const V& a) {
  return (1 / std::sqrt(dot_of(a, a))) * a;
}
V tangent_part(const V& v, const V& n) {
  return v - dot_of(v, n) * n;
}
Real det3(const V& a, const V& b, const V& c) {
  return dot_of(a, cross_of(b, c));
}
/// s with s0 a + s1 b + s2 c = d.
V solve(const V& a, const V& b, const V& c, const V& d) {
  const Real D = det3(a, b, c);
  return {det3(d, b, c) / D, det3(a, d, c) / D, det3(a, b, d) / D};
}

struct Surface {
  V x, g[2], n;
};

/// Tensor product of the Lagrange polynomials through -1, 1 or -1, 0, 1, in the order of Exodus.
Surface surface(const std::vector<V>& nodes, Real r, Real s) {
  static const int order4[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  static const int order9[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0},
                                   {2, 1}, {1, 2}, {0, 1}, {1, 1}};
  const bool square = nodes.size() == 9;
  const auto line = [&](Real t, Real* l, Real* d) {
    if (!square) {
      l[0] = (1 - t) / 2, l[1] = (1 + t) / 2, d[0] = -0.5L, d[1] = 0.5L;
      return;
    }
    l[0] = t * (t - 1) / 2, l[1] = 1 - t * t, l[2] = t * (t + 1) / 2;
    d[0] = t - 0.5L, d[1] = -2 * t, d[2] = t + 0.5L;
  };
  Real lr[3], dr[3], ls[3], ds[3];
  line(r, lr, dr);
  line(s, ls, ds);
  Surface p{{0, 0, 0}, {{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}};
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const int i = square ? order9[a][0] : order4[a][0], j = square ? order9[a][1] : order4[a][1];
    p.x = p.x + (lr[i] * ls[j]) * nodes[a];
    p.g[0] = p.g[0] + (dr[i] * ls[j]) * nodes[a];
    p.g[1] = p.g[1] + (lr[i] * ds[j]) * nodes[a];
  }
  p.n = unit(cross_of(p.g[0], p.g[1]));
  return p;
}

Real shape_value(std::size_t count, std::size_t node, Real r, Real s) {
  std::vector<V> probe(count, V{0, 0, 0});
  probe[node] = {1, 0, 0};
  return surface(probe, r, s).x[0];
}

struct Problem {
  std::vector<V> x_previous, y_previous;
  Real point[2], eps, mu, lambda, weight;
  V shear; ///< carried traction in the previous configuration
  Real anchor[2];
};

/// Turns a vector with the primary: the angle of the polar decomposition of the surface gradient.
V turned(const Surface& then, const Surface& now, const V& v) {
  const V E1 = unit(then.g[0]), E2 = cross_of(then.n, E1), k1 = unit(now.g[1]),
          k2 = cross_of(now.n, k1);                   // any axes of the present plane
  const auto gradient = [&](const V& k, const V& E) { // k . F E
    const V c = solve(then.g[0], then.g[1], then.n, E);
    return dot_of(k, c[0] * now.g[0] + c[1] * now.g[1]);
  };
  const Real angle =
      std::atan2(gradient(k2, E1) - gradient(k1, E2), gradient(k1, E1) + gradient(k2, E2));
  const V e1 = std::cos(angle) * k1 + std::sin(angle) * k2, e2 = cross_of(now.n, e1);
  return dot_of(v, E1) * e1 + dot_of(v, E2) * e2 + dot_of(v, then.n) * now.n;
}

/// Steps of a Newton iteration whose Jacobian is itself a difference: any map R^n -> R^n.
std::vector<Real> root(const std::function<V(const V&)>& f, V at) {
  for (int k = 0; k < 60; ++k) {
    const V r = f(at);
    V column[3];
    for (int i = 0; i < 3; ++i) {
      V p = at, m = at;
      p[std::size_t(i)] += 1e-6L, m[std::size_t(i)] -= 1e-6L;
      column[i] = (0.5e6L) * (f(p) - f(m));
    }
    const V step = solve(column[0], column[1], column[2], r);
    at = at - step;
    if (dot_of(step, step) < 1e-38L)
      break;
  }
  return {at[0], at[1], at[2]};
}

std::vector<Real> residual(const std::vector<V>& x, const std::vector<V>& y, const V& t,
                           Real weight, const Real* at, Real r, Real s) {
  std::vector<Real> f;
  for (std::size_t a = 0; a < x.size(); ++a)
    for (int i = 0; i < 3; ++i)
      f.push_back(-weight * shape_value(x.size(), a, at[0], at[1]) * t[std::size_t(i)]);
  for (std::size_t b = 0; b < y.size(); ++b)
    for (int i = 0; i < 3; ++i)
      f.push_back(weight * shape_value(y.size(), b, r, s) * t[std::size_t(i)]);
  return f;
}

/// Incremental friction at the closest point, on the cone or below it.
std::vector<Real> incremental_closest(const Problem& p, bool slips, const std::vector<V>& x,
                                      const std::vector<V>& y) {
  const Surface now = surface(x, p.point[0], p.point[1]);
  const Surface then = surface(p.x_previous, p.point[0], p.point[1]);
  // x1 = x2(r, s) + h n2: the foot and the signed distance at once.
  const auto foot = root(
      [&](const V& q) {
        const Surface face = surface(y, q[0], q[1]);
        return face.x + q[2] * face.n - now.x;
      },
      {0, 0, 0});
  const Surface face = surface(y, foot[0], foot[1]);
  const Surface face_then = surface(p.y_previous, foot[0], foot[1]);
  const V way = solve(face_then.g[0], face_then.g[1], face_then.n, face_then.x - then.x);
  const V slip = way[0] * face.g[0] + way[1] * face.g[1];
  const V w = tangent_part(turned(then, now, p.shear) - p.eps * slip, face.n);
  const Real pressure = p.lambda - p.eps * foot[2];
  const V t = pressure * face.n + (slips ? p.mu * pressure * unit(w) : w);
  return residual(x, y, t, p.weight, p.point, foot[0], foot[1]);
}

/// Slip along the inclined ray, current area.
std::vector<Real> inclined(const Problem& p, const std::vector<V>& x, const std::vector<V>& y) {
  const Surface now = surface(x, p.point[0], p.point[1]);
  const Surface then = surface(p.x_previous, p.point[0], p.point[1]);
  const V multiplier = turned(then, now, p.shear) - p.lambda * now.n;
  const V held = multiplier + p.eps * (surface(y, p.anchor[0], p.anchor[1]).x - now.x);
  const V way = unit(tangent_part(held, now.n)), m = p.mu * way - now.n;
  // Traction t = eps q m and lambda + eps (x2 - x1) at once, the definition of the map.
  const auto hit = root(
      [&](const V& q) {
        return multiplier + p.eps * (surface(y, q[0], q[1]).x - now.x) - (p.eps * q[2]) * m;
      },
      {0, 0, 0});
  const V area = cross_of(now.g[0], now.g[1]);
  const Real measure = p.weight * std::sqrt(dot_of(area, area));
  return residual(x, y, (p.eps * hit[2]) * m, measure, p.point, hit[0], hit[1]);
}

std::vector<V> extended(const Nodes& x, int count) {
  std::vector<V> r;
  for (int a = 0; a < count; ++a)
    r.push_back(
        {Real(x[std::size_t(a)][0]), Real(x[std::size_t(a)][1]), Real(x[std::size_t(a)][2])});
  return r;
}

void compare(bool ray, PointRule rule, double friction) {
  for (const FaceType face : {FaceType::quad4, FaceType::quad9})
    for (unsigned seed = 1; seed <= 2; ++seed) {
      CaseOptions o;
      o.seed = seed;
      o.depth = 0.2;
      Case s = make_case(FaceType::quad4, face, o);
      s.c.ray = ray;
      s.c.rule = rule;
      s.c.friction = friction;
      s.c.multiplier = 4.0;
      const auto before = primary_point({s.n1, s.N, s.dN}, s.x_previous.data());
      const Vec3 shear = 1.1 * before.tangent[0] - 0.4 * before.tangent[1];
      s.c.carried = store_traction(before, shear);
      ASSERT_TRUE(s.find());
      ASSERT_GT(s.traction().pressure, 0.0);
      Problem p;
      p.x_previous = extended(s.x_previous, 4);
      p.y_previous = extended(s.y_previous, s.n2());
      p.point[0] = 0.21, p.point[1] = -0.33;
      p.eps = s.c.penalty, p.mu = s.c.friction, p.lambda = s.c.multiplier, p.weight = s.c.weight;
      p.shear = {Real(shear[0]), Real(shear[1]), Real(shear[2])};
      p.anchor[0] = s.c.anchor_xi[0], p.anchor[1] = s.c.anchor_xi[1];
      auto x = extended(s.x, 4), y = extended(s.y, s.n2());
      const auto evaluate = [&] {
        return ray ? inclined(p, x, y)
                   : incremental_closest(p, rule == PointRule::incremental_slip, x, y);
      };
      const auto f = evaluate();
      const auto ours = s.force();
      EXPECT_LT(distance(ours, std::vector<double>(f.begin(), f.end())), 1e-13) << "force";
      const std::size_t n = f.size();
      std::vector<double> exact(n * n);
      for (std::size_t j = 0; j < n; ++j) {
        const Real h = 1e-6L; // truncation of the order 1e2 h^2, rounding 1e-19/h
        Real& u = j < 12 ? x[j / 3][j % 3] : y[j / 3 - 4][j % 3];
        u += h;
        const auto plus = evaluate();
        u -= 2 * h;
        const auto minus = evaluate();
        u += h;
        for (std::size_t i = 0; i < n; ++i)
          exact[i * n + j] = double((plus[i] - minus[i]) / (2 * h));
      }
      EXPECT_LT(distance(s.tangent(), exact), 1e-9) << "tangent";
    }
}

} // namespace

TEST(PointIndependent, IncrementalSlipAtTheClosestPoint) {
  compare(false, PointRule::incremental_slip, 0.3);
}
TEST(PointIndependent, IncrementalStickAtTheClosestPoint) {
  compare(false, PointRule::incremental_stick, 0.3);
}
TEST(PointIndependent, InclinedSlip) {
  compare(true, PointRule::inclined_slip, 0.3);
}
