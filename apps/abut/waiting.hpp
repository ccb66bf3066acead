// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::app {

/// While it lives, it counts the seconds within calls of MPI, of whatever library: what this rank
/// waits for others and for messages. One at a time.
class WaitingWatch {
public:
  WaitingWatch();
  ~WaitingWatch();
  WaitingWatch(const WaitingWatch&) = delete;

  static double seconds(); ///< so far; 0 where there is none
};

} // namespace abut::app
