// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/state.hpp"

#include "abut/core/trilinos.hpp"

namespace abut::scene {

namespace {

/// A spring may be stretched at the start.
double initial_energy(const rigid::Joint& joint) {
  const double stretch = norm(joint.end - joint.origin) - joint.free_length;
  return joint.is_spring() ? 0.5 * joint.stiffness * stretch * stretch : 0.0;
}

double stored(const Scene& m, const std::vector<solid::ElementFields>& elements,
              const std::vector<rigid::JointState>& joints) {
  double sum = 0.0;
  for (const solid::ElementFields& block : elements)
    sum += block.total_energy();
  sum = m.mesh->comm.sum(sum);
  for (std::size_t j = 0; j < joints.size(); ++j)
    sum += joints[j].energy - initial_energy(m.joints[j]);
  return sum;
}

std::vector<solid::ElementFields> element_fields(const Scene& m, const NodalFields& fields) {
  std::vector<solid::ElementFields> of_block(m.mesh->blocks.size());
  for (const auto& solid : m.solids)
    of_block[std::size_t(solid->block())] = solid->element_fields(fields);
  return of_block;
}

Energy energy(const Scene& m, const State& s) {
  Energy e;
  const assembly::ExternalWork& work = m.equations->external_work();
  e.work_in = work.loads + work.supports;
  e.stored = stored(m, s.elements, s.joints);
  for (const auto& c : s.contacts) {
    e.penalty += c.penalty_energy;
    e.friction += c.dissipation;
  }
  return e;
}

std::vector<double> values_of(const View<const double>& view) {
  return {view.data(), view.data() + view.extent(0)};
}

/// Motion and momentum of all bodies.
void add_motion(const Scene& m, const NodalFields& fields, State& s) {
  s.velocity = values_of(m.inertia->motion().velocity());
  s.acceleration = values_of(m.inertia->motion().acceleration());
  s.rigid_motions = m.equations->bodies().motions();
  const solid::Momentum mine = m.inertia->momentum(fields);
  double sums[7] = {mine.kinetic_energy};
  for (int i = 0; i < 3; ++i) {
    sums[1 + i] = mine.linear[i];
    sums[4 + i] = mine.angular[i];
  }
  m.mesh->comm.sum(sums, 7);
  s.energy.kinetic = sums[0];
  for (int i = 0; i < 3; ++i) {
    s.momentum[i] = sums[1 + i];
    s.angular_momentum[i] = sums[4 + i];
  }
  for (const rigid::BodyMotion& body : s.rigid_motions) {
    s.energy.kinetic += body.kinetic_energy;
    s.momentum += body.linear_momentum;
    s.angular_momentum += body.angular_momentum;
  }
}

} // namespace

double energy_of_bodies(const Scene& m) {
  const NodalFields fields = m.equations->fields();
  double kinetic = 0.0;
  if (m.inertia) {
    kinetic = m.mesh->comm.sum(m.inertia->momentum(fields).kinetic_energy);
    for (const rigid::BodyMotion& body : m.equations->bodies().motions())
      kinetic += body.kinetic_energy;
  }
  return stored(m, element_fields(m, fields), m.equations->joints().states()) + kinetic;
}

State make_state(const Scene& m, const Vector& x, double time, const solver::Counters& counters) {
  State s;
  s.time = time;
  s.counters = counters;
  s.u = m.equations->nodal_values(x);
  s.reaction = m.equations->raw_residual();
  s.supports = reactions(m, s.reaction, s.u, time);
  for (const auto& contact : m.contacts)
    s.contacts.push_back(contact->summary());
  s.rigid_bodies = m.equations->body_states();
  s.joints = m.equations->joints().states();
  const NodalFields fields{s.u.data(), 3, s.time};
  s.elements = element_fields(m, fields);
  s.energy = energy(m, s);
  if (m.inertia)
    add_motion(m, fields, s);
  return s;
}

} // namespace abut::scene
