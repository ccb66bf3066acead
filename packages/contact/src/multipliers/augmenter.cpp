// SPDX-License-Identifier: BSD-3-Clause
#include "multipliers/augmenter.hpp"

#include "report/report.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

constexpr double stiff_factor = 10.0; ///< springs of this f should close a gap fast
constexpr double halved = 0.5;        ///< share of a change that a set which comes and goes gets

/// A number of 40 bits that looks like chance.
Global scattered(Global key) {
  auto x = static_cast<unsigned long long>(key) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<Global>((x ^ (x >> 32)) & 0xffffffffffULL);
}

} // namespace

/// The tractions themselves, but for what only takes off the distance of a tie.
void Augmenter::propose_own() {
  const Sites sites(data_);
  next_.assign(std::size_t(sites.size()), {});
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    Multiplier& next = next_[std::size_t(i)];
    next = {site.state.pressure, site.state.shear};
    if (!data_.settings.tied || !site.state.pressed())
      continue;
    const auto at = data_.primary().at(i);
    const Vec3 rest = tied_rest(data_, i, at);
    next.pressure -= dot(at.normal, rest);
    next.shear += rest - dot(at.normal, rest) * at.normal;
  }
}

void Augmenter::propose(Augmentation& result) {
  proposed_ = true;
  watch_.look_anew();
  if (smoothed()) {
    next_ = averaged_multipliers(data_, increments_, watch_, result);
  } else {
    propose_own();
    measure_sites(result);
  }
  const Sites sites(data_);
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    Multiplier& next = next_[std::size_t(i)];
    if (!site.state.pressed())
      next.shear = Vec3::zero();
    if (update_)
      update_(site, next.pressure, next.shear);
  }
}

/// Largest penetration and motion in stick, site by site.
void Augmenter::measure_sites(Augmentation& result) {
  const Sites sites(data_);
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    if (site.area == 0.0 || (!data_.nodal && data_.points.state(i).facing < 0))
      continue;
    const bool both_ways = site.state.pressed() && (accelerates() || site.anchored);
    double most = both_ways ? std::fabs(site.gap) : -site.gap;
    if (site.state.status() == Status::stick && site.penalty > 0.0)
      most = std::max(most, norm(site.spring) / site.penalty);
    result.gap = std::max(result.gap, most / site.size);
    result.length = std::max(result.length, most);
    watch_.violated({most / site.size, site.area, sites.held(i), sites.partly_covered(i)});
  }
}

/// Relative change that the proposed multipliers make, L2.
double Augmenter::relative_change() const {
  const Sites sites(data_);
  double total[2] = {0.0, 0.0};
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    const Vec3 shear = next_[std::size_t(i)].shear - site.carried, traction = site.traction();
    const double pressure = next_[std::size_t(i)].pressure - site.multiplier;
    total[0] += site.area * (pressure * pressure + dot(shear, shear));
    total[1] += site.area * dot(traction, traction);
  }
  data_.comm.sum(total, 2);
  return total[1] > 0.0 ? std::sqrt(total[0] / total[1]) : total[0] > 0.0 ? 1.0 : 0.0;
}

void Augmenter::judge_once(Augmentation& result) {
  const Settings& o = data_.settings;
  result = {};
  propose(result);
  result.change = relative_change();
  double most[2] = {result.gap, result.length};
  data_.comm.max(most, 2);
  result.gap = most[0];
  result.length = most[1];
  judged_ = {result.gap, result.change, result.change <= o.change_tolerance,
             result.gap <= o.gap_tolerance && result.length <= o.length_tolerance};
}

/// Whether what tractions leave open is more than it may be beside the energy of the bodies: a gap
/// that is small beside a face may be large beside the way by which stiff bodies give.
bool Augmenter::is_soft(const EnergyOfBodies& energy) const {
  constexpr double rigid = 1e-6; // bodies with less of the energy have no stiffness to compare with
  if (!energy || !std::isfinite(data_.settings.error_tolerance))
    return false;
  const double softness = std::fabs(summarize(data_).softness);
  if (softness == 0.0)
    return false;
  const double of_bodies = std::max(0.0, energy());
  return of_bodies > rigid * softness &&
         softness > data_.settings.error_tolerance * (of_bodies + softness);
}

Augmentation Augmenter::judge(const EnergyOfBodies& energy) {
  Augmentation result;
  judge_once(result);
  if (judged_.settled && !judged_.closed && !increments_ && smoothed()) {
    increments_ = true; // what averages leave open, increments close
    watch_.clear();
    judge_once(result);
  }
  if (judged_.settled && judged_.closed)
    judged_.closed = !is_soft(energy);
  result.converged = judged_.settled && judged_.closed;
  result.stalled = watch_.stalled(judged_);
  if (result.stalled || stiffness_factor() >= stiff_factor)
    result.cause = watch_.cause(judged_, smoothed() && !increments_, data_.nodal != nullptr,
                                data_.sides.is_poor());
  return result;
}

