// SPDX-License-Identifier: BSD-3-Clause
#include "signals.hpp"

#include "abut/core/machine_error.hpp"

#include <cstring>
#include <string>

namespace abut::app {

namespace {

volatile sig_atomic_t received = 0;

void note(int number) {
  received = number;
}

} // namespace

Signals::Signals() {
  received = 0;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    now.sa_handler = note;
    now.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    Old old{number, {}};
    sigaction(number, nullptr, &old.action);
    if (old.action.sa_handler == SIG_IGN)
      continue;
    sigaction(number, &now, nullptr);
    old_.push_back(old);
  }
}

Signals::~Signals() {
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
