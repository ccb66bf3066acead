// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::app {

/// What the program tells the shell; numbers are a contract (docs/user/first-run.md).
enum ExitStatus {
  converged = 0,
  stopped = 1,    ///< the solve ended early
  input = 2,      ///< the user's input is wrong
  defect = 3,     ///< abut is wrong
  unverified = 4, ///< converged, but 'verify' failed, and --strict-verify asks
  machine = 5,    ///< disk full, no memory, a signal
};

} // namespace abut::app
