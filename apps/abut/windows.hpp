// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"

#include <string>
#include <vector>

namespace abut::app {

/// A sentence for each window of the deck that begins or ends where no step does.
std::vector<std::string> windows_between_steps(const deck::Deck& deck);

/// Paths in the deck of what begins or ends at t, the end of a step.
std::vector<std::string> windows_at(const deck::Deck& deck, double t);

} // namespace abut::app
