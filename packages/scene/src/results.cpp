// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/results.hpp"

#include "abut/scene/contact_fields.hpp"
#include "abut/scene/globals.hpp"
#include "further_fields.hpp"

namespace abut::scene {

namespace {

constexpr const char* axes[] = {"_x", "_y", "_z"};

/// Adds the components of a field (owned nodes or more, 3) as nodal fields.
void add_vector(const Scene& m, const std::vector<double>& field, io::ResultStep& step) {
  const auto owned = static_cast<std::size_t>(m.mesh->num_owned);
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double>& values = step.nodal.emplace_back(owned);
    for (std::size_t n = 0; n < owned; ++n)
      values[n] = field[3 * n + i];
  }
}

void add_element_fields(const Scene& m, const State& s, io::ResultStep& step) {
  step.element.assign(8, {});
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
    const auto count = static_cast<std::size_t>(m.mesh->blocks[b].size());
    if (!m.material[b]) {
      for (auto& values : step.element)
        values.insert(values.end(), count, 0.0);
      continue;
    }
    const solid::ElementFields& e = s.elements[b];
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 6; ++k)
        step.element[k].push_back(e.stress[6 * i + k]);
      step.element[6].push_back(e.von_mises[i]);
      step.element[7].push_back(e.energy[i]);
    }
  }
}

} // namespace

io::ResultNames result_names(const Scene& m, const io::FieldOptions& further) {
  io::ResultNames names;
  const auto add_vectors = [&](std::initializer_list<const char*> fields) {
    for (const char* field : fields)
      for (const char* i : axes)
        names.nodal.push_back(std::string(field) + i);
  };
  add_vectors({"displacement"});
  names.nodal.insert(names.nodal.end(), {"contact_pressure", "contact_gap"});
  add_vectors({"contact_traction"});
  names.nodal.push_back("contact_status");
  names.element = {"stress_xx", "stress_yy", "stress_zz", "stress_xy",
                   "stress_yz", "stress_xz", "von_mises", "energy"};
  if (m.inertia)
    add_vectors({"velocity", "acceleration"});
  add_vectors({"reaction"});
  add_further_names(further, names);
  for (const GlobalVariable& global : global_variables(m))
    names.global.push_back(global.name);
  return names;
}

io::ResultStep result_step(const Scene& m, const State& s, const io::FieldOptions& further) {
  io::ResultStep step;
  step.time = s.time;
  ContactFields contact = contact_fields(*m.mesh, m.contacts);
  add_vector(m, s.u, step);
  step.nodal.push_back(std::move(contact.pressure));
  step.nodal.push_back(std::move(contact.gap));
  add_vector(m, contact.traction, step);
  step.nodal.push_back(std::move(contact.status));
  add_element_fields(m, s, step);
  if (m.inertia)
    for (const auto* field : {&s.velocity, &s.acceleration})
      add_vector(m, *field, step);
  add_vector(m, nodal_reactions(m, s.reaction, s.time), step);
  add_further_values(m, s, further, step);
  for (const GlobalVariable& global : global_variables(m, s))
    step.global.push_back(global.value);
  return step;
}

} // namespace abut::scene
