// SPDX-License-Identifier: BSD-3-Clause
#include "verify.hpp"

#include "abut/core/error.hpp"
#include "abut/scene/contact_fields.hpp"
#include "abut/scene/names.hpp"

#include <cmath>
#include <limits>

namespace abut::app {

namespace {

using deck::Quantity;
using deck::VerifyOptions;

/// (N) whether this rank's node is one of the surface, complete at owned nodes. Collective.
std::vector<char> nodes_of(const mesh::Mesh& mesh, const mesh::Surface& surface) {
  std::vector<char> result(mesh.node.size(), 0);
  for (const Local n : surface.field_index)
    result[std::size_t(n)] = 1;
  mesh::node_exchange(mesh).max_to_owners(result.data());
  return result;
}

/// Contact radius of a Hertz contact: p^2 is linear in r^2, so c0 + c1 r^2 fitted over the middle
/// of the contact gives a^2 = -c0/c1. The axis is z through the origin; r is the current radius.
double contact_radius(const Model& m, const scene::State& s, const mesh::Surface& primary) {
  scene::ContactFields fields = scene::contact_fields(*m.mesh, m.contacts);
  const std::vector<char> here = nodes_of(*m.mesh, primary);
  double largest = 0.0;
  for (std::size_t n = 0; n < fields.pressure.size(); ++n) {
    fields.pressure[n] *= here[n];
    largest = std::max(largest, fields.pressure[n]);
  }
  largest = m.comm.max(largest);
  double sums[5] = {}; // 1, r^2, r^4, p^2, r^2 p^2
  for (std::size_t n = 0; n < fields.pressure.size(); ++n) {
    const double p = fields.pressure[n];
    // 0.2 a < r < 0.9 a in terms of the pressure itself
    if (p < std::sqrt(1.0 - 0.81) * largest || p > std::sqrt(1.0 - 0.04) * largest)
      continue;
    double r2 = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
      r2 += std::pow(m.mesh->x[3 * n + i] + s.u[3 * n + i], 2);
    const double terms[5] = {1.0, r2, r2 * r2, p * p, r2 * p * p};
    for (int k = 0; k < 5; ++k)
      sums[k] += terms[k];
  }
  m.comm.sum(sums, 5);
  const double d = sums[0] * sums[2] - sums[1] * sums[1];
  if (sums[0] < 2.0 || d <= 0.0)
    return std::numeric_limits<double>::quiet_NaN();
  const double c0 = (sums[3] * sums[2] - sums[4] * sums[1]) / d;
  const double c1 = (sums[0] * sums[4] - sums[1] * sums[3]) / d;
  return c1 < 0.0 ? std::sqrt(-c0 / c1) : std::numeric_limits<double>::quiet_NaN();
}

/// Mean displacement of a set, or displacement of the node nearest to a point.
double displacement(const Model& m, const scene::State& s, const VerifyOptions& v, std::size_t i) {
  const mesh::Mesh& mesh = *m.mesh;
  double sums[2] = {0.0, 0.0};
  if (v.point) {
    const auto distance = [&](std::size_t n) {
      double d = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        d += std::pow(mesh.x[3 * n + k] - (*v.point)[k], 2);
      return d;
    };
    double least = std::numeric_limits<double>::max();
    for (std::size_t n = 0; n < std::size_t(mesh.num_owned); ++n)
      least = std::min(least, distance(n));
    least = mesh.comm.min(least);
    for (std::size_t n = 0; n < std::size_t(mesh.num_owned); ++n)
      if (distance(n) == least)
        sums[0] += 1.0, sums[1] += s.u[3 * n + i];
  } else {
    for (Local n : scene::nodes_of_set(mesh, v.place))
      if (n < mesh.num_owned)
        sums[0] += 1.0, sums[1] += s.u[3 * std::size_t(n) + i];
  }
  mesh.comm.sum(sums, 2);
  return sums[1] / sums[0];
}

/// Force of the supports on the nodes of a set.
double reaction(const Model& m, const scene::State& s, const VerifyOptions& v, std::size_t i) {
  double sum = 0.0;
  for (Local n : scene::nodes_of_set(*m.mesh, v.place)) {
    if (n >= m.mesh->num_owned)
      continue;
    const Local row = m.equations->dofs().row_of_node(n);
    if (row >= 0)
      sum += s.reaction[3 * std::size_t(row) + i];
  }
  return m.comm.sum(sum);
}

double rigid_value(const Model& m, const scene::State& s, const VerifyOptions& v) {
  std::size_t b = 0;
  while (v.place != m.rigid_bodies[b].name)
    ++b;
  const rigid::BodyState& body = s.rigid_bodies[b];
  const int k = static_cast<int>(v.quantity) - static_cast<int>(Quantity::rigid_displacement_x);
  const Vec3* values[] = {&body.displacement, &body.rotation, &body.force, &body.moment};
  return (*values[k / 3])[k % 3];
}

double joint_value(const Model& m, const scene::State& s, const VerifyOptions& v) {
  std::size_t j = 0;
  while (v.place != m.joints[j].name)
    ++j;
  const rigid::JointState& joint = s.joints[j];
  if (v.quantity == Quantity::joint_translation)
    return joint.translation;
  if (v.quantity == Quantity::joint_rotation)
    return joint.rotation;
  const int k = static_cast<int>(v.quantity) - static_cast<int>(Quantity::joint_force_x);
  return (k < 3 ? joint.force : joint.moment)[k % 3];
}

double value_of(const Model& m, const scene::State& s, const VerifyOptions& v) {
  if (deck::is_rigid_quantity(v.quantity))
    return rigid_value(m, s, v);
  if (deck::is_joint_quantity(v.quantity))
    return joint_value(m, s, v);
  std::size_t c = 0;
  while (c < m.contacts.size() && v.place != m.contacts[c]->name())
    ++c;
  const contact::ContactSummary* contact = c < s.contacts.size() ? &s.contacts[c] : nullptr;
  switch (v.quantity) {
  case Quantity::force_x:
    return contact->force[0];
  case Quantity::force_y:
    return contact->force[1];
  case Quantity::force_z:
    return contact->force[2];
  case Quantity::max_pressure:
    return contact->max_pressure;
  case Quantity::max_penetration:
    return contact->max_penetration;
  case Quantity::active_points:
    return double(contact->active_points);
  case Quantity::stick_points:
    return double(contact->stick_points);
  case Quantity::slip_points:
    return double(contact->slip_points);
  case Quantity::max_slip:
    return contact->max_slip;
  case Quantity::friction_dissipation:
    return contact->dissipation;
  case Quantity::contact_radius:
    return contact_radius(m, s, m.contacts[c]->primary());
  case Quantity::displacement_x:
    return displacement(m, s, v, 0);
  case Quantity::displacement_y:
    return displacement(m, s, v, 1);
  case Quantity::displacement_z:
    return displacement(m, s, v, 2);
  case Quantity::reaction_x:
    return reaction(m, s, v, 0);
  case Quantity::reaction_y:
    return reaction(m, s, v, 1);
  case Quantity::reaction_z:
    return reaction(m, s, v, 2);
  case Quantity::newton_iterations:
    return double(s.counters.newton_iterations);
  default:
    break;
  }
  throw Defect("a quantity of 'verify' without a value");
}

} // namespace

std::vector<Verdict> verify(const Model& m, const scene::State& s) {
  std::vector<Verdict> verdicts;
  for (const VerifyOptions& v : m.deck.verify) {
    Verdict verdict{v.name, value_of(m, s, v), v.expected, v.allowed_error(), false};
    verdict.ok = std::fabs(verdict.value - verdict.expected) <= verdict.tolerance;
    verdicts.push_back(verdict);
  }
  return verdicts;
}

} // namespace abut::app
