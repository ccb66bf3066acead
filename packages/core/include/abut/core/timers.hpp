// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>

namespace abut {

/// The phases of a run whose wall time the summary reports.
enum class Phase { search, contact, solid, assembly, linear_solve, output };
constexpr int phase_count = 6;
const char* phase_name(Phase phase);

/// Seconds spent in each phase on this rank. Scopes may nest; an inner scope's time is taken off
/// the outer one, so that the phases never count a second twice.
class PhaseTimers {
public:
  class Scope {
  public:
    Scope(PhaseTimers& timers, Phase phase);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    friend class PhaseTimers;
    PhaseTimers& timers_;
    Scope* outer_;
    Phase phase_;
    std::chrono::steady_clock::time_point start_;
    double inner_seconds_ = 0.0;
  };

  double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

private:
  std::array<double, phase_count> seconds_{};
  Scope* current_ = nullptr;
};

} // namespace abut
