// SPDX-License-Identifier: BSD-3-Clause
#include "run_command.hpp"

#include "augmentation.hpp"
#include "points_file.hpp"
#include "progress.hpp"
#include "summary.hpp"
#include "verify.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/scene/results.hpp"
#include "abut/scene/start_motion.hpp"
#include "abut/scene/supports.hpp"
#include "abut/scene/tangent_check.hpp"
#include "abut/scene/windows.hpp"
#include "abut/solver/assembled_system.hpp"
#include "abut/solver/linear_solver.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace abut::app {

namespace {

struct RunOptions {
  std::string deck, summary, output_dir = ".";
  bool quiet = false;
};

std::string output_stem(const deck::Deck& deck, const std::string& dir) {
  const std::string name = deck.output.name.empty()
                               ? std::filesystem::path(deck.file).stem().string()
                               : deck.output.name;
  return (std::filesystem::path(dir) / name).string();
}

/// The results must not land on the mesh they are computed on.
void protect_mesh(const Model& m, const std::string& stem) {
  namespace fs = std::filesystem;
  m.comm.on_root([&] {
    std::error_code error;
    if (m.deck.mesh.file.empty() || !fs::equivalent(m.deck.mesh_path(), stem + ".exo", error))
      return;
    throw InputError(m.deck.where("mesh.file") + ": the results would overwrite the mesh '" +
                     m.deck.mesh.file + "'; give another --output-dir or 'output: {name: ...}'");
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
  for (const Verdict& v : verdicts)
    progress.line(fmt::format("verify {:<28} {:>14.7g}  expected {:>14.7g} +- {:.2g}  {}", v.name,
                              v.value, v.expected, v.tolerance, v.ok ? "ok" : "FAILED"));
}

/// What may be the reason for a step that fails right after t.
std::string changes_at(const Model& m, double t) {
  std::string list;
  for (const std::string& path : scene::windows_at(m.deck, t))
    list += (list.empty() ? "" : ", ") + path;
  return list.empty() ? ""
                      : "\nThere begins or ends: " + list +
                            ". What is let go must be held by something else, or balance itself";
}

int run(const RunOptions& options) {
  const Comm comm(MPI_COMM_WORLD);
  const auto start = std::chrono::steady_clock::now();
  create_folder(comm, options.output_dir);
  const auto model = build_model(comm, options.deck);
  Model& m = *model;
  const std::string stem = output_stem(m.deck, options.output_dir);
  protect_mesh(m, stem);
  Progress progress(comm.is_root(), options.quiet, comm.size() > 1, m.deck.time.end);

  const auto map = m.equations->dofs().map();
  Vector x(map), f(map);
  solver::AssembledSystem system(*m.equations);
  comm.together([&] { system.residual(x, f); });
  if (!m.deck.dynamics.active) // else inertia holds
    scene::require_supports(m.deck, m, [&](const std::string& key) { return m.deck.where(key); });
  const auto linear =
      solver::make_linear_solver(m.deck.linear, system, progress.sink(), m.timers.get());
  progress.line(fmt::format("{}: {} nodes, {} elements, {} unknowns on {} rank{}",
                            m.deck.title.empty() ? m.deck.file : m.deck.title, m.mesh->num_nodes,
                            m.mesh->num_elements, m.equations->dofs().num_global_rows() * 3,
                            comm.size(), comm.size() > 1 ? "s" : ""));

  for (const std::string& warning : m.warnings)
    progress.line("warning: " + warning);
  if (m.deck.dynamics.active)
    scene::start_motion(m.deck, m, *linear, x);
  scene::State state = scene::make_state(m, x, 0.0, {});
  const double kinetic_at_start = state.energy.kinetic_at_start = state.energy.kinetic;
  io::ResultWriter writer(stem, *m.mesh, scene::result_names(m), m.deck.output.files);
  std::optional<PointsFile> points;
  if (m.deck.output.points)
    points.emplace(m, stem);
  long long augmentations = 0; // of the last step
  const auto write = [&] {
    const PhaseTimers::Scope scope(*m.timers, Phase::output);
    writer.write_step(scene::result_step(m, state));
    if (points)
      points->write(state.time, augmentations);
  };
  write();
  double written = 0.0;

  const contact::AugmentationPolicy policy(m.contacts);
  solver::NewtonOptions newton_options = m.deck.newton;
  newton_options.inexact = newton_options.inexact && policy.allows_loose_solves();
  solver::NewtonSolver newton(*linear, newton_options, m.deck.linear.tolerance);
  auto augment = make_augmentation(
      policy, [&](int n, const auto& report) { progress.augmentation(n, report); },
      [&](const std::string& text) { progress.line("  warning: " + text); });
  if (m.deck.check == deck::ModelCheck::tangent)
    augment = scene::with_tangent_check(m, std::move(augment),
                                        [&](const std::string& text) { progress.line(text); });
  solver::AugmentedLagrangian loop(newton, std::move(augment));
  solver::LoadStepping stepping(loop, m.deck.time, progress.sink());
  solver::Counters counters;
  const auto on_step = [&](const solver::StepReport& report, const Vector& at) {
    ++counters.steps;
    counters.newton_iterations += report.iterations;
    counters.augmentations += report.augmentations;
    counters.cut_backs += report.cuts;
    state = scene::make_state(m, at, report.t, counters);
    state.energy.kinetic_at_start = kinetic_at_start;
    augmentations = report.augmentations;
    Global active = 0;
    double ratio = 0.0;
    for (const auto& c : state.contacts) {
      active += c.active_points;
      ratio = std::max(ratio, c.max_penetration_over_face_size);
    }
    progress.step(report, active, ratio);
    if (report.step % m.deck.output.every != 0)
      return;
    write();
    written = report.t;
  };
  const solver::LoadResult result =
      stepping.run(system, x, on_step, [&](const auto& report) { progress.iteration(report); });
  state.counters = result.counters;
  if (!result.converged) { // what is written below is the state of the last converged step
    system.set_time(result.t);
    system.residual(x, f);
  }
  if (state.time > written)
    write();

  auto verdicts = verify(m, state);
  if (result.converged)
    print_verdicts(progress, verdicts);
  else // they speak of the end of the run
    for (Verdict& v : verdicts)
      v.ok = false;
  RunFacts facts;
  facts.converged = result.converged;
  facts.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_summary(m, state, facts, verdicts, options.summary);
  if (result.converged)
    progress.line(fmt::format("converged: {} steps, {} Newton iterations, {:.2f} s; results in {}",
                              result.counters.steps, result.counters.newton_iterations,
                              facts.wall_seconds, writer.path()));
  else if (comm.is_root())
    fmt::print(stderr,
               "abut: stopped at t = {:.6g} of {:.6g}: {}{}\nEverything up to there is in {}\n",
               result.t, m.deck.time.end, result.reason, changes_at(m, result.t), writer.path());
  return result.converged ? 0 : 1;
}

} // namespace

void add_run_command(CLI::App& app, int& status) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Solve the scene of a deck");
  command->add_option("DECK", options->deck, "YAML or XML deck")->required();
  command->add_option("--summary", options->summary, "Write what the run found and spent as JSON");
  command->add_option("--output-dir", options->output_dir, "Folder of the results");
  command->add_flag("--quiet", options->quiet, "Print errors only");
  command->callback([options, &status] { status = run(*options); });
}

} // namespace abut::app
