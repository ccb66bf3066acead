// SPDX-License-Identifier: BSD-3-Clause
#include "signals.hpp"

#include "abut/core/machine_error.hpp"

#include <cstring>
#include <ctime>
#include <string>

namespace abut::app {

namespace {

volatile sig_atomic_t received = 0;
volatile double first = 0.0; ///< when that was [seconds]; handlers do not interrupt each other

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void note(int number) {
  constexpr double same_signal = 1.0;
  const double now = seconds();
  if (received != 0 && now - first >= same_signal) {
    signal(number, SIG_DFL);
    raise(number);
    return;
  }
  if (received == 0)
    first = now;
  received = number;
}

} // namespace

Signals::Signals() {
  received = 0;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    now.sa_handler = note;
    now.sa_flags = SA_RESTART;
    sigfillset(&now.sa_mask);
    Old old{number, {}};
    sigaction(number, nullptr, &old.action);
    if (old.action.sa_handler == SIG_IGN)
      continue;
    sigaction(number, &now, nullptr);
    old_.push_back(old);
  }
}

/// Where one has come the process is about to end: the same signal, told once more, must not change
/// its status.
Signals::~Signals() {
  if (received != 0)
    return;
  for (const Old& old : old_)
    sigaction(old.number, &old.action, nullptr);
}

void Signals::require_none(const Comm& comm) const {
  const auto number = static_cast<int>(comm.max(Global(received)));
  if (number != 0)
    throw MachineError("ended by signal " + std::to_string(number) + " (" + strsignal(number) +
                       ")");
}

} // namespace abut::app
