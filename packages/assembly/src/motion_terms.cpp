// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/motion_terms.hpp"

namespace abut::assembly {

void MotionTerms::start(const TimeIntegration& rule, double t, std::size_t rows) {
  rule_ = rule;
  accepted_time_ = t;
  past_.assign(rows, 0.0);
}

std::vector<double>& MotionTerms::clear_rates(std::size_t rows) {
  rates_.assign(rule_ ? rows : 0, 0.0);
  return rates_;
}

void MotionTerms::complete(std::vector<double>& residual, const std::vector<char>& constrained) {
  if (!rule_)
    return;
  forces_ = residual;
  for (std::size_t i = 0; i < forces_.size(); ++i)
    residual[i] = constrained[i] ? forces_[i] + rates_[i]
                                 : forces_[i] + rule_->inertia() * rates_[i] + past_[i];
}

void MotionTerms::exchange_state(StateArchive& archive, const std::vector<Global>& rows) {
  if (!rule_)
    return;
  archive.numbers("inertia.time", [&](auto& v) { v(accepted_time_); });
  archive.rows("inertia.past", rows, 3, past_.data());
}

void MotionTerms::accept(double t) {
  accepted_time_ = t;
  if (!rule_ || !rule_->has_past())
    return;
  for (std::size_t i = 0; i < past_.size(); ++i)
    past_[i] = rule_->past_force() * forces_[i] + rule_->past_inertia() * rates_[i];
}

} // namespace abut::assembly
