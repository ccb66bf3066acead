// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::io {

enum class FileKind {
  none,    ///< nothing there, an empty file, or no file (a device)
  mesh,    ///< Exodus without variables
  results, ///< Exodus with variables, or what a run that was killed has left of it
  other,   ///< anything else, e.g. a deck
};

/// What would be lost if the file at `path` were written. Serial.
FileKind kind_of_file(const std::string& path);

} // namespace abut::io
