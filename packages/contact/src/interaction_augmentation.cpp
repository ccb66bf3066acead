// SPDX-License-Identifier: BSD-3-Clause
// Multipliers: what the next ones are, and whether another solve with them is worth it.
#include "constants.hpp"
#include "dual_law.hpp"
#include "point_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::contact {

namespace {
constexpr double stiff_factor = 10.0; ///< springs of this f should close a gap fast

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

} // namespace

/// What the multipliers change from: the averages hold the rest of the tractions.
Interaction::Multiplier Interaction::base(const PointState& state,
                                          const PrimaryPoint<double>& at) const {
  if (options_.tied || increments_)
    return {state.history.multiplier, turned_traction(state.history.carried, at)};
  // Averaged shear would spread a little with every step: only its change in the step is.
  if (options_.map() == FrictionMap::incremental && state.pressed())
    return {0.0, turned_traction(state.converged.carried, at)};
  return {};
}

void Interaction::propose(Augmentation& result) {
  next_.assign(points_.size(), {});
  proposed_ = true;
  watch_.look_anew();
  if (options_.multipliers == Multipliers::smoothed)
    propose_averages(result);
  else
    measure_points(result);
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local i = point_index(f, p);
      const PointState& state = points_[i];
      Multiplier& next = next_[i];
      if (options_.multipliers == Multipliers::per_point)
        next = {state.pressure, state.traction - state.pressure * state.normal};
      if (!state.pressed())
        next.shear = Vec3::zero();
      if (update_)
        update_(state, next.pressure, next.shear);
    }
}

/// A corner with little cover hardly carries anything: no multiplier of its own closes a gap there.
void Interaction::merge_slivers() {
  merged_.clear();
  std::vector<double> covered(full_.size(), 0.0);
  each_covered_point([&](Local f, int p, const PointState&, const double* N) {
    for (int a = 0; a < corners_.corners(f); ++a)
      covered[std::size_t(corners_.nodes(f)[a])] += N[a] * area_[point_index(f, p)];
  });
  corners_.sum(covered);
  std::vector<char> merged(full_.size());
  for (std::size_t n = 0; n < merged.size(); ++n)
    merged[n] = covered[n] < sliver * full_[n];
  merged_ = std::move(merged);
}

/// Averages of the tractions at the corners, read back by the points. The pressures stay apart from
/// them by what the springs carry, as little as an average differs from the pressure itself.
void Interaction::propose_averages(Augmentation& result) {
  merge_slivers();
  std::vector<double> at_corners(std::size_t(primary_.num_nodes()) * sums, 0.0);
  each_covered_point([&](Local f, int p, const PointState& state, const double* N) {
    const auto at = primary_point(shape(f, p), primary_nodes(f));
    const Multiplier& from = next_[point_index(f, p)] = base(state, at);
    const Vec3 present = state.traction - state.pressure * state.normal;
    const Vec3 spring = present - turned_traction(state.history.carried, at);
    const bool sticks = state.status() == Status::stick;
    for (int a = 0; a < corners_.corners(f); ++a) {
      double* s = &at_corners[std::size_t(corners_.nodes(f)[a]) * sums];
      const double w = N[a] * area_[point_index(f, p)];
      s[weight] += w;
      s[size] += w * size_[f];
      s[pressure] += w * (state.pressure - from.pressure);
      s[closed] += state.pressed() ? w : 0.0;
      s[sticking] += sticks ? w : 0.0;
      s[gap] += w * effective_gap(state);
      for (int i = 0; i < 3; ++i) {
        s[shear + i] += state.pressed() ? w * (present[i] - from.shear[i]) : 0.0;
        s[motion + i] += sticks ? w * spring[i] / state.penalty : 0.0;
      }
    }
  });
  corners_.sum(at_corners, sums);
  for (std::size_t k = 0; k < at_corners.size(); k += sums) {
    double* s = &at_corners[k];
    if (s[weight] <= 0.0)
      continue;
    for (int i = 1; i < sums; ++i)
      s[i] /= s[weight];
    constexpr double whole = 1.0 - 1e-9; // at the rim of the contact the average is half open
    double most = s[closed] < whole ? 0.0 : increments_ ? std::fabs(s[gap]) : -s[gap];
    if (s[sticking] >= whole)
      most = std::max(most, norm(Vec3{{s[motion], s[motion + 1], s[motion + 2]}}));
    result.gap = std::max(result.gap, most / s[size]);
    result.length = std::max(result.length, most);
    const std::size_t node = k / sums;
    watch_.violated({most / s[size], s[weight], !held_.empty() && held_[node] != 0,
                     std::fabs(s[weight] - full_[node]) > round_off * full_[node]});
  }
  each_covered_point([&](Local f, int p, const PointState&, const double* N) {
    const auto read = [&](int column) {
      return corners_.interpolate(f, N, at_corners, column, sums);
    };
    Multiplier& next = next_[point_index(f, p)]; // holds its base
    next.pressure += read(pressure);
    if (!options_.tied && !options_.tension)
      next.pressure = std::max(0.0, next.pressure);
    next.shear += Vec3{{read(shear), read(shear + 1), read(shear + 2)}};
  });
}

