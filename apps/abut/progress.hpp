// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/log.hpp"
#include "abut/solver/load_stepping.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace abut::app {

/// What a user sees while a run goes on: a live line on a terminal, plain lines in a file, failures
/// alone when quiet. Prints on the root only.
class Progress {
public:
  /// Under a launcher stdout may look like a terminal but end in a file: plain lines then.
  Progress(bool is_root, bool quiet, bool launched, double end);

  /// The run goes on after so many steps.
  void go_on(long long steps, double t);
  void line(const std::string& text);    ///< a lasting line
  void failure(const std::string& text); ///< the same; on stderr when quiet
  /// A line that also stands in warnings(), once however often it comes.
  void warning(const std::string& text);
  const std::vector<std::string>& warnings() const { return warnings_; }
  void iteration(const solver::IterationReport& report);
  void augmentation(int number, const solver::AugmentReport& report);
  void step(const solver::StepReport& report, long long active_points, double penetration_ratio);
  LogSink sink();

private:
  void live(const std::string& text); ///< replaced by the next line; terminals only
  std::string remaining(double t) const;

  bool is_root_;
  bool active_;
  bool terminal_;
  double begin_ = 0.0, end_;
  int step_ = 1;
  int augmentation_ = 0;
  std::size_t live_width_ = 0;
  std::vector<std::string> warnings_;
  std::chrono::steady_clock::time_point start_;
};

} // namespace abut::app
