// SPDX-License-Identifier: BSD-3-Clause
#include "exodus_file.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <netcdf.h>

namespace abut::io {

namespace {

/// Code and the library's own words for its last error.
std::string library_error(int& code) {
  const char* message = nullptr;
  const char* function = nullptr;
  ex_get_err(&message, &function, &code);
  std::string text;
  // Codes of NetCDF and of the system are small; those of Exodus itself go with the message.
  if (code != 0 && std::abs(code) < 500)
    text = nc_strerror(code);
  if (message && *message)
    text += (text.empty() ? "" : "; ") + std::string(message);
  return text.empty() ? "no further information" : text;
}

std::string library_error() {
  int code = 0;
  return library_error(code);
}

/// NetCDF hands errors of the system on as they are, above its own, which are negative.
bool is_of_system(int code) {
  return code == ENOSPC || code == EDQUOT || code == EFBIG || code == EIO || code == ENOMEM;
}

} // namespace

ExodusFile ExodusFile::open(const std::string& path) {
  ex_opts(0); // errors are thrown, not printed
  errno = 0;
  if (!std::ifstream(path))
    throw InputError("mesh file '" + path +
                     "': cannot be read: " + (errno ? std::strerror(errno) : "no such file"));
  int word = sizeof(double), file_word = 0;
  float version = 0.0F;
  const int id = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &word, &file_word, &version);
  if (id < 0)
    throw InputError("mesh file '" + path + "': not a readable Exodus II file: " + library_error());
  return {path, id};
}

ExodusFile ExodusFile::create(const std::string& path) {
  ex_opts(0);
  errno = 0;
  if (!std::ofstream(path, std::ios::app)) {
    const std::string what =
        "'" + path + "' cannot be written: " + (errno ? std::strerror(errno) : "unknown reason");
    if (is_of_system(errno))
      throw MachineError(what);
    throw InputError(what);
  }
  int word = sizeof(double), file_word = sizeof(double);
  const int id =
      ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL | EX_ALL_INT64_API, &word, &file_word);
  if (id < 0)
    throw InputError("'" + path + "' cannot be written: " + library_error());
  return {path, id};
}

ExodusFile::~ExodusFile() {
  if (id_ >= 0)
    ex_close(id_);
}

void ExodusFile::move_to(const std::string& path) {
  if (std::rename(path_.c_str(), path.c_str()) != 0)
    throw MachineError("cannot write '" + path + "': " + std::strerror(errno));
  path_ = path;
}

void ExodusFile::check(int status, const char* action) const {
  if (status >= 0)
    return;
  int code = 0;
  const std::string what = std::string("cannot ") + action + ": " + library_error(code);
  if (is_of_system(code))
    throw MachineError("file '" + path_ + "': " + what);
  fail(what);
}

void ExodusFile::fail(const std::string& what) const {
  throw InputError("file '" + path_ + "': " + what);
}

} // namespace abut::io
