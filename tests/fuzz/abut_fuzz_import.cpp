// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.hpp"
#include "import_command.hpp"

#include "abut/core/error.hpp"

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <streambuf>
#include <string>
#include <vector>

/// abut_fuzz_import FOLDER: reads names of files from standard input, one in a line, and does with
/// each what `abut import` (FILE.feb, FILE.inp and FILE.msh, into the folder) and `abut check` do, all in one
/// process. Prints "begin FILE" before and "end FILE OUTCOME: MESSAGE" after it, so that whoever
/// reads this knows which file crashed or hung.
namespace {

class Nothing : public std::streambuf {
  int overflow(int c) override { return c == EOF ? 0 : c; }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

struct Outcome {
  std::string word = "ok", message;
};

/// "FILE:LINE" or "FILE: byte N"
bool starts_with_place(const std::string& message, const std::string& file) {
  if (message.compare(0, file.size() + 7, file + ": byte ") == 0)
    return true;
  return message.compare(0, file.size() + 1, file + ":") == 0 &&
         std::isdigit(static_cast<unsigned char>(message[file.size() + 1]));
}

Outcome command(std::vector<std::string> words) {
  CLI::App app;
  abut::app::add_import_command(app);
  abut::app::add_check_command(app);
  const std::string file = words[1];
  const bool is_import = words[0] == "import";
  std::vector<std::string> reversed(words.rbegin(), words.rend()); // as CLI11 wants them
  try {
    app.parse(reversed);
    return {};
  } catch (const abut::InputError& e) {
    const bool placed = !is_import || starts_with_place(e.what(), file);
    return {placed ? "input_error" : "unplaced", e.what()};
  } catch (const abut::SolveError& e) {
    return {"solve_error", e.what()};
  } catch (const abut::Defect& e) {
    return {"defect", e.what()};
  } catch (const std::exception& e) {
    return {"exception", e.what()};
  }
}

Outcome try_file(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  const std::string kind = path.extension().string();
  if (kind != ".feb" && kind != ".inp" && kind != ".msh")
    return command({"check", file});
  const Outcome imported = command({"import", file, "--output-dir", folder});
  if (imported.word != "ok")
    return imported;
  const std::string stem = (std::filesystem::path(folder) / path.stem()).string();
  Outcome checked = command({"check", stem + ".yaml"});
  for (const char* suffix : {".yaml", ".exo", ".import.txt"})
    std::filesystem::remove(stem + suffix);
  // A deck made of a Gmsh mesh is one to start from: nothing is held yet.
  if (path.extension() == ".msh" && checked.message.find(" is free to move: ") != std::string::npos)
    checked.word = "ok";
  checked.message = "imported; check: " + checked.message;
  return checked;
}

} // namespace

int main(int argc, char** argv) {
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  int program_only = 1;
  Tpetra::ScopeGuard scope(&program_only, &argv);
  if (argc != 2) {
    std::fputs("usage: abut_fuzz_import FOLDER < names of files\n", stderr);
    return 2;
  }
  Nothing nothing;
  std::streambuf* const out = std::cout.rdbuf(&nothing);
  std::string file;
  while (std::getline(std::cin, file)) {
    std::printf("begin %s\n", file.c_str());
    std::fflush(stdout);
    const Outcome outcome = try_file(file, argv[1]);
    const std::string line = outcome.message.substr(0, outcome.message.find('\n'));
    std::printf("end %s %s: %s\n", file.c_str(), outcome.word.c_str(), line.c_str());
    std::fflush(stdout);
  }
  std::cout.rdbuf(out);
  return 0;
}
