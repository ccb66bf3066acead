// SPDX-License-Identifier: BSD-3-Clause
#include "run_command.hpp"

#include "audit_watch.hpp"
#include "augmentation.hpp"
#include "checkpoints.hpp"
#include "exit_status.hpp"
#include "memory_words.hpp"
#include "protect.hpp"
#include "recorder.hpp"
#include "restart.hpp"
#include "run_lock.hpp"
#include "signals.hpp"
#include "summary.hpp"
#include "verify.hpp"
#include "waiting.hpp"
#include "why_stopped.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/scene/start_motion.hpp"
#include "abut/scene/state.hpp"
#include "abut/scene/supports.hpp"
#include "abut/scene/tangent_check.hpp"
#include "abut/solver/assembled_system.hpp"
#include "abut/solver/linear_solver.hpp"

#include <CLI/CLI.hpp>
#include <Teuchos_ParameterListExceptions.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace abut::app {

namespace {

struct RunOptions {
  std::string deck, summary, restart, output_dir = ".";
  bool quiet = false, strict_verify = false;
};

std::string output_stem(const deck::Deck& deck, const std::string& dir) {
  const std::string name = deck.output.name.empty()
                               ? std::filesystem::path(deck.file).stem().string()
                               : deck.output.name;
  return (std::filesystem::path(dir) / name).string();
}

std::string checkpoint_path(const std::string& stem) {
  return stem + ".checkpoint";
}

/// The results must not land on the mesh they are computed on, nor on anything but results; so with
/// checkpoints.
void protect_files(const Model& m, const std::string& stem, int part) {
  namespace fs = std::filesystem;
  m.comm.on_root([&] {
    std::error_code error;
    if (!m.deck.mesh.file.empty() && fs::equivalent(m.deck.mesh_path(), stem + ".exo", error))
      throw InputError(m.deck.where("mesh.file") + ": the results would overwrite the mesh '" +
                       m.deck.mesh.file + "'; give another --output-dir or 'output: {name: ...}'");
    protect_from_results(stem + ".exo" + io::part_suffix(part));
    if (m.deck.output.history)
      protect_from_history(stem);
    if (m.deck.output.checkpoint.active)
      protect_from_checkpoint(checkpoint_path(stem));
  });
}

void create_folder(const Comm& comm, const std::string& dir) {
  comm.on_root([&] {
    std::error_code error;
    std::filesystem::create_directories(dir, error);
    if (error || !std::filesystem::is_directory(dir))
      throw InputError("cannot write to the output folder '" + dir +
                       "': " + (error ? error.message() : "it is not a folder"));
  });
}

void print_verdicts(Progress& progress, const std::vector<Verdict>& verdicts) {
  for (const Verdict& v : verdicts) {
    const std::string text =
        fmt::format("verify {:<28} {:>14.7g}  expected {:>14.7g} +- {:.2g}  {}", v.name, v.value,
                    v.expected, v.tolerance, v.ok ? "ok" : "FAILED");
    if (v.ok)
      progress.line(text);
    else
      progress.failure(text);
  }
}

void announce(const Model& m, Progress& progress) {
  progress.line(fmt::format("{}: {} nodes, {} elements, {} unknowns on {} rank{}",
                            m.deck.title.empty() ? m.deck.file : m.deck.title, m.mesh->num_nodes,
                            m.mesh->num_elements, m.equations->dofs().num_global_rows() * 3,
                            m.comm.size(), m.comm.size() > 1 ? "s" : ""));
  for (const std::string& shift : shifts_of_start(m))
    progress.line(shift);
  for (const auto& list : {m.warnings, warnings_of_start(m)})
    for (const std::string& warning : list)
      progress.warning(warning);
}

/// What Teuchos says, without its line breaks, its counter and the place in its sources.
std::string one_line(const std::string& what) {
  std::string said = what.substr(0, what.find("\n\nThrow number"));
  if (const auto test = what.find("evaluated to true:");
      test < what.size() && !said.empty() && said.back() == ':')
    said = what.substr(std::min(what.find("\n\n", test), what.size() - 2) + 2);
  std::replace(said.begin(), said.end(), '\n', ' ');
  return said.substr(0, said.find_last_not_of(' ') + 1);
}

/// Evaluates the equations at the start and refuses bodies that nothing holds.
void prepare(Model& m, solver::AssembledSystem& system, const Vector& x) {
  Vector f(x.getMap());
  m.comm.together([&] { system.residual(x, f); });
  if (!m.deck.dynamics.active) // else inertia holds
    scene::require_supports(m.deck, m, x,
                            [&](const std::string& key) { return m.deck.where(key); });
}

/// What follows a solve that Newton has brought to its end; empty: nothing.
solver::AugmentCallback after_solve(Model& m, const contact::AugmentationPolicy& policy,
                                    Progress& progress) {
  auto augment = make_augmentation(
      policy, [&](int n, const auto& report) { progress.augmentation(n, report); },
      [&](const std::string& text) { progress.warning(text); });
  if (m.deck.check == deck::ModelCheck::tangent)
    augment = scene::with_tangent_check(m, std::move(augment),
                                        [&](const std::string& text) { progress.line(text); });
  return augment;
}

/// How a run came to its end.
struct Outcome {
  solver::LoadResult result;
  bool machine = false; ///< a MachineError has ended it
  bool written = true;  ///< the last converged state is in the files

