// SPDX-License-Identifier: BSD-3-Clause
#include "python_tool.hpp"

#include "exit_status.hpp"

#include "abut/core/machine_error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace abut::app {

namespace {

namespace fs = std::filesystem;

/// The folder that holds the package; the build tree is laid out as what is installed.
fs::path package_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = (program.parent_path() / ABUT_PYTHON_FOLDER).lexically_normal();
  if (!fs::is_directory(folder / "abut", error))
    throw MachineError("the Python part of abut is not in '" + folder.string() +
                       "', where it is installed with the program; install it again");
  return folder;
}

std::string interpreter() {
  constexpr const char* of_distribution = "/usr/bin/python3"; // has the packages of apt-get
  const char* given = std::getenv("ABUT_PYTHON");
  if (given && *given)
    return given;
  return access(of_distribution, X_OK) == 0 ? of_distribution : "python3";
}

void prepend_to_path(const char* variable, const std::string& folder) {
  const char* before = std::getenv(variable);
  setenv(variable, (before && *before ? folder + ":" + before : folder).c_str(), 1);
}

} // namespace

int run_python_tool(const std::string& module, const std::vector<std::string>& arguments) {
  prepend_to_path("PYTHONPATH", package_folder().string());
  setenv("PYTHONSAFEPATH", "1", 1); // no modules from the folder where the user happens to be
  std::vector<std::string> words = {interpreter(), "-B", "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> line;
  for (std::string& word : words)
    line.push_back(word.data());
  line.push_back(nullptr);
  std::fflush(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, line[0], nullptr, nullptr, line.data(), environ);
  if (error != 0)
    throw MachineError("cannot start the Python interpreter '" + words[0] +
                       "': " + std::strerror(error) +
                       "; on Debian: apt-get install python3, elsewhere: ABUT_PYTHON=PATH");
  int state = 0;
  while (waitpid(child, &state, 0) < 0)
    if (errno != EINTR)
      throw MachineError("lost the Python interpreter '" + words[0] + "'");
  return WIFEXITED(state) ? WEXITSTATUS(state) : ExitStatus::machine;
}

} // namespace abut::app
