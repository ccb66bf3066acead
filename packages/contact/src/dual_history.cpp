// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of the dual law remember: augmentations and the end of a step.
#include "constants.hpp"
#include "dual_law.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

/// Shear multiplier in the present tangent plane.
Vec3 present_carried(const DualNode& n) {
  return n.carried - dot(n.normal, n.carried) * n.normal;
}

} // namespace

Augmentation DualLaw::augmentation(PlateauWatch& watch, bool both_ways) const {
  double sums[2] = {0.0, 0.0};
  Augmentation result;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const DualNode& n = nodes_[i];
    if (!counts(static_cast<Local>(i)))
      continue;
    const double normal = n.pressure - n.history.multiplier;
    const Vec3 shear = n.traction - present_carried(n);
    sums[0] += n.area * (normal * normal + dot(shear, shear));
    sums[1] += n.area * (n.pressure * n.pressure + dot(n.traction, n.traction));
    double violation = both_ways && n.pressed() ? std::fabs(n.gap) : -n.gap;
    if (n.rule == PointRule::incremental_stick && !n.touching && n.penalty > 0.0)
      violation = std::max(violation, norm(shear) / n.penalty);
    result.gap = std::max(result.gap, violation / n.size);
    result.length = std::max(result.length, violation);
    const double away = std::max(std::fabs(n.area - n.full), std::fabs(n.covered - n.full));
    watch.violated({violation / n.size, n.area, !prescribed_.empty() && prescribed_[i] != 0,
                    away > round_off * n.full});
  }
  comm_.sum(sums, 2);
  result.gap = comm_.max(result.gap);
  result.length = comm_.max(result.length);
  result.change = sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : sums[0] > 0.0 ? 1.0 : 0.0;
  return result;
}

void DualLaw::augment(const MultiplierUpdate& update, const std::vector<double>& pressures) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    DualNode& n = nodes_[i];
    const double before = n.history.multiplier;
    n.history.multiplier = pressures[i];
    if (update) {
      PointState view;
      view.history.multiplier = view.multiplier = before;
      view.history.in_contact = view.converged.in_contact = n.converged.in_contact;
      view.rule = n.rule;
      view.touching = n.touching;
      view.gap = n.gap;
      view.penalty = n.penalty;
      view.pressure = n.pressure;
      view.normal = n.normal;
      view.traction = n.pressure * n.normal + n.traction;
      update(view, n.history.multiplier, n.traction);
    }
  }
}

double DualLaw::slipped(const DualNode& n) const {
  if (n.rule != PointRule::incremental_slip || !(n.penalty > 0.0))
    return 0.0;
  const Vec3 slip = n.share * n.slip + (1.0 / n.penalty) * (n.traction - n.carried);
  return norm(slip - dot(n.normal, slip) * n.normal);
}

double DualLaw::dissipated(const DualNode& n) const {
  const double now = norm(n.traction), then = n.history.sliding;
  return slipped(n) * (then > 0.0 ? 0.5 * (then + now) : now);
}

void DualLaw::accept() {
  for (DualNode& n : nodes_) {
    n.history.gap = n.gap;
    n.history.in_contact = n.active();
    n.history.shear = n.traction;
    n.history.sliding = n.rule == PointRule::incremental_slip ? norm(n.traction) : 0.0;
    n.converged = n.history;
  }
  carried_converged_ = carried_;
}

void DualLaw::reject() {
  for (DualNode& n : nodes_) {
    n.history = n.converged;
    n.last = {n.converged.in_contact, false, {}};
  }
  carried_ = carried_converged_;
}

} // namespace abut::contact