  void end_by(const std::exception& e) {
    if (!machine)
      result.reason = e.what();
    machine = true;
    result.converged = false;
  }
};

solver::NewtonOptions newton_options(const Model& m, const contact::AugmentationPolicy& policy) {
  solver::NewtonOptions options = m.deck.newton;
  options.inexact = options.inexact && policy.allows_loose_solves();
  return options;
}

/// Raises the load; x and the equations are then those of the last converged step.
Outcome solve(Model& m, solver::AssembledSystem& system, solver::AugmentedLagrangian& loop,
              Vector& x, const solver::Standing& from, Progress& progress, Recorder& recorder,
              Checkpoints& checkpoints, const Signals& signals) {
  solver::LoadStepping stepping(loop, m.deck.time, progress.sink());
  Vector last(x, Teuchos::Copy);
  Outcome outcome;
  try {
    outcome.result = stepping.run(
        system, x,
        [&](const auto& report, const Vector& at) {
          Tpetra::deep_copy(last, at);
          recorder.step(report, at);
        },
        [&](const auto& report) {
          signals.require_none(m.comm);
          recorder.iteration(report);
        },
        from,
        [&](const solver::Standing& standing) {
          if (checkpoints.step(standing))
            loop.newton().linear().forget(); // as a run does that starts here
        });
  } catch (const MachineError& e) {
    outcome.end_by(e);
    outcome.result.t = recorder.state().time;
    outcome.result.counters = recorder.counters();
    system.reject();
    Tpetra::deep_copy(x, last);
  } catch (const Teuchos::Exceptions::InvalidParameter& e) {
    throw InputError(m.deck.where("trilinos") +
                     ": Trilinos does not take this list: " + one_line(e.what()));
  }
  if (tells_of_memory(outcome.result.reason))
    outcome.end_by(MachineError(outcome.result.reason + "\nThat is: " + out_of_memory));
  if (!outcome.result.converged) {
    Vector f(x.getMap());
    system.set_time(outcome.result.t);
    system.residual(x, f);
  }
  return outcome;
}

/// Writes the last converged state, where it has not been.
void write_last(Recorder& recorder, Outcome& outcome) {
  try {
    recorder.finish(outcome.result.counters);
  } catch (const MachineError& e) {
    outcome.end_by(e);
    outcome.written = false;
  }
}

/// Printed. Verdicts of a run that stopped have failed, for they speak of its end.
std::vector<Verdict> judge(const Model& m, const scene::State& state, bool converged,
                           Progress& progress) {
  auto verdicts = verify(m, state);
  if (converged)
    print_verdicts(progress, verdicts);
  else
    for (Verdict& v : verdicts)
      v.ok = false;
  return verdicts;
}

/// Those of the solver's methods that did anything.
std::vector<solver::LinearUse> used_methods(const solver::LinearSolver& linear) {
  std::vector<solver::LinearUse> used;
  for (solver::LinearUse& use : linear.uses())
    if (use.solves + use.setups + use.failures > 0)
      used.push_back(std::move(use));
  return used;
}

void say_what_linear_solves_cost(const std::vector<solver::LinearUse>& used, Progress& progress) {
  for (const solver::LinearUse& use : used)
    progress.line(fmt::format("linear solver: {}  {} systems  {} iterations  {} setups  {:.2f} s, "
                              "{:.2f} of them for setups{}",
                              use.method, use.systems, use.iterations, use.setups, use.seconds,
                              use.setup_seconds,
                              use.failures > 0 ? fmt::format("  failed on {}", use.failures) : ""));
}

void say_how_it_ended(const Model& m, const Outcome& outcome, double seconds,
                      const std::string& file, Progress& progress) {
  const solver::LoadResult& result = outcome.result;
  if (result.converged)
    progress.line(fmt::format("converged: {} steps, {} Newton iterations, {:.2f} s; results in {}",
                              result.counters.steps, result.counters.newton_iterations, seconds,
                              file));
  else if (m.comm.is_root())
    fmt::print(stderr, "abut: stopped at t = {:.6g} of {:.6g}: {}\n{} is in {}\n", result.t,
               m.deck.time.end, result.reason,
               outcome.written ? "Everything up to there" : "What could be written", file);
}

/// All that has a state between two steps, in the order in which it can be taken.
ExchangeState owners_of_state(Model& m, solver::NewtonSolver& newton, Vector& x,
                              Recorder& recorder) {
  return [&](StateArchive& archive, solver::Standing& standing) {
    solver::exchange_state(archive, x.getMap(), m.equations->dofs().row_keys(), standing);
    scene::exchange_state(archive, m, x);
    newton.exchange_state(archive);
    recorder.exchange_state(archive, x);
  };
}

/// What the user hears and reads of a run that has ended; returns its exit status.
int conclude(const Model& m, const RunOptions& options, Outcome& outcome, const Recorder& recorder,
             const AuditWatch& audit, const solver::LinearSolver& linear,
             const solver::Stopwatch& watch, Progress& progress) {
  solver::LoadResult& result = outcome.result;
  if (!result.converged && !outcome.machine)
    result.reason += why_stopped(m, recorder, result);
  for (const auto& list : {audit.warnings(), recorder.watch().warnings(m, result.converged),
                           warnings_of_penalty(m, recorder.penalty_error())})
    for (const std::string& warning : list)
      progress.warning(warning);

  RunFacts facts;
  facts.converged = result.converged;
  facts.reason = result.reason;
  facts.warnings = progress.warnings();
  facts.penalty = recorder.penalty_error();
  facts.audit = audit.worst();
  facts.audit_seconds = audit.seconds();
  facts.wall_seconds = watch.seconds();
  facts.waiting_seconds = WaitingWatch::seconds();
  facts.linear = used_methods(linear);
  facts.results = recorder.path();
  facts.convergence = &recorder.convergence();
  say_what_linear_solves_cost(facts.linear, progress);
  const auto verdicts = judge(m, recorder.state(), result.converged, progress);
  say_how_it_ended(m, outcome, facts.wall_seconds, recorder.path(), progress);
  write_summary(m, recorder.state(), facts, verdicts, options.summary);
  const bool verified =
      std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.ok; });
  if (!result.converged)
    return outcome.machine ? ExitStatus::machine : ExitStatus::stopped;
  return verified || !options.strict_verify ? ExitStatus::converged : ExitStatus::unverified;
}

