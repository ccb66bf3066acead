// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/reactions.hpp"

namespace abut::scene {

namespace {

/// visit(constraint, force) for each component that is held at t, once.
template <class Visit>
void each_held(const Scene& m, const std::vector<double>& raw, double t, const Visit& visit) {
  std::vector<char> seen(3 * static_cast<std::size_t>(m.mesh->num_owned), 0);
  for (const assembly::Constraint& c : m.constraints) {
    const Local row = m.equations->dofs().row_of_node(c.node);
    char& counted = seen[3 * std::size_t(c.node) + std::size_t(c.field)];
    if (row < 0 || counted || !c.window.holds(t))
      continue;
    counted = 1;
    visit(c, raw[3 * std::size_t(row) + std::size_t(c.field)]);
  }
}

} // namespace

std::vector<double> nodal_reactions(const Scene& m, const std::vector<double>& raw, double t) {
  std::vector<double> result(3 * static_cast<std::size_t>(m.mesh->num_owned), 0.0);
  each_held(m, raw, t, [&](const assembly::Constraint& c, double force) {
    result[3 * std::size_t(c.node) + std::size_t(c.field)] = force;
  });
  return result;
}

std::vector<Reaction> reactions(const Scene& m, const std::vector<double>& raw,
                                const std::vector<double>& u, double t) {
  std::vector<double> sums(6 * m.supports.size(), 0.0); // force, moment
  each_held(m, raw, t, [&](const assembly::Constraint& c, double size) {
    Vec3 force = Vec3::zero(), x;
    force[c.field] = size;
    for (std::size_t i = 0; i < 3; ++i)
      x[static_cast<int>(i)] =
          m.mesh->x[3 * std::size_t(c.node) + i] + u[3 * std::size_t(c.node) + i];
    const Vec3 moment = cross(x, force);
    double* sum = &sums[6 * std::size_t(c.group)];
    for (int i = 0; i < 3; ++i) {
      sum[i] += force[i];
      sum[3 + i] += moment[i];
    }
  });
  m.mesh->comm.sum(sums.data(), static_cast<int>(sums.size()));
  std::vector<Reaction> result(m.supports.size());
  for (std::size_t s = 0; s < result.size(); ++s)
    for (int i = 0; i < 3; ++i) {
      result[s].force[i] = sums[6 * s + std::size_t(i)];
      result[s].moment[i] = sums[6 * s + 3 + std::size_t(i)];
    }
  return result;
}

} // namespace abut::scene
