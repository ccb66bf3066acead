// SPDX-License-Identifier: BSD-3-Clause
#include "forcing_term.hpp"

#include "abut/solver/nonlinear_system.hpp"

#include <algorithm>

namespace abut::solver {

namespace {
constexpr double safety = 0.1;
constexpr double smallest_forces = 1e-3; ///< with friction, over the reference force
} // namespace

void ForcingTerm::begin_solve(const NonlinearSystem& system) {
  system_ = &system;
  iterates_ = 0;
}

double ForcingTerm::tolerance(double residual) {
  if (iterates_ == 0) {
    first_residual_ = residual;
    if (predicted_)
      prediction_error_ = residual / system_->reference_force();
  }
  predicted_ = false;
  double share = first_share_;
  if (iterates_ > 0) {
    const double newton_part = std::max(0.0, residual - linear_part_) / last_residual_;
    share = newton_part * residual / last_residual_;
    if (iterates_ == 1)
      first_share_ = newton_part;
  }
  ++iterates_;
  last_residual_ = residual;
  return std::min(loosest, std::max(sufficient(residual), safety * share));
}

/// What leaves a residual, or an error over the step's increment, that Newton would end at. The
/// first correction is taken for the increment and the later ones to fall as residuals do.
double ForcingTerm::sufficient(double residual) const {
  double goal = newton_tolerance_ * system_->reference_force() / residual;
  if (displacement_tolerance_)
    goal = std::max(goal, *displacement_tolerance_ * first_residual_ / residual);
  if (!system_->symmetric())
    goal *= smallest_forces;
  return std::max(finest, safety * goal);
}

double ForcingTerm::predictor_tolerance() {
  predicted_ = true;
  const double goal = displacement_tolerance_.value_or(0.0);
  return std::min(loosest, std::max(finest, safety * prediction_error_.value_or(goal)));
}

} // namespace abut::solver
