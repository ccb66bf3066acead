// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <signal.h>
#include <vector>

namespace abut::app {

/// While it lives SIGINT, SIGTERM and SIGHUP are noted instead of ending the process; another one a
/// second later ends it. What comes sooner is the same one again: a launcher and its group of
/// processes are often told both. Those ignored before, as by nohup, stay so.
class Signals {
public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Throws MachineError on all ranks when any has received one. Collective.
  void require_none(const Comm& comm) const;

private:
  struct Old {
    int number;
    struct sigaction action;
  };
  std::vector<Old> old_;
};

} // namespace abut::app
