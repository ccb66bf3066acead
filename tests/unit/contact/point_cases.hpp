// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_tangent.hpp"

#include <gtest/gtest.h>
#include <random>
#include <vector>

/// One integration point between two faces in general position, for the tests of its kernels.
namespace abut::contact::testing {

using fem::FaceType;

constexpr FaceType pairs[][2] = {{FaceType::quad4, FaceType::quad4},
                                 {FaceType::quad8, FaceType::quad9},
                                 {FaceType::tri6, FaceType::tri6},
                                 {FaceType::quad4, FaceType::tri3},
                                 {FaceType::tri3, FaceType::quad8}};
constexpr FaceType all_types[] = {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3,
                                  FaceType::tri6};

using Nodes = std::vector<Vec3>;

inline Nodes reference_nodes(FaceType type, double size) {
  Nodes x(9, Vec3::zero());
  fem::dispatch_face(type, [&](auto shape) {
    for (int a = 0; a < decltype(shape)::nodes; ++a) {
      double p[2];
      decltype(shape)::node(a, p);
      const bool t = fem::is_triangle(type);
      const double move = t ? 1.0 / 3.0 : 0.0, scale = t ? 2.0 * size : size;
      x[std::size_t(a)] = {{scale * (p[0] - move), scale * (p[1] - move), 0.0}};
    }
  });
  return x;
}

inline Vec3 rotate(const Vec3& axis, double angle, const Vec3& v) {
  const Vec3 k = (1.0 / norm(axis)) * axis;
  return std::cos(angle) * v + std::sin(angle) * cross(k, v) +
         ((1.0 - std::cos(angle)) * dot(k, v)) * k;
}

inline Nodes rotate(const Vec3& axis, double angle, Nodes x) {
  for (Vec3& v : x)
    v = rotate(axis, angle, v);
  return x;
}

struct Case {
  Nodes x, y, z, x_previous, y_previous, z_previous; ///< 9 each, the face's own used
  double N[fem::max_face_nodes], dN[fem::max_face_nodes][2];
  int n1 = 0;
  bool one_face = true;
  ContactPoint c;

  /// c with pointers into this object; z is y when the anchor lies on the same face.
  ContactPoint point() const {
    ContactPoint q = c;
    q.shape = {n1, N, dN};
    q.x_previous = x_previous.data();
    q.y_previous = y_previous.data();
    return q;
  }
  PrimaryPoint<double> primary() const { return primary_point({n1, N, dN}, x.data()); }
  const Nodes& anchor_nodes() const { return one_face ? y : z; }
  int n2() const { return fem::face_nodes(c.face); }
  int n3() const {
    return one_face || !reads_anchor_face(c.rule) ? 0 : fem::face_nodes(c.anchor_face);
  }
  int columns() const { return n1 + n2() + n3(); }

  void set_primary_point(FaceType primary, double xi1, double xi2) {
    n1 = fem::face_nodes(primary);
    const double xi[2] = {xi1, xi2};
    fem::dispatch_face(primary, [&](auto f) {
      decltype(f)::values(xi, N);
      decltype(f)::derivatives(xi, dN);
    });
  }

  /// Puts c.xi at the partner that the rule asks for.
  bool find() {
    const ContactPoint q = point();
    const auto p = primary();
    double start[2];
    fem::dispatch_face(c.face, [&](auto f) { decltype(f)::center(start); });
    if (c.rule == PointRule::anchored) {
      c.xi[0] = c.anchor_xi[0];
      c.xi[1] = c.anchor_xi[1];
      return true;
    }
    if (c.rule != PointRule::inclined_slip && !c.ray) {
      const auto hit = search::project(c.face, y.data(), p.x, start);
      c.xi[0] = hit.xi[0];
      c.xi[1] = hit.xi[1];
      return hit.converged;
    }
    Vec3 origin = p.x, direction = -p.normal;
    if (c.rule == PointRule::inclined_slip)
      inclined_ray(q, p, anchored_trial(q, p, anchor_nodes().data()), origin, direction);
    const auto hit = search::intersect(c.face, y.data(), origin, direction, start);
    c.xi[0] = hit.xi[0];
    c.xi[1] = hit.xi[1];
    return hit.converged;
  }

