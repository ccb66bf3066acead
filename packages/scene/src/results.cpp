// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/results.hpp"

#include "abut/scene/contact_fields.hpp"

#include <map>
#include <set>

namespace abut::scene {

namespace {

struct RigidQuantity {
  const char* name;
  const Vec3 rigid::BodyState::*values;
};
constexpr RigidQuantity rigid_quantities[] = {{"_displacement", &rigid::BodyState::displacement},
                                              {"_rotation", &rigid::BodyState::rotation},
                                              {"_force", &rigid::BodyState::force},
                                              {"_moment", &rigid::BodyState::moment}};

struct MotionQuantity {
  const char* name;
  const Vec3 rigid::BodyMotion::*values;
};
constexpr MotionQuantity motion_quantities[] = {{"_velocity", &rigid::BodyMotion::velocity},
                                                {"_angular_velocity", &rigid::BodyMotion::spin}};
constexpr const char* axes[] = {"_x", "_y", "_z"};

/// A global variable and the key of the options that it belongs to.
struct GlobalName {
  std::string name, key;
};

/// What the variables of rigid bodies and joints begin with: their names, longer where something
/// before has it, so that a contact and the body it presses on may have one name.
struct Prefixes {
  std::vector<std::string> bodies, joints;

  explicit Prefixes(const Scene& m) {
    std::set<std::string> taken;
    const auto free_one = [&](std::string name, const char* kind) {
      while (!taken.insert(name).second)
        name += kind;
      return name;
    };
    for (const auto& c : m.contacts)
      taken.insert(c->name());
    for (const auto& body : m.rigid_bodies)
      bodies.push_back(free_one(body.name, "_body"));
    for (const auto& joint : m.joints)
      joints.push_back(free_one(joint.name, "_joint"));
  }
};

/// In the order of the file, behind the counters, energies and the audit.
std::vector<GlobalName> named_globals(const Scene& m) {
  const Prefixes prefixes(m);
  std::vector<GlobalName> result;
  const auto add_vector = [&](const std::string& name, const std::string& key) {
    for (const char* i : axes)
      result.push_back({name + i, key});
  };
  for (const auto& c : m.contacts)
    add_vector(std::string(c->name()) + "_force", std::string("contact.") + c->name());
  for (std::size_t b = 0; b < m.rigid_bodies.size(); ++b)
    for (const RigidQuantity& q : rigid_quantities)
      add_vector(prefixes.bodies[b] + q.name, "bodies." + m.rigid_bodies[b].name);
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    const std::string key = "joints." + m.joints[j].name;
    for (const char* q : {"_force", "_moment"})
      add_vector(prefixes.joints[j] + q, key);
    for (const char* q : {"_translation", "_rotation"})
      result.push_back({prefixes.joints[j] + q, key});
  }
  if (!m.inertia)
    return result;
  result.push_back({"kinetic_energy", "dynamics"});
  for (const char* quantity : {"momentum", "angular_momentum"})
    add_vector(quantity, "dynamics");
  for (std::size_t b = 0; b < m.rigid_bodies.size(); ++b)
    for (const MotionQuantity& q : motion_quantities)
      add_vector(prefixes.bodies[b] + q.name, "bodies." + m.rigid_bodies[b].name);
  return result;
}

void put_motion(const Scene& m, const State& s, io::ResultStep& step) {
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

io::ResultNames result_names(const Scene& m) {
  io::ResultNames names;
  names.nodal = {"displacement_x",     "displacement_y",     "displacement_z",
                 "contact_pressure",   "contact_gap",        "contact_traction_x",
                 "contact_traction_y", "contact_traction_z", "contact_status"};
  names.element = {"stress_xx", "stress_yy", "stress_zz", "stress_xy",
                   "stress_yz", "stress_xz", "von_mises", "energy"};
  names.global = {"steps",          "newton_iterations", "augmentations",
                  "cut_backs",      "work_in",           "energy_stored",
                  "energy_penalty", "energy_friction",   "energy_imbalance"};
  for (const char* measure :
       {"overlap", "overlap_over_face_size", "unseen_overlap", "tension", "cone", "balance"})
    names.global.push_back(std::string("audit_") + measure);
  for (const GlobalName& global : named_globals(m))
    names.global.push_back(global.name);
  if (m.inertia)
    for (const char* field : {"velocity", "acceleration"})
      for (const char* i : axes)
        names.nodal.push_back(std::string(field) + i);
  return names;
}

void require_own_names(const Scene& m, const Where& where) {
  std::map<std::string, std::string> key;
  constexpr std::size_t longest = 255; // NetCDF's limit
  for (const GlobalName& global : named_globals(m)) {
    if (global.name.size() > longest)
      throw InputError(where(global.key) + ": the variables of its name in the results would be " +
                       std::to_string(global.name.size()) + " characters long: expected at most " +
                       std::to_string(longest));
    const auto [first, is_new] = key.try_emplace(global.name, global.key);
    if (!is_new)
      throw InputError(where(global.key) + ": its '" + global.name +
                       "' in the results would have the name of that of " + first->second +
                       ": expected another name for one of the two");
  }
}

io::ResultStep result_step(const Scene& m, const State& s) {
  io::ResultStep step;
  step.time = s.time;
  const auto owned = static_cast<std::size_t>(m.mesh->num_owned);
  step.nodal.assign(9, std::vector<double>(owned, 0.0));
  const ContactFields contact = contact_fields(*m.mesh, m.contacts);
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
                 s.energy.imbalance(),
                 s.audit.overlap,
                 s.audit.overlap_over_face_size,
                 s.audit.unseen_overlap,
                 s.audit.tension,
                 s.audit.cone,
                 s.audit.balance};
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

} // namespace abut::scene
