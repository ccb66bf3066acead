// SPDX-License-Identifier: BSD-3-Clause
#include "abut/io/file_kind.hpp"

#include "abut/core/error.hpp"
#include "exodus_file.hpp"

#include <filesystem>
#include <fstream>

namespace abut::io {

namespace {

/// NetCDF in one of its formats, readable or not.
bool is_netcdf(const std::string& path) {
  std::string start(4, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), 4);
  return start.compare(0, 3, "CDF") == 0 || start == "\x89HDF";
}

bool has_variables(const ExodusFile& file) {
  for (const ex_entity_type type : {EX_GLOBAL, EX_NODAL, EX_ELEM_BLOCK}) {
    int count = 0;
    if (ex_get_variable_param(file.id(), type, &count) >= 0 && count > 0)
      return true;
  }
  return false;
}

} // namespace

FileKind kind_of_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path) == 0)
    return FileKind::none;
  if (!is_netcdf(path))
    return FileKind::other;
  try {
    return has_variables(ExodusFile::open(path)) ? FileKind::results : FileKind::mesh;
  } catch (const InputError&) {
    return FileKind::results;
  }
}

} // namespace abut::io
