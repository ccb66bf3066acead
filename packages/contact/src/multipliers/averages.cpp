// SPDX-License-Identifier: BSD-3-Clause
#include "multipliers/averages.hpp"

#include "kernels/node_law.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

/// Columns of what is summed at the corners; all but the first are weighted with it.
enum Sums {
  weight,
  size,
  pressure,
  shear,
  closed = shear + 3,
  sticking,
  gap,
  motion,
  sums = motion + 3
};

/// What the multipliers change from: the averages hold the rest of the tractions.
Multiplier base(const InterfaceData& data, bool increments, Local i, const Site& site) {
  const Settings& o = data.settings;
  if (o.tied || increments || (o.sticky && site.state.rule == PointRule::anchored))
    return {site.multiplier, site.carried};
  // Averaged shear would spread a little with every step: only its change in the step is.
  if (o.friction_map == FrictionMap::incremental && site.state.pressed())
    return {0.0, turned_traction(data.points.converged(i).carried, data.primary().at(i))};
  return {};
}

/// Averages of one interface in the present configuration.
class Averages {
public:
  Averages(const InterfaceData& data, bool increments)
      : data_(data), sites_(data), increments_(increments),
        N_(std::size_t(data.points.size()) * max_corners),
        sums_(std::size_t(data.corners.nodes()) * sums, 0.0), full_(data.corners.nodes(), 0.0),
        next_(std::size_t(data.points.size())) {
    make_functions();
    add_points();
  }

  void measure(PlateauWatch& watch, Augmentation& result) const;
  std::vector<Multiplier> read();

private:
  bool covered(Local i) const { return data_.points.state(i).facing >= 0; }
  const Local* corner(Local i) const { return data_.corners.nodes(data_.primary().face(i)); }
  int corners(Local i) const { return data_.corners.corners(data_.primary().face(i)); }
  double* N(Local i) { return &N_[std::size_t(i) * max_corners]; }
  void make_functions();
  void add_points();
  void add_point(Local i);

  const InterfaceData& data_;
  Sites sites_;
  bool increments_;
  std::vector<double> N_;    ///< (I,P,max_corners) corner functions
  std::vector<double> sums_; ///< (surface nodes, sums)
  std::vector<double> full_; ///< (surface nodes) integrals of the corner functions [length^2]
  std::vector<Multiplier> next_;
};

/// A corner with little cover hardly carries anything: no multiplier of its own closes a gap there,
/// and it hands its function on.
void Averages::make_functions() {
  std::vector<double> integrals(2 * full_.size(), 0.0); // of all points, of those with a partner
  for (Local i = 0; i < data_.points.size(); ++i) {
    data_.corners.values(data_.primary().face(i), data_.primary().xi(i), N(i));
    for (int a = 0; a < corners(i); ++a) {
      const double part = N(i)[a] * data_.primary().area(i);
      integrals[2 * std::size_t(corner(i)[a])] += part;
      integrals[2 * std::size_t(corner(i)[a]) + 1] += covered(i) ? part : 0.0;
    }
  }
  data_.corners.sum(integrals, 2);
  View<char> merged("abut::contact::merged_corners", full_.size());
  for (std::size_t n = 0; n < full_.size(); ++n) {
    full_[n] = integrals[2 * n];
    merged(n) = integrals[2 * n + 1] < sliver * full_[n];
  }
  for (Local i = 0; i < data_.points.size(); ++i)
    hand_on(corner(i), corners(i), merged, N(i));
}

void Averages::add_points() {
  for (Local i = 0; i < data_.points.size(); ++i)
    if (covered(i))
      add_point(i);
  data_.corners.sum(sums_, sums);
  for (std::size_t k = 0; k < sums_.size(); k += sums)
    for (std::size_t i = 1; sums_[k] > 0.0 && i < sums; ++i)
      sums_[k + i] /= sums_[k];
}

void Averages::add_point(Local i) {
  const Site site = sites_[i];
  const SiteState& state = site.state;
  const auto at = data_.primary().at(i);
  const Multiplier& from = next_[std::size_t(i)] = base(data_, increments_, i, site);
  const Vec3 rest = tied_rest(data_, i, at);
  const double rest_pressure = -dot(at.normal, rest);
  const Vec3 rest_shear = rest + rest_pressure * at.normal;
  const bool sticks = state.status() == Status::stick;
  for (int a = 0; a < corners(i); ++a) {
    double* s = &sums_[std::size_t(corner(i)[a]) * sums];
    const double w = N(i)[a] * site.area;
    s[weight] += w;
    s[size] += w * site.size;
    s[pressure] += w * (state.pressure - from.pressure + rest_pressure);
    s[closed] += state.pressed() ? w : 0.0;
    s[sticking] += sticks ? w : 0.0;
    s[gap] += w * site.gap;
    for (int k = 0; k < 3; ++k) {
      s[shear + k] +=
          state.pressed() ? w * (state.shear[k] - from.shear[k] + rest_shear[k]) : 0.0;
      s[motion + k] += sticks ? w * site.spring[k] / site.penalty : 0.0;
    }
  }
}

void Averages::measure(PlateauWatch& watch, Augmentation& result) const {
  for (std::size_t k = 0; k < sums_.size(); k += sums) {
    const double* s = &sums_[k];
    if (s[weight] <= 0.0)
      continue;
    constexpr double whole = 1.0 - 1e-9; // at the rim of the contact the average is half open
    const bool both_ways = increments_ || data_.settings.anchors();
    double most = s[closed] < whole ? 0.0 : both_ways ? std::fabs(s[gap]) : -s[gap];
    if (s[sticking] >= whole)
      most = std::max(most, norm(Vec3{{s[motion], s[motion + 1], s[motion + 2]}}));
    result.gap = std::max(result.gap, most / s[size]);
    result.length = std::max(result.length, most);
    const std::size_t node = k / sums;
    watch.violated({most / s[size], s[weight], !data_.held.empty() && data_.held[node] != 0,
                    std::fabs(s[weight] - full_[node]) > round_off * full_[node]});
  }
}

std::vector<Multiplier> Averages::read() {
  for (Local i = 0; i < data_.points.size(); ++i) {
    Multiplier& next = next_[std::size_t(i)]; // holds its base
    if (!covered(i))
      continue;
    const auto value = [&](int column) {
      return data_.corners.interpolate(data_.primary().face(i), N(i), sums_, column, sums);
    };
    next.pressure += value(pressure);
    if (!data_.settings.anchors() && !data_.settings.tension)
      next.pressure = std::max(0.0, next.pressure);
    next.shear += Vec3{{value(shear), value(shear + 1), value(shear + 2)}};
  }
  return std::move(next_);
}

} // namespace

std::vector<Multiplier> averaged_multipliers(const InterfaceData& data, bool increments,
                                             PlateauWatch& watch, Augmentation& result) {
  Averages averages(data, increments);
  averages.measure(watch, result);
  return averages.read();
}

} // namespace abut::contact
