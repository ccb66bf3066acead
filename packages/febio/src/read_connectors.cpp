// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

namespace abut::febio {

namespace {

using Kind = RigidConnector::Kind;

Vec3 vector(const Element& e) {
  const std::vector<double> v = e.numbers(3);
  return {{v[0], v[1], v[2]}};
}

Vec3 direction(const Element& e) {
  const Vec3 v = vector(e);
  if (!(norm(v) > 0.0))
    e.fail("expected a direction, got zero");
  return v;
}

/// What only tells how FEBio comes near to the joint.
void ignore_penalties(Element connector) {
  connector.ignore({"laugon", "tolerance", "gaptol", "angtol", "force_penalty", "moment_penalty",
                    "auto_penalty", "minaug", "maxaug"},
                   "abut holds joints exactly, by multipliers that are unknowns");
  connector.ignore({"force_damping", "moment_damping"}, "nothing has a velocity in statics");
}

/// What follows a motion, where `key` says so; the load is of the free motion then.
void read_motion(Element connector, const char* key, const char* motion, const char* load,
                 std::optional<Value>& moves, Value& pushes) {
  const bool prescribed = connector.flag_or(key, false);
  Value value;
  if (auto child = connector.child(motion)) {
    value = child->value();
    if (!prescribed)
      child->set_ignored(std::string("without <") + key + "> it means nothing");
  }
  pushes = connector.value_or(load, 0.0);
  if (!prescribed)
    return;
  moves = value;
  if (!pushes.is_zero())
    connector.fail(std::string("<") + motion + "> and <" + load + "> cannot both be prescribed");
}

void read_spring(Element connector, RigidConnector& c) {
  c.origin = vector(connector.required_child("insertion_a"));
  c.axis = vector(connector.required_child("insertion_b"));
  c.stiffness = connector.required_child("k").number();
  c.free_length = connector.number_or("free_length", 0.0);
  if (!(c.stiffness > 0.0))
    connector.required_child("k").fail("expected a number > 0");
  if (c.free_length < 0.0)
    connector.required_child("free_length").fail("expected a number >= 0");
}

void read_spherical(Element connector, RigidConnector& c) {
  constexpr const char* turns[] = {"rotation_x", "rotation_y", "rotation_z"};
  constexpr const char* moments[] = {"moment_x", "moment_y", "moment_z"};
  const bool prescribed = connector.flag_or("prescribed_rotation", false);
  std::array<Value, 3> turn;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!prescribed)
      connector.ignore(turns[i], "without <prescribed_rotation> it means nothing");
    else
      turn[i] = connector.value_or(turns[i], 0.0);
    c.moment_vector[i] = connector.value_or(moments[i], 0.0);
    if (prescribed && !c.moment_vector[i].is_zero())
      connector.fail(std::string("<prescribed_rotation> and <") + moments[i] +
                     "> cannot both be given");
  }
  if (!prescribed)
    return;
  c.rotation_vector = turn;
  connector.note("FEBio's rotation vector is fixed in space, abut's turns with body_a");
}

/// Of the kinds that have one; FEBio's defaults.
Vec3 read_axis(Element connector, Kind kind) {
  if (kind == Kind::cylindrical)
    return direction(connector.required_child("joint_axis"));
  if (kind != Kind::revolute && kind != Kind::prismatic)
    return Vec3::zero();
  const auto child = connector.child(kind == Kind::revolute ? "rotation_axis" : "translation_axis");
  if (child)
    return direction(*child);
  return kind == Kind::revolute ? Vec3{{0.0, 0.0, 1.0}} : Vec3{{1.0, 0.0, 0.0}};
}

std::optional<Kind> kind_of(const std::string& type) {
  const std::pair<const char*, Kind> kinds[] = {{"rigid revolute joint", Kind::revolute},
                                                {"rigid prismatic joint", Kind::prismatic},
                                                {"rigid cylindrical joint", Kind::cylindrical},
                                                {"rigid spherical joint", Kind::spherical},
                                                {"rigid lock", Kind::lock},
                                                {"rigid spring", Kind::spring}};
  for (const auto& [word, kind] : kinds)
    if (type == word)
      return kind;
  return {};
}

} // namespace

void read_connector(Element connector, Model& model) {
  const std::string type = connector.required_attribute("type");
  const std::optional<Kind> kind = kind_of(type);
  if (!kind)
    return connector.refuse("type '" + type +
                            "': abut has rigid revolute joint, rigid prismatic joint, rigid "
                            "cylindrical joint, rigid spherical joint, rigid lock, rigid spring");
  RigidConnector c;
  c.kind = *kind;
  c.name = connector.attribute_or("name", "");
  c.line = connector.line();
  c.bodies = {read_rigid_body(connector, "body_a", model),
              read_rigid_body(connector, "body_b", model)};
  if (c.kind == Kind::spring) {
    read_spring(connector, c);
  } else {
    c.origin = vector(connector.required_child("joint_origin"));
    ignore_penalties(connector);
    c.axis = read_axis(connector, c.kind);
    connector.ignore({"transverse_axis", "second_axis"}, "it changes nothing but names");
  }
  if (c.kind == Kind::revolute || c.kind == Kind::cylindrical)
    read_motion(connector, "prescribed_rotation", "rotation", "moment", c.rotation, c.moment);
  if (c.kind == Kind::prismatic || c.kind == Kind::cylindrical)
    read_motion(connector, "prescribed_translation", "translation", "force", c.translation,
                c.force);
  if (c.kind == Kind::spherical)
    read_spherical(connector, c);
  if (c.kind == Kind::lock)
    connector.ignore("first_axis", "it changes nothing but names");
  model.connectors.push_back(c);
}

} // namespace abut::febio
