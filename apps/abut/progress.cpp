// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <unistd.h>

namespace abut::app {

Progress::Progress(bool is_root, bool quiet, bool launched, double end)
    : is_root_(is_root), active_(is_root && !quiet),
      terminal_(active_ && !launched && isatty(STDOUT_FILENO)), end_(end),
      start_(std::chrono::steady_clock::now()) {}

void Progress::go_on(long long steps, double t) {
  line(fmt::format("goes on from step {} at t = {:.6g}", steps, t));
  step_ = static_cast<int>(steps) + 1;
  begin_ = t;
}

void Progress::line(const std::string& text) {
  if (!active_)
    return;
  if (terminal_ && live_width_ > 0)
    std::cout << '\r' << std::string(live_width_, ' ') << '\r';
  live_width_ = 0;
  std::cout << text << std::endl;
}

void Progress::failure(const std::string& text) {
  if (active_)
    line(text);
  else if (is_root_)
    fmt::print(stderr, "abut: {}\n", text);
}

void Progress::warning(const std::string& text) {
  constexpr std::size_t most = 50; // numbers in them may differ from step to step
  const bool is_new = std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end();
  if (is_new && warnings_.size() <= most)
    warnings_.push_back(warnings_.size() < most ? text : "more of them are in the log");
  line("warning: " + text);
}

void Progress::live(const std::string& text) {
  if (!terminal_)
    return;
  const std::size_t pad = live_width_ > text.size() ? live_width_ - text.size() : 0;
  std::cout << '\r' << text << std::string(pad, ' ') << std::flush;
  live_width_ = text.size();
}

void Progress::iteration(const solver::IterationReport& r) {
  const std::string solve = r.approach ? "approach" : fmt::format("augmentation {}", augmentation_);
  const std::string text = fmt::format("  step {} {} newton {:2d}  residual {:.2e}{}", step_, solve,
                                       r.iteration, r.relative,
                                       r.step_length > 0.0 && r.step_length < 1.0
                                           ? fmt::format("  step length {:.2f}", r.step_length)
                                           : "");
  if (terminal_)
    live(text);
  else
    line(text);
}

void Progress::augmentation(int number, const solver::AugmentReport& r) {
  augmentation_ = number + 1;
  line(fmt::format("  augmentation {}  multiplier change {:.2e}  penetration {:.2e} of a face{}",
                   number, r.change, r.gap, r.reason.empty() ? "" : "  (" + r.reason + ")"));
}

std::string Progress::remaining(double t) const {
  if (t <= begin_ || t >= end_)
    return "";
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = elapsed * (end_ - t) / (t - begin_);
  if (left < 60.0)
    return fmt::format("  about {:.0f} s left", left);
  if (left < 3600.0)
    return fmt::format("  about {:.0f} min left", left / 60.0);
  return fmt::format("  about {:.1f} h left", left / 3600.0);
}

void Progress::step(const solver::StepReport& r, long long active_points,
                    double penetration_ratio) {
  line(fmt::format("step {}  t = {:.6g}  {} iterations  {} augmentations{}  {} points in contact  "
                   "penetration {:.2e} of a face{}",
                   r.step, r.t, r.iterations, r.augmentations,
                   r.cuts > 0 ? fmt::format("  {} cut-backs", r.cuts) : "", active_points,
                   penetration_ratio, remaining(r.t)));
  if (!r.note.empty())
    line("  " + r.note);
  step_ = r.step + 1;
  augmentation_ = 0;
}

LogSink Progress::sink() {
  return [this](LogLevel level, const std::string& message) {
    if (level == LogLevel::warning)
      warning(message);
    else if (level == LogLevel::info)
      line(message);
  };
}

} // namespace abut::app
