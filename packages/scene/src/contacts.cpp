// SPDX-License-Identifier: BSD-3-Clause
#include "contacts.hpp"

#include "abut/contact/option_error.hpp"
#include "abut/contact/passes.hpp"
#include "abut/mesh/surface.hpp"

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

} // namespace

std::vector<std::shared_ptr<contact::Interaction>>
make_contacts(const Options& options, const mesh::Mesh& mesh,
              const solid::BlockMaterials& materials,
              const std::vector<assembly::Constraint>& constraints, PhaseTimers& timers,
              const Where& where, std::vector<std::string>& warnings) {
  const auto surface = [&](const std::string& name) { return make_surface(mesh, name, materials); };
  contact::HostFacts host;
  host.curve = [&](const std::string& name) { return curve_named(options.curves, name); };
  host.end = options.time.end;
  host.prescribed = [&](const mesh::Surface& s) {
    return prescribed_directions(mesh, constraints, s);
  };
  std::vector<std::shared_ptr<contact::Interaction>> result;
  for (const contact::ContactOptions& given : options.contact) {
    try {
      const contact::Passes passes = contact::make_passes(
          mesh.comm, surface(given.primary), surface(given.secondary), given, timers, host);
      result.insert(result.end(), passes.interfaces.begin(), passes.interfaces.end());
      warnings.insert(warnings.end(), passes.warnings.begin(), passes.warnings.end());
    } catch (const contact::OptionError& e) {
      throw InputError(where(e.path()) + ": " + e.reason());
    } catch (const InputError& e) {
      throw InputError(where("contact." + given.name) + ": " + e.what());
    }
  }
  return result;
}

} // namespace abut::scene