void Interaction::each_covered_point(
    const std::function<void(Local, int, const PointState&, const double*)>& visit) const {
  double N[CornerSpace::max_corners];
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      if (state.facing < 0)
        continue;
      corners_.values(f, table_[f]->rule.xi[std::size_t(p)].data(), N);
      if (!merged_.empty())
        corners_.hand_on(f, merged_, N);
      visit(f, p, state, N);
    }
}

/// Largest penetration and motion in stick, point by point.
void Interaction::measure_points(Augmentation& result) {
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    int held = 0, covered = 0;
    for (int a = 0; a < corners_.corners(f); ++a)
      held += !held_.empty() && held_[std::size_t(corners_.nodes(f)[a])] != 0;
    for (int p = 0; p < face_points(f); ++p)
      covered += points_[point_index(f, p)].facing >= 0;
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      if (state.facing < 0)
        continue;
      const auto at = primary_point(shape(f, p), primary_nodes(f));
      const double gap = effective_gap(state);
      double most = accelerates() && state.pressed() ? std::fabs(gap) : -gap;
      if (state.status() == Status::stick && state.penalty > 0.0)
        most = std::max(most, norm(state.traction - state.pressure * state.normal -
                                   turned_traction(state.history.carried, at)) /
                                  state.penalty);
      result.gap = std::max(result.gap, most / size_[f]);
      result.length = std::max(result.length, most);
      watch_.violated({most / size_[f], area_[point_index(f, p)], 2 * held >= corners_.corners(f),
                       covered < face_points(f)});
    }
  }
}

/// Relative change that the proposed multipliers make, L2.
double Interaction::relative_change() const {
  double total[2] = {0.0, 0.0};
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local i = point_index(f, p);
      const PointState& state = points_[i];
      const auto at = primary_point(shape(f, p), primary_nodes(f));
      const Vec3 shear_change = next_[i].shear - turned_traction(state.history.carried, at);
      const double change = next_[i].pressure - state.history.multiplier;
      total[0] += area_[i] * (change * change + dot(shear_change, shear_change));
      total[1] += area_[i] * dot(state.traction, state.traction);
    }
  comm_.sum(total, 2);
  return total[1] > 0.0 ? std::sqrt(total[0] / total[1]) : total[0] > 0.0 ? 1.0 : 0.0;
}

/// Averages leave a penetration of no more than p_max/(6 f E) face sizes: f for the one asked for.
void Interaction::choose_factor() {
  if (factor_chosen_ || options_.penalty_factor > 0.0 || options_.gap_tolerance == 0.0 ||
      options_.multipliers != Multipliers::smoothed || softest_modulus_ == 0.0 ||
      options_.enforcement != Enforcement::augmented_lagrangian)
    return;
  double most = 0.0;
  for (const PointState& state : points_)
    most = std::max(most, state.pressure);
  most = comm_.max(most);
  if (most == 0.0)
    return;
  constexpr double least_factor = 1.0, largest_factor = 10.0;
  factor_ = std::clamp(most / (6.0 * softest_modulus_ * options_.gap_tolerance), least_factor,
                       largest_factor);
  factor_chosen_ = true;
}

/// f of the penalty, given or automatic; 0 where no body is elastic.
double Interaction::stiffness_factor() const {
  if (options_.penalty == 0.0)
    return factor_;
  return softest_modulus_ > 0.0 ? options_.penalty * slack_ / softest_modulus_ : 0.0;
}

Interaction::Tolerances Interaction::tolerances() const {
  const double gap = options_.gap_tolerance, length = options_.gap_limit;
  constexpr double none = std::numeric_limits<double>::infinity();
  Tolerances asked{options_.multiplier_tolerance, gap > 0.0 ? gap : none,
                   length > 0.0 ? length : none};
  if (asked.change > 0.0)
    return asked;
  constexpr double usual_change = 1e-2, usual_gap = 1e-3;
  asked.change = dual_ ? none : usual_change; // springs of dual ones carry pressures as good
  if (dual_ && gap == 0.0 && length == 0.0)
    asked.gap = usual_gap;
  return asked;
}

Augmentation Interaction::augmentation() {
  const Tolerances asked = tolerances();
  Augmentation result;
  Judged& now = judged_;
  const auto judge = [&] {
    if (dual_) {
      watch_.look_anew();
      result = dual_->augmentation(watch_, accelerates());
    } else {
      result = {};
      propose(result);
      result.change = relative_change();
      result.gap = comm_.max(result.gap);
      result.length = comm_.max(result.length);
    }
    now = {result.gap, result.change, result.change <= asked.change,
           result.gap <= asked.gap && result.length <= asked.length};
  };
  judge();
  if (now.settled && !now.closed && !increments_ && options_.multipliers == Multipliers::smoothed) {
    increments_ = true; // what averages leave open, increments close
    watch_.clear();
    judge();
  }
  result.converged = now.settled && now.closed;
  result.stalled = watch_.stalled(now);
  const bool averages = options_.multipliers == Multipliers::smoothed && !increments_;
  if (result.stalled || stiffness_factor() >= stiff_factor)
    result.cause = watch_.cause(now, averages, dual_ != nullptr, sides_.is_poor());
  return result;
}

} // namespace abut::contact
