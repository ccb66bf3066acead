// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// Adds `abut mesh KIND [--key value ...] -o FILE.exo`, which writes one of the generated meshes.
/// Runs while the command line is parsed; throws InputError for an unknown kind or key.
void add_mesh_command(CLI::App& app);

} // namespace abut::app
