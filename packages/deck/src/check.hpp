// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::deck {

struct Deck;

/// What names refer to inside the deck, before any mesh is read. Throws InputError.
void check_references(const Deck& deck);

} // namespace abut::deck
