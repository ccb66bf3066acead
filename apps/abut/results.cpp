// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "abut/core/trilinos.hpp"

#include <algorithm>

namespace abut::app {

namespace {

/// A spring may be stretched at the start.
double initial_energy(const assembly::RigidJoint& joint) {
  const double stretch = norm(joint.end - joint.origin) - joint.free_length;
  return joint.is_spring() ? 0.5 * joint.stiffness * stretch * stretch : 0.0;
}

Energy energy(const Model& m, const State& s) {
  Energy e;
  const assembly::ExternalWork& work = m.equations->external_work();
  e.work_in = work.loads + work.supports;
  for (const solid::ElementFields& block : s.elements)
    e.stored += block.total_energy();
  e.stored = m.comm.sum(e.stored);
  for (std::size_t j = 0; j < s.joints.size(); ++j)
    e.stored += s.joints[j].energy - initial_energy(m.joints[j]);
  for (const auto& c : s.contacts) {
    e.penalty += c.penalty_energy;
    e.friction += c.dissipation;
  }
  return e;
}

/// Motion and momentum of all bodies.
void add_motion(const Model& m, const NodalFields& fields, State& s) {
  s.velocity = m.inertia->motion().velocity();
  s.acceleration = m.inertia->motion().acceleration();
  s.rigid_motions = m.equations->rigid_body_motions();
  const solid::Momentum mine = m.inertia->momentum(fields);
  double sums[7] = {mine.kinetic_energy};
  for (int i = 0; i < 3; ++i) {
    sums[1 + i] = mine.linear[i];
    sums[4 + i] = mine.angular[i];
  }
  m.comm.sum(sums, 7);
  s.energy.kinetic = sums[0];
  for (int i = 0; i < 3; ++i) {
    s.momentum[i] = sums[1 + i];
    s.angular_momentum[i] = sums[4 + i];
  }
  for (const assembly::RigidBodyMotion& body : s.rigid_motions) {
    s.energy.kinetic += body.kinetic_energy;
    s.momentum += body.linear_momentum;
    s.angular_momentum += body.angular_momentum;
  }
}

} // namespace

State make_state(const Model& m, const Vector& x, double time, const solver::Counters& counters) {
  State s;
  s.time = time;
  s.counters = counters;
  s.u = m.equations->nodal_values(x);
  s.reaction = m.equations->raw_residual();
  for (const auto& contact : m.contacts)
    s.contacts.push_back(contact->summary());
  s.rigid_bodies = m.equations->rigid_body_states();
  s.joints = m.equations->rigid_joint_states();
  const NodalFields fields{s.u.data(), 3, s.time};
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b)
    s.elements.push_back(
        m.material[b] ? solid::element_fields(*m.mesh, static_cast<int>(b), *m.material[b], fields)
                      : solid::ElementFields());
  s.energy = energy(m, s);
  if (m.inertia)
    add_motion(m, fields, s);
  return s;
}

namespace {

struct RigidQuantity {
  const char* name;
  const Vec3 assembly::RigidBodyState::*values;
};
constexpr RigidQuantity rigid_quantities[] = {
    {"_displacement", &assembly::RigidBodyState::displacement},
    {"_rotation", &assembly::RigidBodyState::rotation},
    {"_force", &assembly::RigidBodyState::force},
    {"_moment", &assembly::RigidBodyState::moment}};

struct MotionQuantity {
  const char* name;
  const Vec3 assembly::RigidBodyMotion::*values;
};
constexpr MotionQuantity motion_quantities[] = {
    {"_velocity", &assembly::RigidBodyMotion::velocity},
    {"_angular_velocity", &assembly::RigidBodyMotion::spin}};
constexpr const char* axes[] = {"_x", "_y", "_z"};

} // namespace

namespace {

void add_motion_names(const Model& m, io::ResultNames& names) {
  for (const char* field : {"velocity", "acceleration"})
    for (const char* i : axes)
      names.nodal.push_back(std::string(field) + i);
  names.global.push_back("kinetic_energy");
  for (const char* quantity : {"momentum", "angular_momentum"})
    for (const char* i : axes)
      names.global.push_back(std::string(quantity) + i);
  for (const auto& body : m.rigid_bodies)
    for (const MotionQuantity& q : motion_quantities)
      for (const char* i : axes)
        names.global.push_back(body.name + q.name + i);
}

void put_motion(const Model& m, const State& s, io::ResultStep& step) {
  const auto owned = static_cast<std::size_t>(m.mesh->num_owned);
  for (const auto* field : {&s.velocity, &s.acceleration})
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double>& values = step.nodal.emplace_back(owned);
      for (std::size_t n = 0; n < owned; ++n)
        values[n] = (*field)[3 * n + i];
    }
  step.global.push_back(s.energy.kinetic);
  for (const Vec3* v : {&s.momentum, &s.angular_momentum})
    for (int i = 0; i < 3; ++i)
      step.global.push_back((*v)[i]);
  for (const auto& body : s.rigid_motions)
    for (const MotionQuantity& q : motion_quantities)
      for (int i = 0; i < 3; ++i)
        step.global.push_back((body.*q.values)[i]);
}

} // namespace

