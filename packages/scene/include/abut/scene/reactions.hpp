// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/scene/scene.hpp"

#include <vector>

namespace abut::scene {

/// What one entry of the displacements exerts on the bodies.
struct Reaction {
  Vec3 force = Vec3::zero();  ///< [force]
  Vec3 moment = Vec3::zero(); ///< of that about the origin [force length]
};

/// (owned nodes, 3) force of the supports on the nodes, zero in components that none of them holds
/// at t. raw: (owned rows, 3) raw residual of the equations. Not collective.
std::vector<double> nodal_reactions(const Scene& scene, const std::vector<double>& raw, double t);

/// (Scene::supports) their sums; what several hold at once counts for the first of them, so that
/// all together are the sum over the nodes. u: (N, 3) displacements. Collective.
std::vector<Reaction> reactions(const Scene& scene, const std::vector<double>& raw,
                                const std::vector<double>& u, double t);

} // namespace abut::scene
