// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// `abut check DECK`: validates the deck and explains the scene without solving.
void add_check_command(CLI::App& app);

} // namespace abut::app
