// SPDX-License-Identifier: BSD-3-Clause
// How the next multipliers are taken over.
#include "dual_law.hpp"
#include "point_search.hpp"

#include <algorithm>

namespace abut::contact {

namespace {

constexpr double halved = 0.5; ///< share of a change that a set which comes and goes gets

/// A number of 40 bits that looks like chance.
Global scattered(Global key) {
  auto x = static_cast<unsigned long long>(key) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<Global>((x ^ (x >> 32)) & 0xffffffffffULL);
}

} // namespace

/// A number for the set of pressed points, or nodes, of all ranks. Collective.
Global Interaction::active_set() const {
  Global sum = 0;
  if (dual_) {
    for (Local n = 0; n < primary_.num_nodes(); ++n)
      if (dual_->counts(n) && dual_->node(n).pressed())
        sum += scattered(primary_.node[n] + 1);
    return comm_.sum(sum);
  }
  constexpr Global points = 64; // more than a face has
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p)
      if (points_[point_index(f, p)].pressed())
        sum += scattered(primary_.face_id[f] * points + p + 1);
  return comm_.sum(sum);
}

/// A combination may leave multipliers that are too large, and gaps across which they press.
bool Interaction::accelerates() const {
  return options_.accelerates() && !update_;
}

/// The pressures that become multipliers, by points or by nodes: those proposed, or combined with
/// earlier ones, or on half of the way to them when the contact opens and closes in turns.
/// Collective.
std::vector<double> Interaction::next_pressures() {
  std::vector<double> x, g, weight;
  std::vector<char> active;
  if (dual_)
    for (Local n = 0; n < primary_.num_nodes(); ++n) {
      const DualNode& node = dual_->node(n);
      x.push_back(node.history.multiplier);
      g.push_back(node.pressure);
      weight.push_back(dual_->counts(n) ? node.area : 0.0);
      active.push_back(dual_->counts(n) && node.pressed());
    }
  else
    for (std::size_t i = 0; i < points_.size(); ++i) {
      x.push_back(points_[i].history.multiplier);
      g.push_back(next_[i].pressure);
      weight.push_back(area_[i]);
      active.push_back(points_[i].pressed());
    }
  const bool changed = active != last_active_;
  last_active_ = std::move(active);
  if (watch_.cycles()) {
    anderson_.clear();
    for (std::size_t i = 0; i < x.size(); ++i)
      g[i] = x[i] + halved * (g[i] - x[i]);
    return g;
  }
  const bool averages = options_.multipliers == Multipliers::smoothed && !increments_;
  if (!accelerates() || averages)
    return g;
  std::vector<double> next = anderson_.next(x, g, weight, changed);
  for (double& pressure : next)
    pressure = std::max(0.0, pressure);
  return next;
}

/// What was proposed for a point becomes its multiplier, with that of the shear if wanted.
void Interaction::take_multiplier(Local face, int point, bool shear) {
  const Local i = point_index(face, point);
  PointState& state = points_[i];
  state.history.multiplier = next_[i].pressure;
  if (!shear)
    return;
  const auto at = primary_point(shape(face, point), primary_nodes(face));
  state.history.carried = state.pressed() ? store_traction(at, next_[i].shear) : StoredTraction();
}

void Interaction::augment() {
  if (!dual_ && !proposed_)
    augmentation();
  watch_.add(judged_, active_set());
  if (dual_) {
    augment_nodes();
  } else {
    const std::vector<double> pressures = next_pressures();
    for (std::size_t i = 0; i < pressures.size(); ++i)
      next_[i].pressure = pressures[i];
  }
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      PointState& state = points_[point_index(f, p)];
      state.returns = state.losses = 0; // another solve may swing for its own reasons
      state.left = -1;
      if (!dual_)
        take_multiplier(f, p, true);
    }
  frozen_ = true;
  searches_ = 0;
}

} // namespace abut::contact