int run(const RunOptions& options) {
  const Comm comm(MPI_COMM_WORLD);
  const solver::Stopwatch watch;
  const WaitingWatch waiting;
  create_folder(comm, options.output_dir);
  if (!options.summary.empty())
    comm.on_root([&] { protect_from_summary(options.summary); });
  const auto model = build_model(comm, options.deck);
  Model& m = *model;
  std::optional<Restart> restart;
  if (!options.restart.empty())
    restart.emplace(m, options.restart);
  const int part = restart ? restart->part() : 1;
  const std::string stem = output_stem(m.deck, options.output_dir);
  protect_files(m, stem, part);
  const RunLock lock(comm, stem + ".exo"), summary_lock(comm, options.summary);
  Progress progress(comm.is_root(), options.quiet, comm.size() > 1, m.deck.time.end);

  Vector x(m.equations->dofs().map());
  solver::AssembledSystem system(*m.equations);
  prepare(m, system, x);
  announce(m, progress);
  const auto linear =
      solver::make_linear_solver(m.deck.linear, system, progress.sink(), m.timers.get());
  if (m.deck.dynamics.active)
    scene::start_motion(m.deck, m, *linear, x);
  const contact::AugmentationPolicy policy(m.contacts, [&m] { return scene::energy_of_bodies(m); });
  solver::NewtonSolver newton(*linear, newton_options(m, policy), m.deck.linear.tolerance);
  solver::AugmentedLagrangian loop(newton, after_solve(m, policy, progress));
  AuditWatch audit(m, m.equations->nodal_values(x));
  system.set_check([&audit] { audit.look(); });
  Recorder recorder(m, stem, part, progress, audit, x);
  const ExchangeState exchange = owners_of_state(m, newton, x, recorder);
  solver::Standing standing;
  if (restart) {
    standing = restart->take(exchange);
    progress.go_on(standing.counters.steps, standing.t);
  }
  Checkpoints checkpoints(m, checkpoint_path(stem), part, exchange, progress);
  const Signals signals; // to the end: none of them cuts what is being written
  Outcome outcome = solve(m, system, loop, x, standing, progress, recorder, checkpoints, signals);
  write_last(recorder, outcome);
  if (!outcome.result.converged)
    checkpoints.finish();
  const int status = conclude(m, options, outcome, recorder, audit, *linear, watch, progress);
  checkpoints.finish(); // of the end last: who finds it finds all that the run was to write
  return status;
}

} // namespace

void add_run_command(CLI::App& app, int& status) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Solve the scene of a deck");
  command->add_option("DECK", options->deck, "YAML or XML deck")->required();
  command->add_option("--summary", options->summary, "Write what the run found and spent as JSON");
  command->add_option("--output-dir", options->output_dir, "Folder of the results");
  command->add_option("--restart", options->restart,
                      "Go on from a checkpoint of this deck's model, on any number of ranks");
  command->add_flag("--quiet", options->quiet, "Print errors and failed comparisons only");
  command->add_flag("--strict-verify", options->strict_verify,
                    "End with status 4 when a comparison of 'verify' fails");
  command->callback([options, &status] { status = run(*options); });
}

} // namespace abut::app
