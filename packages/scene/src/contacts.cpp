// SPDX-License-Identifier: BSD-3-Clause
#include "contacts.hpp"

#include "abut/contact/option_error.hpp"
#include "abut/contact/passes.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/search/thickness.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

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

/// E_n A / V of the softest faces behind either surface [pressure/length]; infinite: both are
/// rigid. Collective.
double softest_face(const Comm& comm, const mesh::Surface& primary,
                    const mesh::Surface& secondary) {
  double softest = std::numeric_limits<double>::infinity();
  for (const mesh::Surface* s : {&primary, &secondary})
    for (std::size_t f = 0; f < s->modulus.size(); ++f)
      if (s->modulus[f] > 0.0)
        softest = std::min(softest, s->modulus[f] * s->inverse_depth[f]);
  return comm.min(softest);
}

/// A penalty far beyond the stiffness of the bodies leaves nothing of them in sums of 16 digits:
/// refused where that is so, named where it costs digits. Factors of curves do not count.
void check_penalty(const contact::ContactOptions& given, const std::function<double()>& softest,
                   const Where& where, std::vector<std::string>& warnings) {
  constexpr double costly = 1e7, hopeless = 1e11;
  const double factor =
      given.penalty ? *given.penalty / softest() : given.penalty_factor.value_or(1.0);
  if (!(factor > costly))
    return;
  const std::string path =
      "contact." + given.name + (given.penalty ? ".penalty" : ".penalty_factor");
  const std::string text =
      fmt::format("{:g} is {:.2g} times the stiffness E A/V of the elements behind the surfaces",
                  given.penalty.value_or(factor), factor);
  if (factor > hopeless)
    throw InputError(where(path) + ": " + text +
                     ", of which rounding leaves nothing; 10 to 1000 times is usual");
  warnings.push_back(path + ": " + text + "; rounding may cost digits of the results");
}

} // namespace

std::vector<std::shared_ptr<contact::Interaction>>
make_contacts(const Options& options, const mesh::Mesh& mesh,
              const solid::BlockMaterials& materials,
              const std::vector<assembly::Constraint>& constraints, PhaseTimers& timers,
              const Where& where, std::vector<std::string>& warnings) {
  std::optional<search::BodyThickness> thickness; // without contact nobody asks
  if (!options.contact.empty())
    thickness.emplace(mesh);
  const auto side = [&](const std::string& contact, const std::string& name) {
    try {
      mesh::Surface s = make_surface(mesh, name, materials);
      s.thickness = thickness->behind(s);
      return s;
    } catch (const InputError& e) {
      throw InputError(where("contact." + contact) + ": " + e.what());
    }
  };
  contact::HostFacts host;
  host.curve = [&](const std::string& name) { return curve_named(options.curves, name); };
  host.end = options.time.end;
  host.prescribed = [&](const mesh::Surface& s) {
    return prescribed_directions(mesh, constraints, s);
  };
  std::vector<std::shared_ptr<contact::Interaction>> result;
  for (const contact::ContactOptions& given : options.contact) {
    mesh::Surface primary = side(given.name, given.primary);
    mesh::Surface secondary = side(given.name, given.secondary);
    const auto softest = [&] { return softest_face(mesh.comm, primary, secondary); };
    check_penalty(given, softest, where, warnings);
    try {
      const contact::Passes passes = contact::make_passes(
          mesh.comm, std::move(primary), std::move(secondary), given, timers, host);
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
