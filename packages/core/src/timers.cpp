// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/timers.hpp"

namespace abut {

const char* phase_name(Phase phase) {
  static const char* names[phase_count] = {"search",   "contact",      "solid",
                                           "assembly", "linear_solve", "output"};
  return names[static_cast<int>(phase)];
}

PhaseTimers::Scope::Scope(PhaseTimers& timers, Phase phase)
    : timers_(timers), outer_(timers.current_), phase_(phase),
      start_(std::chrono::steady_clock::now()) {
  timers_.current_ = this;
}

PhaseTimers::Scope::~Scope() {
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  timers_.seconds_[static_cast<std::size_t>(phase_)] += elapsed - inner_seconds_;
  if (outer_)
    outer_->inner_seconds_ += elapsed;
  timers_.current_ = outer_;
}

} // namespace abut
