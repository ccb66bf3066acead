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

Energy energy(const Scene& m, const State& s) {
  Energy e;
  const assembly::ExternalWork& work = m.equations->external_work();
  e.work_in = work.loads + work.supports;
  for (const solid::ElementFields& block : s.elements)
    e.stored += block.total_energy();
  e.stored = m.mesh->comm.sum(e.stored);
  for (std::size_t j = 0; j < s.joints.size(); ++j)
    e.stored += s.joints[j].energy - initial_energy(m.joints[j]);
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

State make_state(const Scene& m, const Vector& x, double time, const solver::Counters& counters) {
  State s;
  s.time = time;
  s.counters = counters;
  s.u = m.equations->nodal_values(x);
  s.reaction = m.equations->raw_residual();
  for (const auto& contact : m.contacts)
    s.contacts.push_back(contact->summary());
  s.rigid_bodies = m.equations->body_states();
  s.joints = m.equations->joints().states();
  const NodalFields fields{s.u.data(), 3, s.time};
  s.elements.resize(m.mesh->blocks.size());
  for (const auto& solid : m.solids)
    s.elements[std::size_t(solid->block())] = solid->element_fields(fields);
  s.energy = energy(m, s);
  if (m.inertia)
    add_motion(m, fields, s);
  return s;
}

} // namespace abut::scene
