// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace abut {

/// A function of the load parameter t: linear between its points, constant beyond the ends. Without
/// points it is t itself.
struct Curve {
  std::string name;
  std::vector<std::array<double, 2>> points; ///< (t, value), t strictly increasing

  double operator()(double t) const;
};

/// The curve of this name, which must be there; the ramp t for an empty name.
Curve curve_named(const std::vector<Curve>& curves, const std::string& name);

/// The same as a function; an empty one for an empty name.
std::function<double(double)> given_curve(const std::vector<Curve>& curves,
                                          const std::string& name);

} // namespace abut
