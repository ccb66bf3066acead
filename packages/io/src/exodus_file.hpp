// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exodusII.h>

#include <string>

namespace abut::io {

/// An open Exodus file with 64-bit integers towards the program, closed at the end.
class ExodusFile {
public:
  static ExodusFile open(const std::string& path);
  static ExodusFile create(const std::string& path);

  ExodusFile(ExodusFile&& other) noexcept : path_(std::move(other.path_)), id_(other.id_) {
    other.id_ = -1;
  }
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;
  ~ExodusFile();

  /// The open file gets this name, in place of what had it. Throws MachineError.
  void move_to(const std::string& path);

  int id() const { return id_; }
  const std::string& path() const { return path_; }

  /// Throws with the library's error text when a call failed (status < 0): MachineError where the
  /// system has refused it (disk full), else InputError.
  void check(int status, const char* action) const;
  [[noreturn]] void fail(const std::string& what) const;

private:
  ExodusFile(std::string path, int id) : path_(std::move(path)), id_(id) {}

  std::string path_;
  int id_ = -1;
};

} // namespace abut::io
