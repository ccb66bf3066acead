// SPDX-License-Identifier: BSD-3-Clause
#include "recorder.hpp"

#include "abut/scene/results.hpp"

#include <algorithm>

namespace abut::app {

Recorder::Recorder(const Model& model, const std::string& stem, int part, Progress& progress,
                   AuditWatch& audit, const Vector& x)
    : model_(model), progress_(progress), audit_(audit),
      writer_(stem, *model.mesh, scene::result_names(model, model.deck.output.fields),
              model.deck.output.files, part),
      history_(model, stem) {
  if (model.deck.output.points)
    points_.emplace(model, stem + io::part_suffix(part));
  if (part > 1)
    return;
  state_ = scene::make_state(model, x, 0.0, {});
  state_.energy.kinetic_at_start = state_.energy.kinetic;
  watch_.look(state_);
  penalty_.look(state_);
  history_.add(state_);
  write();
}

void Recorder::exchange_state(StateArchive& archive, const Vector& x) {
  double kinetic_at_start = state_.energy.kinetic_at_start;
  archive.numbers("results", [&](auto& v) {
    v(counters_, augmentations_, kinetic_at_start, written_);
    watch_.list_state(v);
    penalty_.list_state(v);
  });
  history_.exchange_state(archive);
  if (archive.takes())
    state_ = scene::make_state(model_, x, model_.equations->time(), counters_);
  audit_.exchange_state(archive, state_.u);
  if (!archive.takes())
    return;
  state_.audit = audit_.now();
  state_.energy.kinetic_at_start = kinetic_at_start;
}

void Recorder::iteration(const solver::IterationReport& report) {
  convergence_.iteration(report);
  progress_.iteration(report);
}

void Recorder::step(const solver::StepReport& report, const Vector& x) {
  convergence_.step(report);
  ++counters_.steps;
  counters_.newton_iterations += report.iterations;
  counters_.augmentations += report.augmentations;
  counters_.cut_backs += report.cuts;
  augmentations_ = report.augmentations;
  const double kinetic_at_start = state_.energy.kinetic_at_start;
  state_ = scene::make_state(model_, x, report.t, counters_);
  state_.energy.kinetic_at_start = kinetic_at_start;
  audit_.accepted(state_.u, report.t, progress_);
  state_.audit = audit_.now();
  watch_.look(state_);
  penalty_.look(state_);
  Global active = 0;
  double ratio = 0.0;
  for (const auto& c : state_.contacts) {
    active += c.active_points;
    ratio = std::max(ratio, c.max_penetration_over_face_size);
  }
  history_.add(state_); // what is reported is on the disk
  progress_.step(report, active, ratio);
  if (report.step % model_.deck.output.every == 0)
    write();
}

void Recorder::finish(const solver::Counters& spent) {
  state_.counters = spent;
  if (state_.time > written_)
    write();
}

void Recorder::write() {
  const PhaseTimers::Scope scope(*model_.timers, Phase::output);
  writer_.write_step(scene::result_step(model_, state_, model_.deck.output.fields));
  if (points_)
    points_->write(state_.time, augmentations_);
  written_ = state_.time;
}

} // namespace abut::app
