// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/globals.hpp"

#include <array>
#include <map>
#include <set>

namespace abut::scene {

namespace {

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

/// Variables of one thing, whose name they begin with.
class Group {
public:
  Group(std::vector<GlobalVariable>& list, std::string prefix, std::string key)
      : list_(list), prefix_(std::move(prefix)), key_(std::move(key)) {}

  void add(const char* name, double value, const char* meaning, const char* unit) {
    list_.push_back({prefix_ + name, key_, meaning, unit, value});
  }
  void add_vector(const char* name, const Vec3& value, const char* meaning, const char* unit) {
    for (int i = 0; i < 3; ++i)
      list_.push_back({prefix_ + name + "_" + "xyz"[i], key_, meaning, unit, value[i]});
  }

private:
  std::vector<GlobalVariable>& list_;
  std::string prefix_, key_;
};

void add_run(const State& s, std::vector<GlobalVariable>& list) {
  Group run(list, "", "");
  run.add("steps", double(s.counters.steps), "converged steps", "");
  run.add("newton_iterations", double(s.counters.newton_iterations), "of all steps", "");
  run.add("augmentations", double(s.counters.augmentations), "of all steps", "");
  run.add("cut_backs", double(s.counters.cut_backs), "of all steps", "");
  run.add("work_in", s.energy.work_in, "work of loads, supports, motion of bodies and joints",
          "energy");
  run.add("energy_stored", s.energy.stored, "strain energy, and that of springs between bodies",
          "energy");
  run.add("energy_penalty", s.energy.penalty, "in the springs of contact", "energy");
  run.add("energy_friction", s.energy.friction, "dissipated", "energy");
  run.add("energy_imbalance", s.energy.imbalance(), "what the ledger does not find again",
          "energy");
}

void add_audit(const audit::Measures& found, Group group) {
  group.add("overlap", found.overlap, "deepest point of one body in another", "length");
  group.add("overlap_over_face_size", found.overlap_over_face_size, "the same in face sizes", "");
  group.add("unseen_overlap", found.unseen_overlap, "deepest that no contact knows of", "length");
  group.add("tension", found.tension, "largest pull over the largest pressure", "");
  group.add("cone", found.cone, "largest shear beyond the cone over the largest pressure", "");
  group.add("balance", found.balance, "force or moment left over, over their sizes", "");
}

Vec3 vector(const std::array<double, 3>& a) {
  return {{a[0], a[1], a[2]}};
}

void add_contact(const contact::ContactSummary& c, Group group) {
  group.add_vector("_force", vector(c.force), "contact force on the primary surface", "force");
  group.add_vector("_moment", vector(c.moment), "moment of that force about the origin",
                   "force length");
  group.add("_area", c.current_area, "present area in contact", "length^2");
  group.add("_points", double(c.active_points), "points in contact", "");
  group.add("_stick_points", double(c.stick_points), "of them, those that stick", "");
  group.add("_slip_points", double(c.slip_points), "of them, those that slip", "");
  const bool paired = c.paired_points > 0;
  group.add("_gap_max", paired ? c.max_gap : 0.0, "largest gap of points with a partner", "length");
  group.add("_gap_mean", c.mean_gap, "mean gap of points with a partner", "length");
  group.add("_penetration_max", c.max_penetration, "largest penetration", "length");
  group.add("_penetration_mean", c.mean_penetration, "mean penetration of points in contact",
            "length");
  group.add("_pressure_max", c.max_pressure, "largest nodal contact pressure", "pressure");
  group.add("_slip_max", c.max_slip, "longest way slipped since the start", "length");
}

void add_body(const rigid::BodyState& body, const Vec3& center, Group group) {
  group.add_vector("_displacement", body.displacement, "of the center", "length");
  group.add_vector("_rotation", body.rotation, "rotation vector", "rad");
  group.add_vector("_force", body.force, "what holds prescribed components", "force");
  group.add_vector("_moment", body.moment, "the same, about the present center", "force length");
  group.add_vector("_position", center + body.displacement, "of the center", "length");
}

void add_joint(const rigid::JointState& joint, Group group) {
  group.add_vector("_force", joint.force, "of the first body on the second", "force");
  group.add_vector("_moment", joint.moment, "the same, about the joint", "force length");
  group.add("_translation", joint.translation, "of the second body along the axis", "length");
  group.add("_rotation", joint.rotation, "of the second body about the axis", "rad");
}

void add_motion(const Scene& m, const State& s, const Prefixes& prefixes,
                std::vector<GlobalVariable>& list) {
  Group run(list, "", "dynamics");
  run.add("kinetic_energy", s.energy.kinetic, "of all bodies", "energy");
  run.add_vector("momentum", s.momentum, "of all bodies", "force time");
  run.add_vector("angular_momentum", s.angular_momentum, "about the origin", "force length time");
  for (std::size_t b = 0; b < s.rigid_motions.size(); ++b) {
    Group body(list, prefixes.bodies[b], "bodies." + m.rigid_bodies[b].name);
    body.add_vector("_velocity", s.rigid_motions[b].velocity, "of the center", "length/time");
    body.add_vector("_angular_velocity", s.rigid_motions[b].spin, "of the body", "rad/time");
  }
}

} // namespace

std::vector<GlobalVariable> global_variables(const Scene& m, const State& s) {
  const Prefixes prefixes(m);
  std::vector<GlobalVariable> list;
  add_run(s, list);
  add_audit(s.audit, Group(list, "audit_", ""));
  for (std::size_t c = 0; c < m.contacts.size(); ++c) {
    const std::string name = m.contacts[c]->name();
    add_contact(s.contacts[c], Group(list, name, "contact." + name));
  }
  for (std::size_t i = 0; i < m.supports.size(); ++i) {
    Group group(list, m.supports[i], "displacements." + m.supports[i]);
    group.add_vector("_reaction", s.supports[i].force, "force of the support on the body", "force");
    group.add_vector("_reaction_moment", s.supports[i].moment,
                     "moment of that force about the origin", "force length");
  }
  for (std::size_t b = 0; b < m.rigid_bodies.size(); ++b)
    add_body(s.rigid_bodies[b], m.rigid_bodies[b].center,
             Group(list, prefixes.bodies[b], "bodies." + m.rigid_bodies[b].name));
  for (std::size_t j = 0; j < m.joints.size(); ++j)
    add_joint(s.joints[j], Group(list, prefixes.joints[j], "joints." + m.joints[j].name));
  if (m.inertia)
    add_motion(m, s, prefixes, list);
  return list;
}

std::vector<GlobalVariable> global_variables(const Scene& m) {
  State blank;
  blank.contacts.resize(m.contacts.size());
  blank.supports.resize(m.supports.size());
  blank.rigid_bodies.resize(m.rigid_bodies.size());
  blank.joints.resize(m.joints.size());
  blank.rigid_motions.resize(m.rigid_bodies.size());
  return global_variables(m, blank);
}

void require_own_names(const Scene& m, const Where& where) {
  std::map<std::string, std::string> key;
  constexpr std::size_t longest = 255; // NetCDF's limit
  for (const GlobalVariable& global : global_variables(m)) {
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

} // namespace abut::scene
