// SPDX-License-Identifier: BSD-3-Clause
#include "check.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace abut::deck {

namespace {

class ReferenceCheck {
public:
  explicit ReferenceCheck(const Deck& deck) : deck_(deck) {}

  void run() const {
    lengths();
    bodies();
    for (const auto& surface : deck_.surfaces)
      this->surface("surfaces." + surface.name, surface);
    for (const auto& joint : deck_.joints)
      this->joint("joints." + joint.name, joint);
    for (const auto& d : deck_.displacements)
      curve("displacements." + d.name, d.curve);
    for (const auto& load : deck_.loads)
      curve("loads." + load.name, load.curve);
    for (const auto& pair : deck_.contact) {
      curve("contact." + pair.name, pair.penalty_curve, ".penalty_curve");
      curve("contact." + pair.name, pair.friction_curve, ".friction_curve");
      curve("contact." + pair.name, pair.interference_curve, ".interference_curve");
    }
    for (const auto& v : deck_.verify)
      verify(v);
  }

private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw InputError(deck_.where(path) + ": " + message);
  }

  template <class List>
  void name(const std::string& path, const std::string& word, const List& list,
            const char* section) const {
    std::vector<std::string> names;
    for (const auto& item : list)
      names.push_back(item.name);
    if (std::find(names.begin(), names.end(), word) != names.end())
      return;
    fail(path, "'" + word + "' is not a name under " + section + "; " +
                   nearest_word_hint(word, names.data(), names.size()));
  }

  /// Variables of the results are called after these, and NetCDF has 256 characters.
  void lengths() const {
    constexpr std::size_t longest = 200;
    const auto check = [&](const char* section, const auto& list) {
      for (const auto& item : list)
        if (item.name.size() > longest)
          fail(section + item.name, "the name has " + std::to_string(item.name.size()) +
                                        " characters, expected at most " + std::to_string(longest));
    };
    check("bodies.", deck_.bodies);
    check("joints.", deck_.joints);
    check("contact.", deck_.contact);
    check("surfaces.", deck_.surfaces);
  }

  void curve(const std::string& path, const std::string& word, const char* key = ".curve") const {
    if (!word.empty())
      name(path + key, word, deck_.curves, "curves");
  }

  void contact_place(const std::string& path, const std::string& place) const {
    for (const auto& pair : deck_.contact)
      if (pair.two_pass && place == pair.name + "_second_pass")
        return;
    name(path + ".place", place, deck_.contact, "contact");
  }

  void bodies() const {
    std::map<std::string, std::string> owner;
    bool moves = false;
    for (const auto& body : deck_.bodies) {
      const std::string path = "bodies." + body.name;
      for (const std::string& block : body.blocks) {
        const auto [other, first] = owner.emplace(block, body.name);
        if (!first)
          fail(path + ".blocks",
               "block '" + block + "' already belongs to body '" + other->second + "'");
      }
      moves = moves || !body.rigid || body.motion.has_unknowns();
      dynamics(path, body);
      if (body.rigid)
        rigid(path + ".rigid", body.motion);
      else
        name(path + ".material", body.material, deck_.materials, "materials");
    }
    if (!moves)
      fail("bodies", "the motion of all bodies is prescribed; expected one with a material, or a "
                     "rigid one with components that are 'free'");
  }

  /// A body that moves by inertia has mass, and only then an initial velocity of its own.
  void dynamics(const std::string& path, const scene::BodyOptions& body) const {
    constexpr std::array<double, 3> none{};
    const bool moves = body.initial_velocity != none || body.initial_angular_velocity != none;
    const char* key =
        body.initial_velocity != none ? ".initial_velocity" : ".initial_angular_velocity";
    if (!deck_.dynamics.active) {
      if (moves)
        fail(path + key,
             "the deck has no key 'dynamics': without inertia a velocity means nothing");
      return;
    }
    if (!body.rigid) {
      for (const auto& material : deck_.materials)
        if (material.name == body.material && !material.density)
          fail("materials." + material.name,
               "missing key 'density', which dynamics needs (mass per reference volume)");
      return;
    }
    const rigid::MotionOptions& motion = body.motion;
    const std::string rigid = path + ".rigid";
    if (motion.density && body.blocks.empty())
      fail(rigid + ".density", "the body has no blocks; give 'mass'");
    if (motion.has_unknowns() && !motion.density && !motion.mass)
      fail(rigid, "missing key 'density' or 'mass', which dynamics needs of a body that is free");
    for (std::size_t i = 0; motion.mass && i < 3; ++i)
      if (motion.free[3 + i] && !(motion.moments_of_inertia[i] > 0.0))
        fail(rigid + ".moments_of_inertia",
             "the rotation is free: expected numbers > 0 beside 'mass'");
    for (std::size_t i = 0; i < 3; ++i)
      if ((body.initial_velocity[i] != 0.0 && !motion.free[i]) ||
          (body.initial_angular_velocity[i] != 0.0 && !motion.free[3 + i]))
        fail(path + key, std::string("component ") + "xyz"[i] +
                             " is prescribed, and starts with the slope of its curve");
  }

