// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace abut::app {

/// Runs a module of the Python package `abut` with these arguments and returns its exit status. The
/// package lies where it is installed, relative to this program; the interpreter is ABUT_PYTHON of
/// the environment, else that of the distribution, else the first on the path. Throws MachineError
/// when package or interpreter is missing.
int run_python_tool(const std::string& module, const std::vector<std::string>& arguments);

} // namespace abut::app
