// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace abut {

/// A part of the run: from < t <= until, and t = 0 too where it begins with the run. The steps that
/// end in it feel what belongs to it.
struct Window {
  double from = 0.0;
  std::optional<double> until; ///< none: the end of the run

  bool is_whole_run() const { return from <= 0.0 && !until; }
  bool holds(double t) const {
    constexpr double same = 1.0 + 1e-9; // ends of steps are rounded
    return (from <= 0.0 || t > from * same) && (!until || t <= *until * same);
  }
  /// Whether there is a t that lies in both.
  bool overlaps(const Window& other) const {
    return (!until || other.from < *until) && (!other.until || from < *other.until);
  }
  friend bool operator==(const Window& a, const Window& b) {
    return a.from == b.from && a.until == b.until;
  }
};

} // namespace abut
