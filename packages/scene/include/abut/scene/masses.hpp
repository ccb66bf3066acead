// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/mesh/mesh.hpp"
#include "abut/rigid/body.hpp"
#include "abut/scene/options.hpp"
#include "abut/solid/mass.hpp"

#include <functional>
#include <vector>

namespace abut::scene {

/// Indices of the blocks of a body. body_of_block: index in Options::bodies.
std::vector<int> blocks_of(const std::vector<int>& body_of_block, std::size_t body);

/// Of a deformable body, for dynamics [mass/length^3].
double density_of(const Options& options, const BodyOptions& body);

/// Of the elements of a body of options with dynamics; of a rigid one without density zero.
/// Collective.
solid::MassProperties body_mass(const Options& options, const mesh::Mesh& mesh,
                                const std::vector<int>& body_of_block, std::size_t body);

/// Velocity with which a prescribed value starts. Where it jumps at once, that of a first step.
double initial_slope(const solver::TimeOptions& time, const std::function<double(double)>& value);

/// The rigid bodies of the options in their order, with mass and motion at the start where there is
/// dynamics. Throws InputError where blocks with density have no volume. Collective.
std::vector<rigid::Body> make_rigid_bodies(const Options& options, const mesh::Mesh& mesh,
                                           const std::vector<int>& body_of_block);

} // namespace abut::scene
