// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/core/trilinos_fwd.hpp"

#include <array>
#include <vector>

namespace abut::solver {

/// What a run has spent, failed attempts included.
struct Counters {
  long long steps = 0; ///< converged ones only
  long long newton_iterations = 0;
  long long augmentations = 0;
  long long linear_iterations = 0; ///< predictors included
  long long cut_backs = 0;
  long long extrapolated_steps = 0; ///< converged ones whose start was no linear solve
};

template <class V> void list_state(V& v, Counters& c) {
  v(c.steps, c.newton_iterations, c.augmentations, c.linear_iterations, c.cut_backs,
    c.extrapolated_steps);
}

/// How a step has moved the unknowns.
struct StepMotion {
  RCP<const Vector> velocity; ///< mean over the step; null: none is known
  double dt = 0.0;            ///< length of the step
};

/// Where load stepping stands between two steps: what the next one is made of, beside x and what
/// the system itself remembers. As it is here: at the start.
struct Standing {
  double t = 0.0;
  double dt = 0.0;      ///< of the next step; 0: nominal
  double nominal = 0.0; ///< the length of steps that dt belongs to
  Counters counters;
  std::array<StepMotion, 2> motions; ///< of the last steps, the newest first
};

/// rows: keys of the owned block rows of three unknowns. Taking is collective.
void exchange_state(StateArchive& archive, const RCP<const Map>& map,
                    const std::vector<Global>& rows, Standing& standing);

} // namespace abut::solver
