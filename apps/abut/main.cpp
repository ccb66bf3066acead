// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.hpp"
#include "exit_status.hpp"
#include "help_command.hpp"
#include "import_command.hpp"
#include "memory_words.hpp"
#include "mesh_command.hpp"
#include "process_start.hpp"
#include "report_command.hpp"
#include "run_command.hpp"
#include "schema_command.hpp"

#include "abut/core/comm.hpp"
#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <cstdio>
#include <new>
#include <string>

namespace {

using abut::app::ExitStatus;

/// One line on stderr in one piece: parts of it could be torn apart by what others print.
void say(const std::string& message) {
  const std::string line = "abut: " + message + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

/// Of what no user can mend.
ExitStatus say_defect(const std::exception& e) {
  if (dynamic_cast<const std::bad_alloc*>(&e) || abut::app::tells_of_memory(e.what())) {
    say(abut::out_of_memory);
    return ExitStatus::machine;
  }
  say(std::string("this is a defect of abut, please report it: ") + e.what());
  return ExitStatus::defect;
}

/// Parses and runs the command. Errors that all ranks agree on are printed once; one that a single
/// rank meets ends all of them.
int run(int argc, char** argv, const abut::Comm& comm) {
  using namespace abut::app;
  CLI::App app{"abut: contact mechanics on Exodus meshes, driven by decks"};
  app.require_subcommand(1);
  int status = ExitStatus::converged;
  add_run_command(app, status);
  add_check_command(app);
  add_import_command(app);
  add_mesh_command(app);
  add_report_command(app, status);
  add_schema_command(app);
  add_help_command(app);
  ExitStatus failure = ExitStatus::defect;
  try {
    require_known_words(app, argc, argv);
    app.parse(argc, argv);
    return status;
  } catch (const CLI::ParseError& e) {
    const int code = comm.is_root() ? app.exit(e) : e.get_exit_code();
    return code == 0 ? ExitStatus::converged : ExitStatus::input;
  } catch (const abut::InputError& e) {
    if (comm.is_root())
      say(e.what());
    return ExitStatus::input;
  } catch (const abut::SolveError& e) {
    if (comm.is_root())
      say(e.what());
    return ExitStatus::stopped;
  } catch (const abut::MachineError& e) {
    if (comm.is_root())
      say(e.what());
    return ExitStatus::machine;
  } catch (const std::exception& e) {
    failure = say_defect(e);
  }
  if (comm.size() > 1)
    MPI_Abort(comm.mpi(), failure); // others may wait for this rank
  return failure;
}

} // namespace

int main(int argc, char** argv) {
  abut::app::prepare_process();
  int program_only = 1; // Kokkos would answer --help itself
  Tpetra::ScopeGuard scope(&program_only, &argv);
  const abut::Comm comm(MPI_COMM_WORLD);
  return run(argc, argv, comm);
}
