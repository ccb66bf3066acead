// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

constexpr double incompressible = 1000.0; // bulk over shear modulus where D1 is zero

std::string law(const DeckParts& parts, const Material& m) {
  FlowMap map;
  if (m.hyperelastic) {
    const Hyperelastic& h = *m.hyperelastic;
    map.add("model", h.is_ogden ? "ogden" : "mooney_rivlin");
    if (h.is_ogden) {
      std::vector<std::string> c, power;
      for (std::size_t i = 0; i < h.coefficients.size(); ++i) {
        c.push_back(number_text(h.coefficients[i]));
        power.push_back(number_text(h.exponents[i]));
      }
      map.add("coefficients", list_text(c));
      map.add("exponents", list_text(power));
    } else {
      map.add("c1", h.coefficients[0]);
      if (h.coefficients[1] != 0.0)
        map.add("c2", h.coefficients[1]);
    }
    map.add("bulk", h.compressibility > 0.0 ? 2.0 / h.compressibility
                                            : rounded(incompressible * h.shear(), 12));
  } else {
    map.add("model", parts.model.is_finite() ? "saint_venant_kirchhoff" : "linear_elastic");
    map.add("young", m.elastic->young);
    map.add("poisson", m.elastic->poisson);
  }
  if (m.density > 0.0)
    map.add("density", m.density);
  return map.text();
}

/// Velocity at the start of a body, all of whose nodes have the same.
std::array<double, 3> initial_velocity(const DeckParts& parts, const Body& body) {
  const Model& model = parts.model;
  std::array<double, 3> result{};
  if (!model.is_dynamic() || model.initial_velocities.empty())
    return result;
  std::set<Global> nodes;
  for (const int b : body.blocks) {
    const auto& block = parts.mesh.data().blocks[std::size_t(b)];
    nodes.insert(block.nodes.begin(), block.nodes.end());
  }
  for (const InitialVelocity& v : model.initial_velocities) {
    const std::vector<Global> given = parts.mesh.nodes_of(v.nodes);
    const auto inside =
        std::count_if(given.begin(), given.end(), [&](Global n) { return nodes.count(n) > 0; });
    if (inside == static_cast<std::ptrdiff_t>(nodes.size()))
      result[std::size_t(v.component - 1)] = v.value;
    else if (inside > 0)
      parts.say(v.place, "*INITIAL CONDITIONS", Fate::refused,
                "it holds for some nodes of section '" +
                    model.sections[std::size_t(body.section)].set +
                    "': abut takes one velocity for all of a body");
  }
  return result;
}

} // namespace

std::string materials_text(const DeckParts& parts, std::vector<std::string>& names) {
  const Model& model = parts.model;
  std::string out;
  DeckNames deck_names;
  std::map<std::string, std::string> known;
  names.assign(model.sections.size(), "");
  for (const Body& body : parts.mesh.bodies()) {
    if (body.section < 0)
      continue;
    const Section& section = model.sections[std::size_t(body.section)];
    const std::string key = key_of(section.material);
    const auto found = model.materials.find(key);
    if (found == model.materials.end()) {
      std::vector<std::string> valid;
      for (const auto& entry : model.materials)
        valid.push_back(entry.second.name);
      throw InputError(model.where(section.place) + ": *SOLID SECTION: there is no material '" +
                       section.material + "'; " +
                       nearest_word_hint(section.material, valid.data(), valid.size()));
    }
    const Material& m = found->second;
    std::string& name = known[key];
    names[std::size_t(body.section)] = name;
    if (!name.empty())
      continue;
    if (!m.elastic && !m.hyperelastic) {
      parts.say(m.place, "*MATERIAL '" + m.name + "'", Fate::refused,
                "expected *ELASTIC or *HYPERELASTIC below it");
      name = "none";
      continue;
    }
    if (model.is_dynamic() && m.density == 0.0)
      parts.say(m.place, "*MATERIAL '" + m.name + "'", Fate::refused,
                "expected *DENSITY below it, for *DYNAMIC");
    if (m.elastic && model.is_finite())
      parts.say(m.place, "*MATERIAL '" + m.name + "'", Fate::used,
                "with NLGEOM saint_venant_kirchhoff, as in CalculiX; Abaqus takes logarithmic "
                "strains: the same while strains are small");
    if (m.hyperelastic && !model.is_finite())
      parts.say(m.place, "*MATERIAL '" + m.name + "'", Fate::used,
                "without NLGEOM too abut takes finite strains, as CalculiX does");
    name = deck_names.make(m.name, "material");
    names[std::size_t(body.section)] = name;
    out += "  " + name + ": " + law(parts, m) + "\n";
  }
  return out.empty() ? "" : "materials:\n" + out;
}

std::string bodies_text(const DeckParts& parts, const std::vector<std::string>& materials,
                        RigidBodies& rigid) {
  std::string out;
  DeckNames names;
  for (const Body& body : parts.mesh.bodies()) {
    if (body.section < 0)
      continue;
    FlowMap map;
    std::vector<std::string> blocks;
    for (const int b : body.blocks)
      blocks.push_back(quoted(parts.mesh.data().blocks[std::size_t(b)].name));
    map.add("blocks", list_text(blocks));
    map.add("material", materials[std::size_t(body.section)]);
    if (body.element)
      map.add("element", body.element);
    const std::array<double, 3> v = initial_velocity(parts, body);
    if (v != std::array<double, 3>{})
      map.add("initial_velocity", vector_text(v));
    out += "  " + names.make(parts.model.sections[std::size_t(body.section)].set, "body") + ": " +
           map.text() + "\n";
  }
  return "bodies:\n" + out + rigid.text(names);
}

} // namespace abut::abaqus
