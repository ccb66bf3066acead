// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::app {

/// Whether a message tells of missing memory: libraries, and what wraps their errors, say so in
/// words alone.
inline bool tells_of_memory(const std::string& message) {
  constexpr const char* words[] = {"std::bad_alloc", "failed to allocate memory"}; // Kokkos
  for (const char* word : words)
    if (message.find(word) != std::string::npos)
      return true;
  return false;
}

} // namespace abut::app
