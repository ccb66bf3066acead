// SPDX-License-Identifier: BSD-3-Clause
#include "abut/fem/measure.hpp"

#include "abut/fem/cell_shape.hpp"
#include "abut/fem/face_shape.hpp"
#include "abut/fem/quadrature.hpp"

#include <algorithm>

namespace abut::fem {

namespace {

template <class Shape> CellMeasure measure(const Vec3* x) {
  constexpr int n = Shape::nodes;
  static const Rule<3> rule = cell_rule(Shape::type, default_points(Shape::type));
  CellMeasure m;
  for (int p = 0; p < rule.size(); ++p) {
    double N[n], dN[n][3];
    const auto& xi = rule.xi[static_cast<std::size_t>(p)];
    Shape::values(xi.data(), N);
    Shape::derivatives(xi.data(), dN);
    Mat3 jacobian = Mat3::zero();
    Vec3 at = Vec3::zero();
    for (int a = 0; a < n; ++a) {
      at += N[a] * x[a];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          jacobian[i][k] += x[a][i] * dN[a][k];
    }
    const double d = det(jacobian);
    m.least = p == 0 ? d : std::min(m.least, d);
    m.volume += rule.weight[static_cast<std::size_t>(p)] * d;
    m.moment += rule.weight[static_cast<std::size_t>(p)] * d * at;
  }
  return m;
}

template <class Shape> double area(const Vec3* x) {
  static const Rule<2> rule = face_rule(Shape::type, default_points(Shape::type));
  double area = 0.0;
  for (int p = 0; p < rule.size(); ++p) {
    double dN[Shape::nodes][2];
    Shape::derivatives(rule.xi[static_cast<std::size_t>(p)].data(), dN);
    Vec3 t1 = Vec3::zero(), t2 = Vec3::zero();
    for (int a = 0; a < Shape::nodes; ++a) {
      t1 += dN[a][0] * x[a];
      t2 += dN[a][1] * x[a];
    }
    area += rule.weight[static_cast<std::size_t>(p)] * norm(cross(t1, t2));
  }
  return area;
}

} // namespace

CellMeasure measure_cell(CellType type, const Vec3* x) {
  return dispatch_cell(type, [&](auto shape) { return measure<decltype(shape)>(x); });
}

double face_area(FaceType type, const Vec3* x) {
  return dispatch_face(type, [&](auto shape) { return area<decltype(shape)>(x); });
}

} // namespace abut::fem
