// SPDX-License-Identifier: BSD-3-Clause
#include "line_search.hpp"

#include "abut/core/error.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Abstract_Vector.H>
#include <NOX_Solver_Generic.H>
#include <algorithm>
#include <cmath>
#include <string>

namespace abut::solver {

namespace {

constexpr int max_halvings = 8;
constexpr int max_evaluations = 5; ///< of the residual, in the search for the root of the slope
constexpr double accept_full = 0.9, accept_root = 0.5;
constexpr int most_turns = 2; ///< of shortest and whole steps

} // namespace

bool SlopeLineSearch::evaluate(double step, double& slope) {
  group_->computeX(*old_, *direction_, step);
  try {
    group_->computeF();
  } catch (const SolveError& e) {
    failure_ = e.what();
    return false;
  }
  slope = direction_->innerProduct(group_->getF());
  if (std::isfinite(slope) && std::isfinite(group_->getNormF()))
    return true;
  failure_ = "The residual is not a finite number.";
  return false;
}

bool SlopeLineSearch::compute(NOX::Abstract::Group& group, double& step,
                              const NOX::Abstract::Vector& direction,
                              const NOX::Solver::Generic& solver) {
  group_ = &group, direction_ = &direction, old_ = &solver.getPreviousSolutionGroup();
  const double slope_start = direction.innerProduct(old_->getF());
  double slope = 0.0;
  step = 1.0;
  for (int halving = 0; !evaluate(step, slope); ++halving) {
    if (halving == max_halvings)
      throw SolveError(failure_);
    step *= 0.5;
  }
  const bool better = indefinite_ && group.getNormF() < old_->getNormF();
  const bool overshoots = slope * slope_start < 0.0 && !better;
  if (!overshoots || std::abs(slope) <= accept_full * std::abs(slope_start) || step <= floor_) {
    turns_ = whole_ ? 0 : turns_;
    if (turns_ < most_turns)
      floor_ = first_floor;
    whole_ = true;
    return true;
  }
  step = seek_root(step, slope_start, slope);
  turns_ += whole_ && step == floor_;
  whole_ = false;
  floor_ = std::min(1.0, 2.0 * floor_);
  return true;
}

double SlopeLineSearch::seek_root(double longest, double slope_start, double slope_full) {
  double low = 0.0, slope_low = slope_start, high = longest, slope_high = slope_full;
  double best = longest, slope_best = slope_full, last = longest;
  int side = 0; // the end that moved last: -1 low, 1 high
  for (int i = 0; i < max_evaluations && std::abs(slope_best) > accept_root * std::abs(slope_start);
       ++i) {
    const double root = low + (high - low) * slope_low / (slope_low - slope_high);
    const double step = std::clamp(root, floor_, longest);
    if (step == last)
      break;
    double slope = 0.0;
    last = step;
    if (!evaluate(step, slope))
      break;
    if (std::abs(slope) < std::abs(slope_best))
      best = step, slope_best = slope;
    if (step == floor_ && slope * slope_start < 0.0)
      break; // the root lies below the floor
    if (slope * slope_start < 0.0) {
      high = step, slope_high = slope;
      if (side == 1)
        slope_low *= 0.5;
      side = 1;
    } else {
      low = step, slope_low = slope;
      if (side == -1)
        slope_high *= 0.5;
      side = -1;
    }
  }
  if (last != best && !evaluate(best, slope_best))
    throw SolveError(failure_);
  return best;
}

} // namespace abut::solver
