// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/equation_system.hpp"
#include "abut/contact/interaction.hpp"
#include "abut/core/log.hpp"
#include "abut/deck/deck.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/inertia_contribution.hpp"
#include "abut/solid/material.hpp"
#include "abut/solid/solid_contribution.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace abut::app {

/// A scene ready to solve: the deck made into mesh, physics and equations.
struct Model {
  Model(const Comm& c, deck::Deck d) : comm(c), deck(std::move(d)) {}
  Model(const Model&) = delete;

  Comm comm;
  deck::Deck deck;
  PhaseTimers timers;
  std::unique_ptr<mesh::Mesh> mesh;
  std::vector<int> body_of_block;                       ///< index in deck.bodies
  std::vector<std::optional<solid::Material>> material; ///< per block; none: rigid
  std::vector<assembly::RigidBody> rigid_bodies;        ///< in the order of the deck
  std::vector<assembly::RigidJoint> joints;             ///< in the order of the deck
  std::vector<int> rigid_body_of_node; ///< (N) index of the rigid body it moves with, or -1
  std::vector<assembly::Constraint> constraints;
  std::vector<std::shared_ptr<solid::SolidContribution>> solids;
  std::vector<std::shared_ptr<contact::Interaction>> contacts;
  std::shared_ptr<solid::InertiaContribution> inertia; ///< null without dynamics
  std::unique_ptr<assembly::EquationSystem> equations;
  std::vector<std::string> warnings; ///< what a user should hear before the run
};

/// Reads the deck and its mesh and builds everything. Throws InputError, naming file, line and key,
/// for what does not fit together. Collective.
std::unique_ptr<Model> build_model(const Comm& comm, const std::string& deck_file);

/// A set of nodes by the name of a node set or a side set. Ghost nodes included.
std::vector<Local> nodes_of_set(const mesh::Mesh& mesh, const std::string& name);

} // namespace abut::app
