// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/solver/load_stepping.hpp"

#include <chrono>
#include <string>

namespace abut::app {

/// What a user sees while a run goes on: a live line on a terminal, plain lines in a file, nothing
/// when quiet. Prints on the root only.
class Progress {
public:
  /// Under a launcher stdout may look like a terminal but end in a file: plain lines then.
  Progress(bool is_root, bool quiet, bool launched, double end);

  void line(const std::string& text); ///< a lasting line
  void iteration(const solver::IterationReport& report);
  void augmentation(int number, const solver::AugmentReport& report);
  void step(const solver::StepReport& report, long long active_points, double penetration_ratio);
  LogSink sink();

private:
  void live(const std::string& text); ///< replaced by the next line; terminals only
  std::string remaining(double t) const;

  bool active_;
  bool terminal_;
  double end_;
  int step_ = 1;
  int augmentation_ = 0;
  std::size_t live_width_ = 0;
  std::chrono::steady_clock::time_point start_;
};

} // namespace abut::app
