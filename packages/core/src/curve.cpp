// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/curve.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut {

double Curve::operator()(double t) const {
  if (points.empty())
    return t;
  if (t <= points.front()[0])
    return points.front()[1];
  if (t >= points.back()[0])
    return points.back()[1];
  const auto after = std::upper_bound(points.begin(), points.end(), t,
                                      [](double x, const auto& point) { return x < point[0]; });
  const auto& [t0, v0] = *(after - 1);
  const auto& [t1, v1] = *after;
  return v0 + (v1 - v0) * (t - t0) / (t1 - t0);
}

Curve curve_named(const std::vector<Curve>& curves, const std::string& name) {
  if (name.empty())
    return {};
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const Curve& curve) { return curve.name == name; });
  ABUT_REQUIRE(found != curves.end(), "there is no curve '" + name + "'");
  return *found;
}

std::function<double(double)> given_curve(const std::vector<Curve>& curves,
                                          const std::string& name) {
  if (name.empty())
    return {};
  return curve_named(curves, name);
}

} // namespace abut