/// f of the penalty, given or automatic; 0 where no body is elastic.
double Augmenter::stiffness_factor() const {
  const Settings& o = data_.settings;
  if (o.penalty_source == PenaltySource::factor)
    return data_.factor;
  return o.modulus > 0.0 ? o.penalty * data_.sides.face_size / o.modulus : 0.0;
}

void Augmenter::choose_factor() {
  const Settings& o = data_.settings;
  if (factor_chosen_ || !o.factor_by_pressure)
    return;
  double most = 0.0;
  for (Local i = 0; i < data_.points.size(); ++i)
    most = std::max(most, data_.points.state(i).site.pressure);
  most = data_.comm.max(most);
  if (most == 0.0)
    return;
  constexpr double least_factor = 1.0, largest_factor = 10.0;
  data_.factor =
      std::clamp(most / (6.0 * o.modulus * o.gap_tolerance), least_factor, largest_factor);
  factor_chosen_ = true;
}

/// A number for the set of pressed sites of all ranks. Collective.
Global Augmenter::active_set() const {
  const Sites sites(data_);
  Global sum = 0;
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    if (site.area > 0.0 && site.state.pressed())
      sum += scattered(sites.key(i));
  }
  return data_.comm.sum(sum);
}

/// The pressures that become multipliers: those proposed, or combined with earlier ones, or on half
/// of the way to them when the contact opens and closes in turns. Collective.
std::vector<double> Augmenter::next_pressures() {
  const Sites sites(data_);
  std::vector<double> x, g, weight;
  std::vector<char> active;
  for (Local i = 0; i < sites.size(); ++i) {
    const Site site = sites[i];
    x.push_back(site.multiplier);
    g.push_back(next_[std::size_t(i)].pressure);
    weight.push_back(site.area);
    active.push_back(site.area > 0.0 && site.state.pressed());
  }
  const bool changed = active != last_active_;
  last_active_ = std::move(active);
  if (watch_.cycles()) {
    anderson_.clear();
    for (std::size_t i = 0; i < x.size(); ++i)
      g[i] = x[i] + halved * (g[i] - x[i]);
    return g;
  }
  if (!accelerates() || (smoothed() && !increments_))
    return g;
  // A combination may leave multipliers that are too large, and gaps across which they press.
  std::vector<double> next = anderson_.next(x, g, weight, changed);
  for (double& pressure : next)
    pressure = std::max(0.0, pressure);
  return next;
}

void Augmenter::take_point(Local i, bool shear) {
  PointHistory& history = data_.points.history(i);
  history.multiplier = next_[std::size_t(i)].pressure;
  if (!shear)
    return;
  const bool pressed = data_.points.state(i).site.pressed();
  history.carried = pressed ? store_traction(data_.primary().at(i), next_[std::size_t(i)].shear)
                            : StoredTraction();
}

/// What was proposed becomes the multipliers, with those of the shear if wanted.
void Augmenter::take(bool shear) {
  if (!data_.nodal) {
    for (Local i = 0; i < data_.points.size(); ++i)
      take_point(i, shear);
    return;
  }
  std::vector<double> pressures;
  for (const Multiplier& next : next_)
    pressures.push_back(next.pressure);
  data_.nodal->set_multipliers(pressures);
  if (!shear)
    return;
  if (update_)
    for (Local n = 0; n < data_.corners.nodes(); ++n)
      data_.nodal->set_shear(n, next_[std::size_t(n)].shear);
  data_.nodal->store_shear(data_.primary());
}

void Augmenter::augment() {
  if (!proposed_)
    judge({});
  watch_.add(judged_, active_set());
  const std::vector<double> pressures = next_pressures();
  for (std::size_t i = 0; i < pressures.size(); ++i)
    next_[i].pressure = pressures[i];
  take(true);
  proposed_ = false;
}

void Augmenter::propose_at_end() {
  if (!data_.acts ||
      (data_.nodal ? !data_.settings.carries_tractions() : !data_.settings.augments_at_end()))
    return;
  Augmentation unused;
  propose(unused);
}

void Augmenter::take_at_end() {
  const Settings& o = data_.settings;
  if (data_.nodal) {
    data_.nodal->store_shear(data_.primary());
    if (o.carries_tractions() && data_.acts)
      take(false);
  } else if (o.augments_at_end() && data_.acts) {
    take(o.anchors() || o.friction_map != FrictionMap::incremental);
  }
}

void Augmenter::clear() {
  watch_.clear();
  anderson_.clear();
  proposed_ = false;
}

void Augmenter::restart() {
  clear();
  last_active_.clear();
  increments_ = false;
}

} // namespace abut::contact
