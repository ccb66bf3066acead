// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include <string>
#include <vector>

namespace abut::app {

/// What the program has chosen for an interface, and why: a line for each choice. A second pass
/// makes those of the first.
std::vector<std::string> choices_of(const Model& model, const contact::Settings& settings);

} // namespace abut::app
