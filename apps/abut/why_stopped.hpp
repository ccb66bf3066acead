// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "recorder.hpp"

#include "abut/solver/load_stepping.hpp"

#include <string>

namespace abut::app {

/// What a user should know about a run that stopped, beside the reason of the solver, each on a
/// line of its own: which setting allows no smaller step, what begins or ends there, what nothing
/// or contact alone held. The equations must have been evaluated at the last converged state.
/// Collective.
std::string why_stopped(const Model& model, const Recorder& recorder,
                        const solver::LoadResult& result);

} // namespace abut::app
