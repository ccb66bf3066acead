// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoints.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"
#include "abut/io/checkpoint_file.hpp"

namespace abut::app {

Checkpoints::Checkpoints(const Model& model, std::string path, int part, ExchangeState exchange,
                         Progress& progress)
    : model_(model), path_(std::move(path)), part_(part), exchange_(std::move(exchange)),
      progress_(progress) {}

bool Checkpoints::step(solver::Standing standing) {
  if (!model_.deck.output.checkpoint.active)
    return false;
  last_.emplace(model_.comm);
  exchange_(*last_, standing);
  t_ = standing.t;
  step_ = standing.counters.steps;
  return due() && write();
}

void Checkpoints::finish() {
  if (last_)
    write();
}

/// The root's clock counts.
bool Checkpoints::due() {
  const io::CheckpointOptions& wanted = model_.deck.output.checkpoint;
  const std::chrono::duration<double, std::ratio<60>> since =
      std::chrono::steady_clock::now() - written_;
  const bool late = wanted.minutes && model_.comm.is_root() && since.count() >= *wanted.minutes;
  const bool counted = wanted.every && step_ % *wanted.every == 0;
  return t_ < model_.deck.time.end && (counted || model_.comm.any(late));
}

bool Checkpoints::write() {
  const PhaseTimers::Scope scope(*model_.timers, Phase::output);
  written_ = std::chrono::steady_clock::now();
  try {
    const io::Checkpoint file{ABUT_VERSION,
                              model_.deck.file,
                              deck::model_yaml(model_.deck),
                              model_.mesh_fingerprint,
                              t_,
                              step_,
                              part_,
                              last_->gathered()};
    last_.reset();
    model_.comm.on_root([&] { io::write_checkpoint(path_, file); });
  } catch (const MachineError& e) {
    progress_.warning(std::string("no checkpoint: ") + e.what() + "; the one before stays");
    return false;
  }
  return true;
}

} // namespace abut::app
