// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace abut {

enum class LogLevel { detail, info, warning };

/// Where messages of the library go. The host supplies it; an empty one is silent.
using LogSink = std::function<void(LogLevel, const std::string&)>;

inline void log(const LogSink& sink, LogLevel level, const std::string& message) {
  if (sink)
    sink(level, message);
}

} // namespace abut
