// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/quadrature.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/face_shape.hpp"

#include <cmath>

namespace abut::fem {
namespace {

constexpr long double pi = 3.14159265358979323846L;

void require_points(int n) {
  ABUT_REQUIRE(n >= 1 && n <= max_points_per_direction, "quadrature with so many points");
}

/// The three points with area coordinates (1-2a, a, a).
void add_orbit3(Rule<2>& rule, double a, double w) {
  rule.add({a, a}, w);
  rule.add({1.0 - 2.0 * a, a}, w);
  rule.add({a, 1.0 - 2.0 * a}, w);
}

/// The six points with area coordinates (a, b, 1-a-b).
void add_orbit6(Rule<2>& rule, double a, double b, double w) {
  const double c = 1.0 - a - b;
  for (const auto& p : {std::array<double, 2>{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}})
    rule.add(p, w);
}

Rule<2> triangle_rule(int n) {
  Rule<2> rule;
  if (n == 1) {
    rule.add({1.0 / 3.0, 1.0 / 3.0}, 0.5);
  } else if (n == 2) {
    add_orbit3(rule, 1.0 / 6.0, 1.0 / 6.0);
  } else if (n == 3) {
    const double r = std::sqrt(38.0 - 44.0 * std::sqrt(0.4));
    const double s = std::sqrt(213125.0 - 53320.0 * std::sqrt(10.0));
    add_orbit3(rule, (8.0 - std::sqrt(10.0) + r) / 18.0, (620.0 + s) / 7440.0);
    add_orbit3(rule, (8.0 - std::sqrt(10.0) - r) / 18.0, (620.0 - s) / 7440.0);
  } else if (n == 4) {
    add_orbit3(rule, 0.249286745170910, 0.116786275726379 / 2.0);
    add_orbit3(rule, 0.063089014491502, 0.050844906370207 / 2.0);
    add_orbit6(rule, 0.053145049844817, 0.310352451033784, 0.082851075618374 / 2.0);
  } else {
    const Rule<1> line = line_rule(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double x = 0.5 * (1.0 + line.xi[i][0]), y = 0.5 * (1.0 + line.xi[j][0]);
        rule.add({x * (1.0 - y), y}, 0.25 * line.weight[i] * line.weight[j] * (1.0 - y));
      }
  }
  return rule;
}

/// The four points with volume coordinates (1-3a, a, a, a).
void add_orbit4(Rule<3>& rule, double a, double w) {
  const double b = 1.0 - 3.0 * a;
  rule.add({a, a, a}, w);
  rule.add({b, a, a}, w);
  rule.add({a, b, a}, w);
  rule.add({a, a, b}, w);
}

Rule<3> collapsed_tetrahedron_rule(int n) {
  Rule<3> rule;
  const Rule<1> line = line_rule(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double x = 0.5 * (1.0 + line.xi[i][0]), y = 0.5 * (1.0 + line.xi[j][0]);
        const double z = 0.5 * (1.0 + line.xi[k][0]), c = 1.0 - z, b = 1.0 - y;
        rule.add({x * b * c, y * c, z},
                 0.125 * line.weight[i] * line.weight[j] * line.weight[k] * b * c * c);
      }
  return rule;
}

Rule<3> tetrahedron_rule(int n) {
  if (n > 3)
    return collapsed_tetrahedron_rule(n + 1);
  Rule<3> rule;
  if (n == 1) {
    rule.add({0.25, 0.25, 0.25}, 1.0 / 6.0);
  } else if (n == 2) {
    add_orbit4(rule, (5.0 - std::sqrt(5.0)) / 20.0, 1.0 / 24.0);
  } else {
    const double r = std::sqrt(15.0);
    rule.add({0.25, 0.25, 0.25}, 16.0 / 135.0 / 6.0);
    add_orbit4(rule, (7.0 - r) / 34.0, (2665.0 + 14.0 * r) / 37800.0 / 6.0);
    add_orbit4(rule, (7.0 + r) / 34.0, (2665.0 - 14.0 * r) / 37800.0 / 6.0);
    const double c = (10.0 - 2.0 * r) / 40.0, d = 0.5 - c, w = 10.0 / 189.0 / 6.0;
    for (const auto& p :
         {std::array<double, 3>{c, c, d}, {c, d, c}, {d, c, c}, {d, d, c}, {d, c, d}, {c, d, d}})
      rule.add(p, w);
  }
  return rule;
}

Rule<2> square_rule(int n) {
  Rule<2> rule;
  const Rule<1> line = line_rule(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      rule.add({line.xi[i][0], line.xi[j][0]}, line.weight[i] * line.weight[j]);
  return rule;
}

/// Prism over a plane rule: line points outermost.
Rule<3> prism_rule(const Rule<2>& base, int n) {
  Rule<3> rule;
  const Rule<1> line = line_rule(n);
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < base.size(); ++i)
      rule.add({base.xi[i][0], base.xi[i][1], line.xi[k][0]}, base.weight[i] * line.weight[k]);
  return rule;
}

} // namespace

Rule<1> line_rule(int n) {
  ABUT_REQUIRE(n >= 1, "a quadrature rule needs points");
  Rule<1> rule;
  for (int i = n - 1; i >= 0; --i) {
    // Newton on the Legendre polynomial; long double keeps the weights right to the last digit.
    long double x = std::cos(pi * (i + 0.75L) / (n + 0.5L)), slope = 1.0L;
    for (int iteration = 0; iteration < 10; ++iteration) {
      long double p = 1.0L, before = 0.0L;
      for (int k = 1; k <= n; ++k) {
        const long double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0L);
      x -= p / slope;
    }
    rule.add({static_cast<double>(x)},
             static_cast<double>(2.0L / ((1.0L - x * x) * slope * slope)));
  }
  return rule;
}

Rule<2> face_rule(FaceType type, int n) {
  require_points(n);
  return is_triangle(type) ? triangle_rule(n) : square_rule(n);
}

Rule<2> nodal_rule(FaceType type) {
  Rule<2> rule;
  dispatch_face(type, [&](auto shape) {
    using Shape = decltype(shape);
    for (int a = 0; a < Shape::nodes; ++a) {
      double weight = 0.0;
      switch (type) {
      case FaceType::quad4:
        weight = 1.0;
        break;
      case FaceType::quad8:
        weight = a < 4 ? 3.0 / 19.0 : 16.0 / 19.0;
        break;
      case FaceType::quad9:
        weight = a < 4 ? 1.0 / 9.0 : a < 8 ? 4.0 / 9.0 : 16.0 / 9.0;
        break;
      case FaceType::tri3:
        weight = 1.0 / 6.0;
        break;
      case FaceType::tri6:
        weight = a < 3 ? 0.0 : 1.0 / 6.0;
        break;
      }
      double xi[2];
      Shape::node(a, xi);
      if (weight > 0.0)
        rule.add({xi[0], xi[1]}, weight);
    }
  });
  return rule;
}

Rule<3> cell_rule(CellType type, int n) {
  require_points(n);
  if (type == CellType::tet4 || type == CellType::tet10)
    return tetrahedron_rule(n);
  return prism_rule(type == CellType::wedge6 ? triangle_rule(n) : square_rule(n), n);
}

int default_points(FaceType type) {
  return type == FaceType::quad4 || type == FaceType::tri3 ? 2 : 3;
}

int default_points(CellType type) {
  if (type == CellType::tet4)
    return 1;
  return type == CellType::hex20 || type == CellType::hex27 ? 3 : 2;
}

} // namespace abut::fem
