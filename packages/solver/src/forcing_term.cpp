// SPDX-License-Identifier: BSD-3-Clause
#include "forcing_term.hpp"

#include "abut/solver/nonlinear_system.hpp"

#include <algorithm>

namespace abut::solver {

namespace {
constexpr double safety = 0.1;
constexpr double smallest_forces = 1e-3; ///< with friction, over the reference force
} // namespace

void ForcingTerm::begin_solve(const NonlinearSystem& system, double newton_tolerance) {
  system_ = &system;
  newton_tolerance_ = newton_tolerance;
  iterates_ = 0;
}

double ForcingTerm::tolerance(double residual) {
  const double over_reference = residual / system_->reference_force();
  if (iterates_ == 0 && predicted_)
    prediction_error_ = over_reference;
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
  const double goal =
      system_->symmetric() ? newton_tolerance_ : smallest_forces * newton_tolerance_;
  const double enough = std::max(finest, safety * goal / over_reference);
  return std::min(loosest, std::max(enough, safety * share));
}

double ForcingTerm::predictor_tolerance() {
  predicted_ = true;
  return std::min(loosest, std::max(finest, safety * prediction_error_));
}

} // namespace abut::solver
