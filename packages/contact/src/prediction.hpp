// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "constants.hpp"

namespace abut::contact {

/// Whether what was open on its own stays so while a step is predicted: bodies that move toward it
/// alone would close it, but what it stands on mostly moves along. Held shut by mistake it pulls
/// faces into place that never touch. History: of a point or a node; size: of its faces [length].
template <class History> bool stays_open(const History& last, double size) {
  return !last.in_contact && last.gap > touching_gap * size;
}

} // namespace abut::contact
