// SPDX-License-Identifier: BSD-3-Clause
#include "further_fields.hpp"

#include <algorithm>

namespace abut::scene {

namespace {

/// The order of stresses; the last one is called zx: readers make one symmetric tensor of six
/// fields whose names end so (VTK's of Exodus files through IOSS).
constexpr const char* components[] = {"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
constexpr std::size_t six = 6;

void add_tensor(const char* name, std::vector<std::string>& names) {
  for (const char* component : components)
    names.push_back(std::string(name) + component);
}

/// (blocks) what is recovered from the points of deformable ones.
std::vector<solid::RecoveredFields> recover(const Scene& m, const State& s) {
  std::vector<solid::RecoveredFields> of_block(m.mesh->blocks.size());
  const NodalFields fields{s.u.data(), 3, s.time};
  for (const auto& solid : m.solids)
    of_block[std::size_t(solid->block())] = solid->recovered_fields(fields);
  return of_block;
}

/// Adds `width` element fields; put(block, element, values) gives those of an element.
template <class Put>
void add_element_values(const Scene& m, std::size_t width, io::ResultStep& step, const Put& put) {
  const std::size_t first = step.element.size();
  step.element.resize(first + width);
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b)
    for (std::size_t e = 0; e < static_cast<std::size_t>(m.mesh->blocks[b].size()); ++e) {
      double values[six] = {};
      if (m.material[b])
        put(b, e, values);
      for (std::size_t k = 0; k < width; ++k)
        step.element[first + k].push_back(values[k]);
    }
}

/// Sums at the nodes of a body, each element counting by its volume: (N, 7), the volume last.
/// Complete at owned nodes. Collective.
std::vector<double> sums_of_body(const Scene& m, int body, const NodeExchange& exchange,
                                 const std::vector<solid::RecoveredFields>& recovered) {
  constexpr std::size_t width = six + 1;
  std::vector<double> sums(width * m.mesh->node.size(), 0.0);
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
    if (m.body_of_block[b] != body || !m.material[b])
      continue;
    const mesh::Block& block = m.mesh->blocks[b];
    const auto nodes = static_cast<std::size_t>(fem::info(block.type).nodes);
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {
      const double volume = recovered[b].volume[i / nodes];
      double* sum = &sums[width * std::size_t(block.nodes[i])];
      for (std::size_t k = 0; k < six; ++k)
        sum[k] += volume * recovered[b].stress[six * i + k];
      sum[six] += volume;
    }
  }
  exchange.add_to_owners(sums.data(), static_cast<int>(width));
  return sums;
}

/// Bodies do not mix: a node of several has the stress of the first in the options.
void add_nodal_stress(const Scene& m, const std::vector<solid::RecoveredFields>& recovered,
                      io::ResultStep& step) {
  const auto owned = static_cast<std::size_t>(m.mesh->num_owned);
  const std::size_t first = step.nodal.size();
  step.nodal.resize(first + six + 1, std::vector<double>(owned, 0.0));
  const NodeExchange exchange = mesh::node_exchange(*m.mesh);
  std::vector<char> known(owned, 0);
  int bodies = 0;
  for (const int body : m.body_of_block)
    bodies = std::max(bodies, body + 1);
  for (int body = 0; body < bodies; ++body) {
    const std::vector<double> sums = sums_of_body(m, body, exchange, recovered);
    for (std::size_t n = 0; n < owned; ++n) {
      const double* sum = &sums[(six + 1) * n];
      if (known[n] || !(sum[six] > 0.0))
        continue;
      known[n] = 1;
      double stress[six];
      for (std::size_t k = 0; k < six; ++k)
        step.nodal[first + k][n] = stress[k] = sum[k] / sum[six];
      step.nodal[first + six][n] = solid::von_mises(stress);
    }
  }
}

} // namespace

void add_further_names(const io::FieldOptions& further, io::ResultNames& names) {
  if (further.stress_tensor)
    add_tensor("stress_tensor", names.element);
  if (further.principal_stress)
    for (const char* which : {"_max", "_mid", "_min"})
      names.element.push_back(std::string("principal_stress") + which);
  if (further.strain)
    add_tensor("strain", names.element);
  if (further.nodal_stress) {
    add_tensor("nodal_stress", names.nodal);
    names.nodal.push_back("nodal_von_mises");
  }
}

void add_further_values(const Scene& m, const State& s, const io::FieldOptions& further,
                        io::ResultStep& step) {
  if (further.stress_tensor)
    add_element_values(m, six, step, [&](std::size_t b, std::size_t e, double* values) {
      std::copy_n(&s.elements[b].stress[six * e], six, values);
    });
  if (further.principal_stress)
    add_element_values(m, 3, step, [&](std::size_t b, std::size_t e, double* values) {
      const auto principal = solid::principal_values(&s.elements[b].stress[six * e]);
      std::copy(principal.begin(), principal.end(), values);
    });
  if (!further.strain && !further.nodal_stress)
    return;
  const std::vector<solid::RecoveredFields> recovered = recover(m, s);
  if (further.strain)
    add_element_values(m, six, step, [&](std::size_t b, std::size_t e, double* values) {
      std::copy_n(&recovered[b].strain[six * e], six, values);
    });
  if (further.nodal_stress)
    add_nodal_stress(m, recovered, step);
}

} // namespace abut::scene
