// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <memory>
#include <string>

namespace abut::app {

/// Keeps other runs from writing the same file while it lives, by a lock on FILE.lock that the
/// system takes away with the process: what a killed run leaves behind is no obstacle.
class RunLock {
public:
  /// Throws InputError, naming process and host, when another run holds it. Nothing is locked for
  /// an empty name or a device. Collective.
  RunLock(const Comm& comm, const std::string& file);
  ~RunLock();

private:
  struct File;
  std::unique_ptr<File> file_; ///< on the root
};

} // namespace abut::app
