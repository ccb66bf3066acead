// SPDX-License-Identifier: BSD-3-Clause
#include "convergence.hpp"

#include <utility>

namespace abut::app {

void Convergence::iteration(const solver::IterationReport& report) {
  if (report.iteration == 0 || solves_.empty())
    solves_.emplace_back();
  solves_.back().push_back(report.relative);
}

void Convergence::step(const solver::StepReport& report) {
  steps_.push_back({report.step, report.t, report.iterations, report.augmentations, report.cuts,
                    std::exchange(solves_, {})});
}

} // namespace abut::app