  PointTraction<double> traction() const {
    return point_traction<double>(point(), x.data(), y.data(), anchor_nodes().data());
  }
  /// Residual, ((n1+n2)*3).
  std::vector<double> force() const {
    std::vector<double> r(std::size_t(3 * (n1 + n2())), 0.0);
    point_force(point(), traction(), r.data());
    return r;
  }
  /// Tangent, ((n1+n2+n3)*3)^2; refused when the kernel refuses.
  std::vector<double> tangent(bool* fine = nullptr) const {
    std::vector<double> k(std::size_t(9 * columns() * columns()), 0.0);
    const bool ok =
        point_tangent(point(), x.data(), y.data(), anchor_nodes().data(), one_face, k.data());
    if (fine != nullptr)
      *fine = ok;
    else
      EXPECT_TRUE(ok);
    return k;
  }
};

struct CaseOptions {
  double depth = 0.1, bulge = 0.08, tilt = 0.17, noise = 0.05, turn = 0.3, step_noise = 0.03;
  double aspect = 1.0;
  bool one_face = true, roll = false;
  unsigned seed = 1;
};

/// Two warped faces, about ten degrees apart and turned in the step by some 17 degrees each about
/// axes of their own; the secondary looks up, the primary lies `depth` below it and looks down.
inline Case make_case(FaceType primary, FaceType secondary, const CaseOptions& o) {
  std::mt19937 random(o.seed);
  std::normal_distribution<double> normal;
  const auto jitter = [&](double size) {
    return Vec3{{size * normal(random), size * normal(random), size * normal(random)}};
  };
  Case s;
  s.c.face = s.c.anchor_face = secondary;
  s.one_face = o.one_face;
  s.x = reference_nodes(primary, 1.0);
  s.y = reference_nodes(secondary, 1.3);
  const bool t1 = fem::is_triangle(primary), t2 = fem::is_triangle(secondary);
  s.set_primary_point(primary, t1 ? 0.3 : 0.21, t1 ? 0.25 : -0.33);
  for (Vec3& v : s.x) {
    v = {{v[1], v[0], -o.depth + o.tilt * v[1] + 0.05 * v[0] * v[1]}}; // facing down
    v += jitter(o.noise);
  }
  for (Vec3& v : s.y) {
    v[2] = -o.bulge * (v[0] * v[0] + 0.6 * v[1] * v[1] + 0.5 * v[0] * v[1]);
    v[0] *= o.aspect;
    v += jitter(o.noise);
  }
  if (o.roll) {
    const int n = fem::face_nodes(secondary), corners = t2 ? 3 : 4;
    const Nodes old = s.y;
    for (int b = 0; b < n; ++b)
      s.y[std::size_t(b)] = old[std::size_t(b < corners ? (b + 1) % corners : b)];
    EXPECT_EQ(n, corners) << "only faces without nodes on the edges are rolled";
  }
  s.z = s.y;
  for (Vec3& v : s.z)
    v += Vec3{{0.3, 0.1, 0.02}} + jitter(0.02);
  const auto previous = [&](const Nodes& now) {
    const Vec3 axis = jitter(1.0), shift = jitter(0.06);
    Nodes then = rotate(axis, o.turn, now);
    for (Vec3& v : then)
      v += shift + jitter(o.step_noise);
    return then;
  };
  s.x_previous = previous(s.x);
  s.y_previous = previous(s.y);
  s.z_previous = previous(s.z);
  s.c.weight = 0.37;
  s.c.penalty = 50.0;
  s.c.friction = 0.3;
  s.c.anchor_xi[0] = t2 ? 0.3 : 0.1;
  s.c.anchor_xi[1] = t2 ? 0.4 : 0.15;
  return s;
}

/// Stores a traction of given components along g_1, across it and along n of the last step.
inline void carry(Case& s, double along, double across, double normal) {
  const auto p = primary_point({s.n1, s.N, s.dN}, s.x_previous.data());
  const Vec3 e = (1.0 / norm(p.tangent[0])) * p.tangent[0];
  s.c.carried = store_traction(p, along * e + across * cross(p.normal, e) + normal * p.normal);
}

inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0, size = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  return std::sqrt(sum / size);
}

} // namespace abut::contact::testing
