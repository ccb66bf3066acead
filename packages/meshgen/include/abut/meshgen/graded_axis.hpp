// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace abut::meshgen {

/// Cell sizes along one direction that start fine and grow.
struct Grading {
  double core = 0.0;     ///< length of the uniform part at the start [length]
  double size = 1.0;     ///< cell size there [length]
  double growth = 1.25;  ///< largest ratio of neighbouring cells beyond the core, >= 1
  double max_size = 0.0; ///< no cell grows beyond this [length]; 0: no limit
};

/// Coordinates 0 = x_0 < x_1 < ... < x_n = length: uniform cells in the core, then cells that grow
/// with one ratio, at most `growth`, chosen so that the last one ends at `length`.
/// Throws InputError when a size is not positive or growth is less than 1.
std::vector<double> graded_axis(double length, const Grading& grading);

/// `cells` equal cells from `first` to `last`. Throws InputError when cells < 1 or last <= first.
std::vector<double> uniform_axis(double first, double last, int cells);

} // namespace abut::meshgen
