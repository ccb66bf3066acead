// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/scene.hpp"

namespace abut::solver {
class LinearSolver;
}

namespace abut::scene {

/// Sets the bodies of a scene with dynamics in motion at t = 0: velocities of the options,
/// accelerations from the equation of motion. x is the unknowns there. Collective.
void start_motion(const Options& options, Scene& scene, solver::LinearSolver& linear,
                  const Vector& x);

} // namespace abut::scene
