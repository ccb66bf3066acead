// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace abut::app {

/// `abut report`; leaves the exit status of the tool in `status`, which must outlive the app.
void add_report_command(CLI::App& app, int& status);

} // namespace abut::app
