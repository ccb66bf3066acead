// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/scene.hpp"

#include "abut/rigid/assign_nodes.hpp"
#include "abut/rigid/make.hpp"
#include "abut/scene/globals.hpp"
#include "abut/scene/masses.hpp"
#include "abut/scene/names.hpp"
#include "abut/scene/windows.hpp"
#include "abut/solid/load_contribution.hpp"
#include "abut/solid/reference_checks.hpp"
#include "contacts.hpp"
#include "displacements.hpp"
#include "inertia.hpp"
#include "stiff_elements.hpp"

#include <fmt/format.h>

namespace abut::scene {

namespace {

/// (blocks) index in the options of the body that each block belongs to.
std::vector<int> assign_blocks(const Options& options, const mesh::Mesh& mesh, const Where& where) {
  std::vector<int> body_of_block(mesh.blocks.size(), -1);
  for (std::size_t i = 0; i < options.bodies.size(); ++i) {
    const BodyOptions& body = options.bodies[i];
    for (const std::string& name : body.blocks)
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        if (mesh.blocks[b].name != name)
          continue;
        if (body_of_block[b] >= 0)
          throw InputError(where("bodies." + body.name + ".blocks") + ": block '" + name +
                           "' already belongs to body '" +
                           options.bodies[std::size_t(body_of_block[b])].name + "'");
        body_of_block[b] = static_cast<int>(i);
      }
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (body_of_block[b] < 0)
      throw InputError(where("bodies") + ": block '" + mesh.blocks[b].name +
                       "' of the mesh belongs to no body");
  return body_of_block;
}

/// (blocks) none for rigid ones.
std::vector<std::optional<solid::Material>> make_materials(const Options& options,
                                                           const std::vector<int>& body_of_block) {
  std::vector<std::optional<solid::Material>> result;
  for (const int index : body_of_block) {
    std::optional<solid::Material>& material = result.emplace_back();
    const BodyOptions& body = options.bodies[std::size_t(index)];
    for (const auto& m : options.materials)
      if (!body.rigid && m.name == body.material)
        material = solid::make_material(m);
  }
  return result;
}

/// (blocks) none for rigid ones.
std::vector<std::optional<solid::ElementFormulation>>
make_formulations(const Options& options, const Scene& s, const Where& where) {
  std::vector<std::optional<solid::ElementFormulation>> result;
  for (std::size_t b = 0; b < s.mesh->blocks.size(); ++b) {
    std::optional<solid::ElementFormulation>& formulation = result.emplace_back();
    const BodyOptions& body = options.bodies[std::size_t(s.body_of_block[b])];
    if (!s.material[b])
      continue;
    try {
      formulation =
          solid::element_formulation(body.element, s.mesh->blocks[b].type, *s.material[b]);
    } catch (const InputError& e) {
      throw InputError(where("bodies." + body.name + ".element") + ": " + e.what());
    }
  }
  return result;
}

std::vector<rigid::BodyNodes> rigid_nodes(const Options& options,
                                          const std::vector<int>& body_of_block) {
  std::vector<rigid::BodyNodes> result;
  for (std::size_t i = 0; i < options.bodies.size(); ++i)
    if (options.bodies[i].rigid)
      result.push_back(
          {options.bodies[i].name, blocks_of(body_of_block, i), options.bodies[i].node_sets});
  return result;
}

std::unique_ptr<assembly::EquationSystem>
empty_equations(const mesh::Mesh& mesh, const std::vector<int>& rigid_body_of_node,
                const std::vector<rigid::Body>& bodies, const std::vector<rigid::Joint>& joints,
                PhaseTimers& timers) {
  unknowns::RigidNodes rigid{rigid_body_of_node, {}, rigid::links_of(joints)};
  for (const auto& body : bodies)
    rigid.has_unknowns.push_back(body.has_unknowns());
  return std::make_unique<assembly::EquationSystem>(
      unknowns::DofMap(mesh, {"displacement_x", "displacement_y", "displacement_z"}, rigid), timers,
      bodies, joints);
}

/// Fills the equations with what is on the mesh.
void add_contributions(const Options& options, Scene& s) {
  for (std::size_t b = 0; b < s.mesh->blocks.size(); ++b) {
    if (!s.material[b])
      continue;
    s.solids.push_back(std::make_shared<solid::SolidContribution>(
        *s.mesh, static_cast<int>(b), *s.material[b], *s.formulation[b]));
    s.equations->add(s.solids.back());
  }
  for (const auto& load : options.loads)
    s.equations->add(std::make_shared<solid::LoadContribution>(
        *s.mesh, load, given_curve(options.curves, load.curve)));
  for (const auto& contact : s.contacts)
    s.equations->add(contact);
  if (options.dynamics.active) {
    s.inertia =
        make_inertia(options, *s.mesh, s.body_of_block, s.rigid_body_of_node, s.constraints);
    s.equations->add(s.inertia);
  }
  s.equations->set_constraints(s.constraints);
}

/// Impact with multipliers brings energy in, which rules near the trapezoidal one keep.
std::vector<std::string> warnings_of_impact(const Options& options) {
  std::vector<std::string> result;
  const solver::DynamicsOptions& dynamics = options.dynamics;
  const bool damped = dynamics.spectral_radius == 0.0 || dynamics.gamma.value_or(0.5) > 0.5;
  for (const auto& c : options.contact)
    if (dynamics.active && !damped && c.enforcement == contact::Enforcement::augmented_lagrangian)
      result.push_back(fmt::format(
          "contact.{}: multipliers bring energy in where surfaces hit each other; watch "
          "energy_imbalance, and take 'spectral_radius: 0' or 'enforcement: penalty' with "
          "'penalty_factor: 1' where they do",
          c.name));
  return result;
}

std::vector<std::string> warnings_of_joints(const rigid::Joints& joints) {
  std::vector<std::string> result;
  for (const auto& [joint, component] : joints.implied())
    result.push_back("joints." + joint + ": its " + component +
                     " is held by other joints or supports already. It carries no force of "
                     "its own, and the run stops where it would have to move");
  return result;
}

} // namespace

Scene build_scene(const Options& options, std::shared_ptr<const mesh::Mesh> shared_mesh,
                  PhaseTimers& timers, const Where& where) {
  Scene s;
  s.mesh = std::move(shared_mesh);
  const mesh::Mesh& mesh = *s.mesh;
  mesh.comm.together([&] {
    check_names(options, mesh, where);
    check_not_empty(options, mesh, where); // sums are the same on all ranks
    s.body_of_block = assign_blocks(options, mesh, where);
    s.material = make_materials(options, s.body_of_block);
    s.formulation = make_formulations(options, s, where);
    check_conflicts(options, mesh, where);
  });
  try {
    solid::check_elements(mesh);
  } catch (const InputError& e) {
    throw InputError(where("mesh") + ": " + e.what());
  }
  s.rigid_bodies = make_rigid_bodies(options, mesh, s.body_of_block);
  s.joints = rigid::make_joints(options.joints, s.rigid_bodies, options.curves);
  s.rigid_body_of_node = rigid::assign_nodes(mesh, rigid_nodes(options, s.body_of_block), where);
  mesh.comm.together([&] { check_rigid_nodes(options, mesh, s.rigid_body_of_node, where); });
  for (const DisplacementOptions& d : options.displacements)
    s.supports.push_back(d.name);
  s.constraints = make_constraints(options, mesh);
  solid::BlockMaterials materials;
  for (const auto& material : s.material)
    materials.push_back(material ? &*material : nullptr);
  s.contacts = make_contacts(options, mesh, materials, s.constraints, timers, where, s.warnings);
  s.equations = empty_equations(mesh, s.rigid_body_of_node, s.rigid_bodies, s.joints, timers);
  add_contributions(options, s);
  require_own_names(s, where);
  for (auto& list :
       {windows_between_steps(options), warnings_of_joints(s.equations->joints()),
        warnings_of_impact(options),
        warnings_of_elements(options, mesh, s.body_of_block, s.material, s.formulation)})
    s.warnings.insert(s.warnings.end(), list.begin(), list.end());
  return s;
}

} // namespace abut::scene
