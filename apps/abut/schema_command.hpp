// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// `abut schema [--markdown | --json]`: prints the deck reference to stdout.
void add_schema_command(CLI::App& app);

} // namespace abut::app
