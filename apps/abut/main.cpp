// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.hpp"
#include "import_command.hpp"
#include "mesh_command.hpp"
#include "process_start.hpp"
#include "run_command.hpp"
#include "schema_command.hpp"

#include "abut/core/comm.hpp"
#include "abut/core/error.hpp"

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <cstdio>
#include <string>

namespace {

enum Exit { converged = 0, stopped = 1, input = 2, defect = 3 };

/// One line on stderr in one piece: parts of it could be torn apart by what others print.
void say(const std::string& message) {
  const std::string line = "abut: " + message + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

/// Of what no user can mend.
void say_defect(const std::exception& e) {
  say(std::string("this is a defect of abut, please report it: ") + e.what());
}

/// Parses and runs the command. Errors that all ranks agree on are printed once; one that a single
/// rank meets ends all of them.
int run(int argc, char** argv, const abut::Comm& comm) {
  using namespace abut::app;
  CLI::App app{"abut: contact mechanics on Exodus meshes, driven by decks"};
  app.require_subcommand(1);
  int status = converged;
  add_run_command(app, status);
  add_check_command(app);
  add_import_command(app);
  add_mesh_command(app);
  add_schema_command(app);
  try {
    app.parse(argc, argv);
    return status;
  } catch (const CLI::ParseError& e) {
    const int code = comm.is_root() ? app.exit(e) : e.get_exit_code();
    return code == 0 ? converged : input;
  } catch (const abut::InputError& e) {
    if (comm.is_root())
      say(e.what());
    return input;
  } catch (const abut::SolveError& e) {
    if (comm.is_root())
      say(e.what());
    return stopped;
  } catch (const abut::Defect& e) {
    say_defect(e);
  } catch (const std::exception& e) {
    say_defect(e);
  }
  if (comm.size() > 1)
    MPI_Abort(comm.mpi(), defect); // others may wait for this rank
  return defect;
}

} // namespace

int main(int argc, char** argv) {
  abut::app::prepare_process();
  int program_only = 1; // Kokkos would answer --help itself
  Tpetra::ScopeGuard scope(&program_only, &argv);
  const abut::Comm comm(MPI_COMM_WORLD);
  return run(argc, argv, comm);
}
