// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/core/time_integration.hpp"

#include <optional>
#include <vector>

namespace abut::assembly {

/// What the rates of momentum and the start of the step add to the equations, see TimeIntegration.
/// Without a rule there is no inertia, and nothing is added.
class MotionTerms {
public:
  void start(const TimeIntegration& rule, double t, std::size_t rows);
  bool active() const { return rule_.has_value(); }
  /// What the derivatives of the rates of momentum are multiplied with in the tangent.
  double weight() const { return rule_ ? rule_->inertia() : 1.0; }
  double accepted_time() const { return accepted_time_; }

  /// Rates of momentum of the residual to come, zero (rows); empty without inertia.
  std::vector<double>& clear_rates(std::size_t rows);
  /// The residual holds forces alone: makes it the equation of motion. In constrained rows, whose
  /// reactions are those of the end of the step, the past does not count.
  void complete(std::vector<double>& residual, const std::vector<char>& constrained);
  /// Forces and rate of momentum at the end of the step by themselves, of the last residual.
  double at_end(std::size_t row) const { return forces_[row] + rates_[row]; }
  /// The last residual is that of a converged state at t.
  void accept(double t);
  /// rows: keys of the owned block rows of three.
  void exchange_state(StateArchive& archive, const std::vector<Global>& rows);

private:
  std::optional<TimeIntegration> rule_;
  double accepted_time_ = 0.0;
  std::vector<double> forces_, rates_; ///< the two parts of the last residual, owned rows
  std::vector<double> past_; ///< what the start of the step adds to the equation, owned rows
};

} // namespace abut::assembly
