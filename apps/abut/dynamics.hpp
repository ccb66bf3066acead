// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/solid/mass.hpp"

namespace abut::solver {
class LinearSolver;
}

namespace abut::app {

/// The inertia of the deformable bodies, as equations take it. For decks with `dynamics`; after the
/// constraints and rigid bodies are known. Collective.
std::shared_ptr<solid::InertiaContribution> make_inertia(const Model& model);

/// Of the elements of a body of a deck with `dynamics`; of a rigid one without density zero.
/// Collective.
solid::MassProperties body_mass(const Model& model, std::size_t body);

/// Mass of a rigid body of the deck and how it moves at the start; nothing without `dynamics`.
/// Throws InputError where its blocks have no volume. Collective.
void set_inertia(const Model& model, const solid::BodyOptions& options, assembly::RigidBody& body);

/// Sets the bodies in motion at t = 0: velocities of the deck, accelerations from the equation of
/// motion. x is the unknowns there. Collective.
void start_dynamics(Model& model, solver::LinearSolver& linear, const Vector& x);

} // namespace abut::app
