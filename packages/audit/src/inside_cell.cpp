// SPDX-License-Identifier: BSD-3-Clause
#include "abut/audit/inside_cell.hpp"

#include "abut/fem/cell_shape.hpp"

#include <algorithm>
#include <cmath>

namespace abut::audit {

namespace {

constexpr int most_iterations = 25;
constexpr double longest_step = 1.5; ///< in parameters of the cell
constexpr double exact = 1e-10;
constexpr double nearly = 1e-5; ///< a step whose successor is of the order of its square
constexpr double close = 0.1;   ///< a step after which the point goes on by less than outside
constexpr double outside = 0.3; ///< how far xi is then beyond what may still come back
constexpr double far = 4.0;     ///< beyond it no cell that is not folded has the point

bool is_tetrahedron(fem::CellType type) {
  return fem::info(type).corners == 4;
}
bool is_wedge(fem::CellType type) {
  return fem::info(type).corners == 6;
}

Vec3 middle(fem::CellType type) {
  if (is_tetrahedron(type))
    return {{0.25, 0.25, 0.25}};
  if (is_wedge(type))
    return {{1.0 / 3.0, 1.0 / 3.0, 0.0}};
  return Vec3::zero();
}

bool in_domain(fem::CellType type, const Vec3& xi, double margin) {
  if (is_tetrahedron(type))
    return xi[0] >= -margin && xi[1] >= -margin && xi[2] >= -margin &&
           xi[0] + xi[1] + xi[2] <= 1.0 + margin;
  if (is_wedge(type))
    return xi[0] >= -margin && xi[1] >= -margin && xi[0] + xi[1] <= 1.0 + margin &&
           std::fabs(xi[2]) <= 1.0 + margin;
  return std::max({std::fabs(xi[0]), std::fabs(xi[1]), std::fabs(xi[2])}) <= 1.0 + margin;
}

struct Place {
  Vec3 x;
  Vec3 tangent[3];
};

Place place_at(fem::CellType type, const Vec3* y, const Vec3& xi) {
  return fem::dispatch_cell(type, [&](auto shape) {
    using Shape = decltype(shape);
    double N[Shape::nodes], dN[Shape::nodes][3];
    Shape::values(xi.v, N);
    Shape::derivatives(xi.v, dN);
    Place p{Vec3::zero(), {Vec3::zero(), Vec3::zero(), Vec3::zero()}};
    for (int a = 0; a < Shape::nodes; ++a) {
      p.x += N[a] * y[a];
      for (int k = 0; k < 3; ++k)
        p.tangent[k] += dN[a][k] * y[a];
    }
    return p;
  });
}

} // namespace

bool inside_cell(fem::CellType type, const Vec3* y, const Vec3& x) {
  Vec3 xi = middle(type);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Place p = place_at(type, y, xi);
    const Vec3 d = x - p.x;
    const Vec3 c = cross(p.tangent[1], p.tangent[2]);
    const double determinant = dot(p.tangent[0], c);
    if (!(std::fabs(determinant) > 0.0))
      return false;
    Vec3 step{{dot(c, d), dot(cross(p.tangent[2], p.tangent[0]), d),
               dot(cross(p.tangent[0], p.tangent[1]), d)}};
    step *= 1.0 / determinant;
    const double length = norm(step);
    if (!(length < 1e300))
      return false;
    const double scale = length > longest_step ? longest_step / length : 1.0;
    xi += scale * step;
    if (norm(xi) > far)
      return false;
    if (length < nearly)
      return in_domain(type, xi, exact);
    if (length < close && !in_domain(type, xi, outside))
      return false;
  }
  return false;
}

} // namespace abut::audit
