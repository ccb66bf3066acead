// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "audit_watch.hpp"
#include "convergence.hpp"
#include "history.hpp"
#include "points_file.hpp"
#include "progress.hpp"
#include "warnings.hpp"

#include "abut/io/result_writer.hpp"
#include "abut/scene/penalty_error.hpp"
#include "abut/scene/state.hpp"

#include <optional>
#include <string>

namespace abut::app {

/// Follows a run: keeps its last converged state, writes states to the files of the results and
/// tells the user of each step. Model, progress and audit must outlive it. Every member is
/// collective, and wants the equations evaluated at the x it speaks of.
class Recorder {
public:
  /// Starts the files, `stem` being their path without extension: with the state x at t = 0, or
  /// without any where a further part of the run begins, whose course so far is to be taken by
  /// exchange_state. Throws InputError when they cannot be written.
  Recorder(const Model& model, const std::string& stem, int part, Progress& progress,
           AuditWatch& audit, const Vector& x);

  /// What it knows of the course of the run; when it has been taken, its state is x.
  void exchange_state(StateArchive& archive, const Vector& x);

  void iteration(const solver::IterationReport& report);
  void step(const solver::StepReport& report, const Vector& x);
  /// Writes the last converged state, where it has not been.
  void finish(const solver::Counters& spent);

  const scene::State& state() const { return state_; }
  const solver::Counters& counters() const { return counters_; }  ///< of the converged steps
  const Convergence& convergence() const { return convergence_; } ///< of this part of the run
  const ContactWatch& watch() const { return watch_; }
  const scene::PenaltyError& penalty_error() const { return penalty_.error(); }
  const std::string& path() const { return writer_.path(); }

private:
  void write();

  const Model& model_;
  Progress& progress_;
  AuditWatch& audit_;
  scene::State state_;
  io::ResultWriter writer_;
  History history_;
  std::optional<PointsFile> points_;
  solver::Counters counters_;
  Convergence convergence_;
  ContactWatch watch_;
  scene::PenaltyWatch penalty_;
  long long augmentations_ = 0; ///< of the last one
  double written_ = 0.0;        ///< t of the last state that needs no writing
};

} // namespace abut::app
