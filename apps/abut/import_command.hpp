// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// abut import FILE.feb --output-dir DIR
void add_import_command(CLI::App& app);

} // namespace abut::app
