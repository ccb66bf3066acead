// SPDX-License-Identifier: BSD-3-Clause
#include "multipliers/plateau.hpp"

#include <algorithm>

namespace abut::contact {

namespace {

constexpr double plateau_ratio = 0.98; ///< an augmentation that leaves more of the gap than this...
constexpr std::size_t plateau_count = 3; ///< ...so many times in a row changes nothing any more
constexpr double slow_ratio = 0.5;       ///< what two augmentations may leave...
constexpr std::size_t slow_count = 2;    ///< ...of a measure that falls as it should
constexpr double stiff_ratio = 0.5;      ///< change of multipliers over their last change
constexpr double solved = 1e-6; ///< what Newton leaves: a measure below it has no other cause
constexpr double deep = 0.5;    ///< of the largest violation: those that hold the measure up
constexpr double most = 0.5;    ///< of their area: they share a cause

/// Whether a measure has stopped falling, with its values before earlier augmentations.
bool stands(const std::vector<double>& earlier, double now) {
  if (earlier.size() < plateau_count)
    return false;
  for (std::size_t k = 0; k < plateau_count; ++k) {
    const double before = earlier[earlier.size() - 1 - k];
    if (now <= plateau_ratio * before)
      return false;
    now = before;
  }
  return true;
}

} // namespace

const char* describe(PlateauCause cause) {
  switch (cause) {
  case PlateauCause::none:
    return "";
  case PlateauCause::held_nodes:
    return "the surfaces overlap most where the primary's displacement is prescribed: no "
           "multiplier "
           "moves it; take those faces off the contact surface, or the other side as primary";
  case PlateauCause::partly_covered:
    return "the surfaces overlap most on primary faces that are covered only in part: refine them, "
           "or take the other side, which is covered, as primary";
  case PlateauCause::changing_set:
    return "contact opens and closes in turns: take smaller steps or a smaller penalty_factor";
  case PlateauCause::stiff_primary:
    return "what multipliers push on the primary hardly moves the gaps, as where it is stiff and "
           "fine: swap primary and secondary, or take 'multipliers: smoothed' with "
           "'penalty_factor: 1'";
  case PlateauCause::short_waves:
    return "pressures that differ from one point or node to the next move the bodies little: take "
           "'multipliers: dual', a larger penalty_factor or 'augmentation: anderson'";
  case PlateauCause::unknown:
    return "of none of the known causes: a larger penalty_factor closes more with each "
           "augmentation";
  }
  return "";
}

void PlateauWatch::clear() {
  gaps_.clear();
  changes_.clear();
  sets_.clear();
  returns_ = 0;
}

void PlateauWatch::add(const Judged& now, Global active_set) {
  gaps_.push_back(now.gap);
  changes_.push_back(now.change);
  const bool known = std::find(sets_.begin(), sets_.end(), active_set) != sets_.end();
  if (known && sets_.back() != active_set)
    ++returns_;
  sets_.push_back(active_set);
}

bool PlateauWatch::stalled(const Judged& now) const {
  return !(now.settled && now.closed) && (now.settled || stands(changes_, now.change)) &&
         (now.closed || stands(gaps_, now.gap));
}

PlateauCause PlateauWatch::cause(const Judged& now, bool by_change, bool dual,
                                 bool poor_side) const {
  if (gaps_.size() < slow_count || (now.settled && now.closed))
    return PlateauCause::none;
  const bool change_counts = now.closed || by_change;
  const std::vector<double>& earlier = change_counts ? changes_ : gaps_;
  const double measure = change_counts ? now.change : now.gap;
  if (measure <= solved || measure <= slow_ratio * earlier[earlier.size() - slow_count])
    return PlateauCause::none;
  double sums[3] = {0.0, 0.0, 0.0}; // area of the deep ones, held, partly covered
  double largest = 0.0;
  for (const Violation& v : violations_)
    largest = std::max(largest, v.size);
  largest = comm_.max(largest);
  for (const Violation& v : violations_)
    if (v.size > 0.0 && v.size >= deep * largest) {
      sums[0] += v.area;
      sums[1] += v.held ? v.area : 0.0;
      sums[2] += v.partly_covered ? v.area : 0.0;
    }
  comm_.sum(sums, 3);
  if (cycles())
    return PlateauCause::changing_set;
  if (sums[1] > most * sums[0])
    return PlateauCause::held_nodes;
  if (sums[2] > most * sums[0])
    return PlateauCause::partly_covered;
  if (now.change <= stiff_ratio * changes_.back())
    return PlateauCause::unknown;
  return dual || poor_side ? PlateauCause::stiff_primary : PlateauCause::short_waves;
}

} // namespace abut::contact
