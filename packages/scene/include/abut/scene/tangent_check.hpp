// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/scene.hpp"
#include "abut/solver/augmented.hpp"

#include <functional>
#include <string>

namespace abut::scene {

/// An augmentation that first compares, where Newton has converged, each part's tangent with
/// differences of its forces and prints the result (check: tangent).
solver::AugmentCallback with_tangent_check(Scene& scene, solver::AugmentCallback then,
                                           std::function<void(const std::string&)> print);

} // namespace abut::scene
