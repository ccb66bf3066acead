// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "progress.hpp"
#include "restart.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace abut::app {

/// Writes down where a run stands, when the deck asks for it and at its end, however that comes.
/// Every rank keeps its part of the last state, for a step that fails or a signal may follow it. A
/// file that cannot be written is a warning; the one before stays. Every member is collective.
class Checkpoints {
public:
  /// part: of the results. The model and progress must outlive it.
  Checkpoints(const Model& model, std::string path, int part, ExchangeState exchange,
              Progress& progress);

  /// A step has been accepted. True: it has been written; the end of the load is left to finish().
  bool step(solver::Standing standing);
  /// Writes the last state, where it has not been.
  void finish();

private:
  bool due();
  bool write();

  const Model& model_;
  std::string path_;
  int part_;
  ExchangeState exchange_;
  Progress& progress_;
  std::optional<StateArchive> last_; ///< not written yet
  double t_ = 0.0;
  long long step_ = 0;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

} // namespace abut::app