io::ResultNames result_names(const Model& m) {
  io::ResultNames names;
  names.nodal = {"displacement_x",     "displacement_y",     "displacement_z",
                 "contact_pressure",   "contact_gap",        "contact_traction_x",
                 "contact_traction_y", "contact_traction_z", "contact_status"};
  names.element = {"stress_xx", "stress_yy", "stress_zz", "stress_xy",
                   "stress_yz", "stress_xz", "von_mises", "energy"};
  names.global = {"steps",          "newton_iterations", "augmentations",
                  "cut_backs",      "work_in",           "energy_stored",
                  "energy_penalty", "energy_friction",   "energy_imbalance"};
  for (const auto& c : m.contacts)
    for (const char* i : {"_force_x", "_force_y", "_force_z"})
      names.global.push_back(std::string(c->name()) + i);
  for (const auto& body : m.rigid_bodies)
    for (const RigidQuantity& q : rigid_quantities)
      for (const char* i : {"_x", "_y", "_z"})
        names.global.push_back(body.name + q.name + i);
  for (const auto& joint : m.joints) {
    for (const char* q : {"_force_x", "_force_y", "_force_z", "_moment_x", "_moment_y", "_moment_z",
                          "_translation", "_rotation"})
      names.global.push_back(joint.name + q);
  }
  if (m.inertia)
    add_motion_names(m, names);
  return names;
}

ContactFields contact_fields(const Model& m) {
  const mesh::Mesh& mesh = *m.mesh;
  struct Entry {
    Global node;
    double weight, pressure, gap, status, traction[3];
  };
  std::vector<std::vector<Entry>> send(static_cast<std::size_t>(mesh.comm.size()));
  for (const auto& contact : m.contacts) {
    const contact::NodalSums sums = contact->nodal_sums();
    for (std::size_t i = 0; i < sums.weight.size(); ++i) {
      const Global node = contact->primary().node[i];
      send[static_cast<std::size_t>(mesh.owner(node))].push_back(
          {node,
           sums.weight[i],
           sums.pressure[i],
           sums.gap[i],
           sums.status[i],
           {sums.traction[3 * i], sums.traction[3 * i + 1], sums.traction[3 * i + 2]}});
    }
  }
  const auto owned = static_cast<std::size_t>(mesh.num_owned);
  ContactFields f;
  f.pressure.assign(owned, 0.0);
  f.gap = f.status = f.pressure;
  f.traction.assign(3 * owned, 0.0);
  std::vector<double> weight(owned, 0.0);
  const Global first = mesh.first_node[static_cast<std::size_t>(mesh.comm.rank())];
  for (const auto& list : mesh.comm.exchange(send))
    for (const Entry& e : list) {
      const auto n = static_cast<std::size_t>(e.node - first);
      weight[n] += e.weight;
      f.pressure[n] += e.pressure;
      f.gap[n] += e.gap;
      f.status[n] += e.status;
      for (std::size_t i = 0; i < 3; ++i)
        f.traction[3 * n + i] += e.traction[i];
    }
  for (std::size_t n = 0; n < owned; ++n) {
    if (weight[n] <= 0.0)
      continue;
    f.pressure[n] /= weight[n];
    f.gap[n] /= weight[n];
    f.status[n] = f.status[n] <= 0.0 ? 0.0 : f.status[n] < 1.5 * weight[n] ? 1.0 : 2.0;
    for (std::size_t i = 0; i < 3; ++i)
      f.traction[3 * n + i] /= weight[n];
  }
  return f;
}

namespace {

void add_element_fields(const Model& m, const State& s, io::ResultStep& step) {
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

io::ResultStep result_step(const Model& m, const State& s) {
  io::ResultStep step;
  step.time = s.time;
  const auto owned = static_cast<std::size_t>(m.mesh->num_owned);
  step.nodal.assign(9, std::vector<double>(owned, 0.0));
  const ContactFields contact = contact_fields(m);
  for (std::size_t n = 0; n < owned; ++n)
    for (std::size_t i = 0; i < 3; ++i) {
      step.nodal[i][n] = s.u[3 * n + i];
      step.nodal[5 + i][n] = contact.traction[3 * n + i];
    }
  step.nodal[3] = contact.pressure;
  step.nodal[4] = contact.gap;
  step.nodal[8] = contact.status;
  add_element_fields(m, s, step);
  step.global = {double(s.counters.steps),
                 double(s.counters.newton_iterations),
                 double(s.counters.augmentations),
                 double(s.counters.cut_backs),
                 s.energy.work_in,
                 s.energy.stored,
                 s.energy.penalty,
                 s.energy.friction,
                 s.energy.imbalance()};
  for (const auto& c : s.contacts)
    step.global.insert(step.global.end(), c.force.begin(), c.force.end());
  for (const auto& body : s.rigid_bodies)
    for (const RigidQuantity& q : rigid_quantities)
      for (int i = 0; i < 3; ++i)
        step.global.push_back((body.*q.values)[i]);
  for (const auto& joint : s.joints) {
    for (const Vec3* v : {&joint.force, &joint.moment})
      for (int i = 0; i < 3; ++i)
        step.global.push_back((*v)[i]);
    step.global.push_back(joint.translation);
    step.global.push_back(joint.rotation);
  }
  if (m.inertia)
    put_motion(m, s, step);
  return step;
}

} // namespace abut::app
