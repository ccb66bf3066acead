// SPDX-License-Identifier: BSD-3-Clause
#include "protect.hpp"

#include "abut/core/error.hpp"
#include "abut/io/checkpoint_file.hpp"
#include "abut/io/file_kind.hpp"
#include "abut/io/history_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace abut::app {

namespace {

namespace fs = std::filesystem;

std::string name(io::FileKind kind) {
  if (kind == io::FileKind::mesh)
    return "a mesh";
  return kind == io::FileKind::results ? "results of a run" : "a file of another kind";
}

std::string start_of(const std::string& path) {
  std::string start(64, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<long>(start.size()));
  return start;
}

/// Summaries begin with their status.
bool is_summary(const std::string& path) {
  const std::string start = start_of(path);
  const std::size_t first = start.find_first_not_of("{ \r\n\t");
  return start[0] == '{' && first != std::string::npos &&
         start.compare(first, 8, "\"status\"") == 0;
}

/// Throws unless what is at the path is nothing, or may be written over: of a file, and asked of no
/// device.
template <class Replaceable>
void protect(const std::string& path, const Replaceable& replaceable, const std::string& what,
             const std::string& advice) {
  const io::FileKind kind = io::kind_of_file(path);
  if (kind != io::FileKind::none && !replaceable(kind))
    throw InputError(what + " would overwrite '" + path + "', which is " + name(kind) + "; " +
                     advice);
}

} // namespace

void protect_from_results(const std::string& path) {
  protect(
      path, [](io::FileKind kind) { return kind == io::FileKind::results; }, "the results",
      "give another --output-dir or 'output: {name: ...}'");
}

void protect_from_import(const std::string& path) {
  const io::FileKind kind = io::kind_of_file(path);
  const std::string start = start_of(path);
  const bool is_imported =
      start.rfind("# From FEBio's ", 0) == 0 || start.rfind("# From Abaqus or CalculiX: ", 0) == 0;
  if (kind != io::FileKind::none && !is_imported)
    throw InputError(
        "the imported deck would overwrite '" + path +
        "', which has not been imported; give another --output-dir or remove it first");
}

void protect_from_mesh(const std::string& path) {
  protect(
      path, [](io::FileKind kind) { return kind == io::FileKind::mesh; }, "the mesh",
      "give another name or remove it first");
}

void protect_from_history(const std::string& stem) {
  const auto check = [](const std::string& path, const char* begins) {
    protect(
        path, [&](io::FileKind) { return start_of(path).rfind(begins, 0) == 0; }, "the history",
        "give another --output-dir, 'output: {name: ...}' or 'output: {history: false}'");
  };
  check(io::history_path(stem), "t,steps,");
  check(io::history_columns_path(stem), "[\n {\n  \"name\": \"t\"");
}

void protect_from_checkpoint(const std::string& path) {
  protect(
      path, [&](io::FileKind) { return io::is_checkpoint(path); }, "the checkpoint",
      "give another --output-dir or 'output: {name: ...}'");
}

void protect_from_summary(const std::string& path) {
  protect(
      path, [&](io::FileKind) { return is_summary(path); }, "the summary",
      "give --summary another name or remove it first");
  const bool was_there = fs::exists(path);
  errno = 0;
  if (fs::is_directory(path) || !std::ofstream(path, std::ios::app))
    throw InputError("cannot write the summary '" + path +
                     "': " + (errno ? std::strerror(errno) : "it is a folder"));
  std::error_code ignored;
  if (!was_there)
    fs::remove(path, ignored);
}

} // namespace abut::app
