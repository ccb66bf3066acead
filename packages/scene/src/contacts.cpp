// SPDX-License-Identifier: BSD-3-Clause
#include "contacts.hpp"

#include "abut/contact/side_choice.hpp"
#include "abut/mesh/surface.hpp"

#include <fmt/format.h>

namespace abut::scene {

namespace {

mesh::Surface make_surface(const mesh::Mesh& mesh, const std::string& side_set,
                           const solid::BlockMaterials& materials) {
  mesh::Surface s = mesh::extract_surface(mesh, side_set);
  const auto stiffness = solid::face_stiffness(mesh, mesh::sorted_sides(mesh, side_set), materials);
  s.modulus = stiffness.modulus;
  s.inverse_depth = stiffness.inverse_depth;
  return s;
}

/// For each node of a surface bits 1, 2, 4 where its displacement along x, y, z is prescribed all
/// the time.
std::vector<char> prescribed_directions(const mesh::Mesh& mesh,
                                        const std::vector<assembly::Constraint>& constraints,
                                        const mesh::Surface& surface) {
  std::vector<char> of_node(static_cast<std::size_t>(mesh.num_local()), 0), result;
  for (const assembly::Constraint& c : constraints)
    if (c.window.is_whole_run())
      of_node[std::size_t(c.node)] = static_cast<char>(of_node[std::size_t(c.node)] | 1 << c.field);
  for (Local i : surface.field_index)
    result.push_back(of_node[std::size_t(i)]);
  return result;
}

/// Swaps the sides when the options leave the choice. Returns a warning of a primary that is stiff
/// and fine, or nothing.
std::string choose_sides(const Comm& comm, const mesh::Surface& primary,
                         const mesh::Surface& secondary, contact::ContactOptions& options) {
  const contact::SideComparison sides = contact::compare_sides(comm, primary, secondary);
  if (options.primary_side == contact::PrimarySide::automatic) {
    if (sides.prefers_swap())
      std::swap(options.primary, options.secondary);
  } else if (sides.is_poor() && !options.two_pass) {
    return fmt::format(
        "contact.{}: the primary '{}' is {:.3g} times as stiff as the secondary and its faces are "
        "{:.3g} times their size: pressures will oscillate. Swap primary and secondary, or give "
        "'primary_side: automatic'",
        options.name, options.primary, sides.stiffness, sides.size);
  }
  return "";
}

} // namespace

std::vector<std::shared_ptr<contact::Interaction>>
make_contacts(const Options& options, const mesh::Mesh& mesh,
              const solid::BlockMaterials& materials,
              const std::vector<assembly::Constraint>& constraints, PhaseTimers& timers,
              const Where& where, std::vector<std::string>& warnings) {
  std::vector<std::shared_ptr<contact::Interaction>> result;
  const auto surface = [&](const std::string& name) { return make_surface(mesh, name, materials); };
  const auto add = [&](const contact::ContactOptions& pass, double share) {
    result.push_back(std::make_shared<contact::Interaction>(
        mesh.comm, surface(pass.primary), surface(pass.secondary), pass, timers, share));
    contact::Interaction& contact = *result.back();
    contact.set_schedules(given_curve(options.curves, pass.penalty_curve),
                          given_curve(options.curves, pass.friction_curve));
    contact.set_end(options.time.end);
    contact.set_prescribed(prescribed_directions(mesh, constraints, contact.primary()));
  };
  for (const contact::ContactOptions& given : options.contact) {
    contact::ContactOptions pass = given;
    try {
      const std::string warning =
          choose_sides(mesh.comm, surface(pass.primary), surface(pass.secondary), pass);
      if (!warning.empty())
        warnings.push_back(warning);
      add(pass, pass.two_pass ? 0.5 : 1.0);
      if (!pass.two_pass)
        continue;
      std::swap(pass.primary, pass.secondary);
      pass.name += "_second_pass";
      add(pass, 0.5);
    } catch (const InputError& e) {
      throw InputError(where("contact." + given.name) + ": " + e.what());
    }
  }
  return result;
}

} // namespace abut::scene
