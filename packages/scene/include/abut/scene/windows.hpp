// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/options.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A sentence for each window of the options that begins or ends where no step does.
std::vector<std::string> windows_between_steps(const Options& options);

/// Paths in the options of what begins or ends at t, the end of a step.
std::vector<std::string> windows_at(const Options& options, double t);

} // namespace abut::scene
