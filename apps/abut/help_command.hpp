// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

namespace abut::app {

/// abut help [COMMAND], and --version.
void add_help_command(CLI::App& app);

/// Throws InputError, with the nearest word, where argv[1] or the option of a command is none of
/// the program's: CLI11 tells only that it was not expected.
void require_known_words(const CLI::App& app, int argc, const char* const* argv);

} // namespace abut::app
