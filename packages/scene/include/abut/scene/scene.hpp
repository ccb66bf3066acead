// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/equation_system.hpp"
#include "abut/contact/interaction.hpp"
#include "abut/core/error.hpp"
#include "abut/core/timers.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/rigid/body.hpp"
#include "abut/rigid/joint.hpp"
#include "abut/scene/options.hpp"
#include "abut/solid/element_formulation.hpp"
#include "abut/solid/inertia_contribution.hpp"
#include "abut/solid/material.hpp"
#include "abut/solid/solid_contribution.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abut::scene {

/// A mesh with all that options say of it, ready to solve.
struct Scene {
  std::shared_ptr<const mesh::Mesh> mesh;
  std::vector<int> body_of_block;                                    ///< index in Options::bodies
  std::vector<std::optional<solid::Material>> material;              ///< per block; none: rigid
  std::vector<std::optional<solid::ElementFormulation>> formulation; ///< per block; none: rigid
  std::vector<rigid::Body> rigid_bodies; ///< in the order of the options
  std::vector<rigid::Joint> joints;      ///< in the order of the options
  std::vector<int> rigid_body_of_node;   ///< (N) index of the rigid body it moves with, or -1
  std::vector<std::string> supports;     ///< entries of Options::displacements
  std::vector<assembly::Constraint> constraints; ///< their groups are supports
  std::vector<std::shared_ptr<solid::SolidContribution>> solids;
  std::vector<std::shared_ptr<contact::Interaction>> contacts;
  std::shared_ptr<solid::InertiaContribution> inertia; ///< null without dynamics
  std::unique_ptr<assembly::EquationSystem> equations;
  std::vector<std::string> warnings; ///< what a user should hear before the run
};

/// Builds everything. The timers must outlive the scene. Throws InputError, with where(key), for
/// what does not fit together. Collective.
Scene build_scene(const Options& options, std::shared_ptr<const mesh::Mesh> mesh,
                  PhaseTimers& timers, const Where& where);

/// The state x of a scene between two steps, with all that its parts remember, goes to the archive
/// or comes from there. For taking, the equations must have been evaluated where the run starts,
/// and with dynamics motion has started; they are evaluated at x afterwards. Collective.
void exchange_state(StateArchive& archive, Scene& scene, Vector& x);

} // namespace abut::scene
