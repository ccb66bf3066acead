// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace abut::io {

/// Where the links at a path lead, also where nothing is there yet.
inline std::filesystem::path linked(std::filesystem::path path) {
  constexpr int most = 40;
  std::error_code ignored;
  for (int i = 0; i < most && std::filesystem::is_symlink(path, ignored); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  return path;
}

} // namespace abut::io
