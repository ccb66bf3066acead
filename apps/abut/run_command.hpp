// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// `abut run DECK [--summary FILE.json] [--output-dir DIR] [--quiet]`. The callback leaves the exit
/// status in `status`: 0 all steps converged, 1 stopped early.
void add_run_command(CLI::App& app, int& status);

} // namespace abut::app