  void surface(const std::string& path, const scene::SurfaceOptions& surface) const {
    constexpr std::array<double, 3> none{};
    const auto direction = [&](const char* key, const std::array<double, 3>& v) {
      if (v == none)
        fail(path + key, "expected a direction, got zero");
    };
    if (!surface.body.empty())
      name(path + ".body", surface.body, deck_.bodies, "bodies");
    const mesh::FaceSelection& s = surface.selection;
    if (s.plane)
      direction(".plane.normal", s.plane->normal);
    if (s.cylinder)
      direction(".cylinder.axis", s.cylinder->axis);
    if (s.normal)
      direction(".normal.direction", s.normal->direction);
    for (std::size_t i = 0; s.box && i < 3; ++i)
      if (s.box->low[i] > s.box->high[i])
        fail(path + ".box.high", std::string("its ") + "xyz"[i] + " is less than that of 'low'");
  }

  void rigid(const std::string& path, const rigid::MotionOptions& motion) const {
    curve(path, motion.curve);
    curve(path, motion.load_curve, ".load_curve");
    constexpr const char* components[] = {".x", ".y", ".z", ".rx", ".ry", ".rz"};
    for (std::size_t i = 0; i < 6; ++i)
      curve(path + ".curves", motion.curves[i], components[i]);
    for (const auto& hold : motion.holds)
      curve(path + ".holds." + hold.name, hold.curve);
    for (std::size_t i = 0; i < 6; ++i)
      curve(path + ".load_curves", motion.load_curves[i], components[i]);
  }

  void joint(const std::string& path, const rigid::JointOptions& joint) const {
    curve(path, joint.curve);
    curve(path, joint.load_curve, ".load_curve");
    if (joint.bodies.size() != 2 || joint.bodies[0] == joint.bodies[1])
      fail(path + ".bodies", "expected the names of two rigid bodies, or of one and 'ground'");
    if ((joint.turns() || joint.slides()) && joint.axis == std::array<double, 3>{})
      fail(path + ".axis", "expected a direction, got zero");
    if (joint.kind == rigid::JointKind::spring && joint.from == joint.to &&
        joint.free_length != 0.0)
      fail(path + ".to", "the spring has no length: move its points apart, or give "
                         "'free_length: 0'");
    for (const std::string& word : joint.bodies)
      if (word != rigid::JointOptions::ground || has_body(word))
        rigid_body(path + ".bodies", word);
    if (deck_.dynamics.active && joint.kind != rigid::JointKind::spring)
      fail(path + ".kind", "of all joints only springs go with 'dynamics'");
    if (deck_.linear.method == solver::LinearMethod::krylov &&
        joint.kind != rigid::JointKind::spring)
      fail("linear_solver.method", "joints need a direct solver: automatic or direct");
  }

  void rigid_place(const std::string& path, const std::string& word) const {
    if (word.empty())
      fail(path, "missing key 'place' (the rigid body)");
    rigid_body(path + ".place", word);
  }

  bool has_body(const std::string& word) const {
    return std::any_of(deck_.bodies.begin(), deck_.bodies.end(),
                       [&](const auto& body) { return body.name == word; });
  }

  void rigid_body(const std::string& path, const std::string& word) const {
    name(path, word, deck_.bodies, "bodies");
    for (const auto& body : deck_.bodies)
      if (body.name == word && !body.rigid)
        fail(path, "body '" + word + "' is not rigid");
  }

  void verify(const VerifyOptions& v) const {
    const std::string path = "verify." + v.name;
    if (is_contact_quantity(v.quantity)) {
      if (v.place.empty())
        fail(path, "missing key 'place' (the contact interface)");
      contact_place(path, v.place);
    } else if (is_rigid_quantity(v.quantity)) {
      rigid_place(path, v.place);
    } else if (is_joint_quantity(v.quantity)) {
      if (v.place.empty())
        fail(path, "missing key 'place' (the joint)");
      name(path + ".place", v.place, deck_.joints, "joints");
    } else if (v.quantity == Quantity::newton_iterations) {
      if (!v.place.empty())
        fail(path + ".place", "newton_iterations counts the whole run");
    } else if (v.quantity >= Quantity::reaction_x && v.place.empty()) {
      fail(path, "missing key 'place' (the node set or side set whose reactions are summed)");
    } else if (v.place.empty() && !v.point) {
      fail(path, "expected one of the keys place, point");
    } else if (v.quantity < Quantity::reaction_x && !v.place.empty() && v.point) {
      fail(path + ".point", "only one of the keys place, point is allowed");
    }
  }

  const Deck& deck_;
};

} // namespace

void check_references(const Deck& deck) {
  ReferenceCheck(deck).run();
}

} // namespace abut::deck
