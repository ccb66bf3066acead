// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "convergence.hpp"
#include "verify.hpp"

#include "abut/audit/findings.hpp"
#include "abut/scene/penalty_error.hpp"
#include "abut/solver/linear_solver.hpp"

#include <string>
#include <vector>

namespace abut::app {

struct RunFacts {
  bool converged = false;
  std::string reason; ///< of a run that stopped
  std::vector<std::string> warnings;
  scene::PenaltyError penalty;
  audit::Measures audit; ///< the worst of all steps
  double audit_seconds = 0.0;
  double wall_seconds = 0.0;
  double waiting_seconds = 0.0;          ///< of this rank, for others and for messages
  std::vector<solver::LinearUse> linear; ///< those of the methods that were used
  std::string results; ///< path of the Exodus file, of this rank where each has one
  const Convergence* convergence = nullptr; ///< must outlive this
};

/// Writes the summary object of the outside contract; nothing when `file` is empty. Times are the
/// largest over the ranks, memory is the sum. Collective. Throws MachineError when it cannot write.
void write_summary(const Model& model, const scene::State& state, const RunFacts& facts,
                   const std::vector<Verdict>& verdicts, const std::string& file);

} // namespace abut::app
