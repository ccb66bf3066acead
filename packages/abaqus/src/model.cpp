// SPDX-License-Identifier: BSD-3-Clause
#include "abut/abaqus/model.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace abut::abaqus {

std::string key_of(const std::string& name) {
  std::string key;
  for (const char c : name)
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '"')
      key += static_cast<unsigned char>(c) < 0x80
                 ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
                 : c;
  return key;
}

double Hyperelastic::shear() const {
  const double sum = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
  return is_ogden ? 0.5 * sum : 2.0 * sum;
}

double Amplitude::operator()(double t) const {
  const auto upper = std::lower_bound(points.begin(), points.end(), t,
                                      [](const auto& p, double x) { return p[0] < x; });
  if (upper == points.begin())
    return points.front()[1];
  if (upper == points.end())
    return points.back()[1];
  const auto& a = *(upper - 1);
  const auto& b = *upper;
  return a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]);
}

bool Amplitude::is_constant() const {
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return p[1] == points[0][1]; });
}

double Model::start(std::size_t step) const {
  double t = 0.0;
  for (std::size_t s = 0; s < step; ++s)
    t += steps[s].period;
  return t;
}

std::string Model::where(const Place& place) const {
  return files[static_cast<std::size_t>(place.file)] + ":" + std::to_string(place.line);
}

} // namespace abut::abaqus
