// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "readers.hpp"

#include <algorithm>
#include <iterator>

namespace abut::febio {

namespace {

int component(const Element& dof, std::initializer_list<const char*> words) {
  const std::string text = dof.text();
  const std::vector<std::string> valid(words.begin(), words.end());
  const auto found = std::find(valid.begin(), valid.end(), text);
  if (found == valid.end())
    dof.fail("'" + text + "'; " + nearest_word_hint(text, valid.data(), valid.size()));
  return static_cast<int>(found - valid.begin());
}

void read_fixed(Element bc, Model& model) {
  constexpr const char* words[] = {"Rx_dof", "Ry_dof", "Rz_dof", "Ru_dof", "Rv_dof", "Rw_dof"};
  RigidCondition c;
  c.fixed = true;
  c.body = read_rigid_body(bc, "rb", model);
  for (std::size_t i = 0; i < 6; ++i)
    c.components[i] = bc.flag_or(words[i], false);
  c.name = bc.attribute_or("name", "");
  c.line = bc.line();
  model.rigid_conditions.push_back(c);
}

void read_prescribed(Element bc, bool rotation, Model& model) {
  RigidCondition c;
  c.body = read_rigid_body(bc, "rb", model);
  const Element dof = bc.required_child("dof");
  const int i = rotation ? component(dof, {"Ru", "Rv", "Rw"}) % 3 + 3
                         : component(dof, {"x", "y", "z", "Rx", "Ry", "Rz"}) % 3;
  c.components[static_cast<std::size_t>(i)] = true;
  c.value = bc.required_child("value").value();
  c.relative = bc.flag_or("relative", false);
  c.name = bc.attribute_or("name", "");
  c.line = bc.line();
  model.rigid_conditions.push_back(c);
}

void read_load(Element load, const std::string& type, Model& model) {
  RigidLoad r;
  r.body = read_rigid_body(load, "rb", model);
  const Element dof = load.required_child("dof");
  r.component = type == "rigid_moment" ? component(dof, {"Ru", "Rv", "Rw"}) + 3
                                       : component(dof, {"Rx", "Ry", "Rz", "Ru", "Rv", "Rw"});
  r.value = load.required_child("value").value();
  if (auto kind = load.child("load_type")) {
    const std::string text = kind->text();
    r.follower = text == "FOLLOW" || text == "1";
    if (!r.follower && text != "LOAD" && text != "0")
      kind->refuse("'" + text + "': abut has LOAD and FOLLOW");
  }
  load.expect("relative", 0, "abut has absolute loads on rigid bodies, relative 0");
  r.name = load.attribute_or("name", "");
  r.line = load.line();
  model.rigid_loads.push_back(r);
}

void read_rigid_velocity(Element ic, bool turns, Model& model) {
  InitialVelocity v;
  v.body = read_rigid_body(ic, "rb", model);
  v.name = ic.attribute_or("name", "");
  v.line = ic.line();
  v.turns = turns;
  const std::vector<double> value = ic.required_child("value").numbers(3);
  std::copy(value.begin(), value.end(), v.value.begin());
  model.initial_velocities.push_back(v);
}

} // namespace

std::string read_rigid_body(Element parent, const char* key, const Model& model) {
  const Element body = parent.required_child(key);
  std::string name = body.text();
  for (const Material& m : model.materials) // a number comes before a name, as in FEBio
    if (!m.id.empty() && m.id == name) {
      name = m.name;
      break;
    }
  const Material* material = model.material(name);
  if (!material)
    body.fail("there is no material '" + name + "'");
  if (!material->is_rigid())
    body.fail("material '" + name + "' is not a rigid body");
  return name;
}

void read_rigid(Element section, Model& model) {
  for (Element bc : section.children("rigid_bc")) {
    const std::string type = bc.required_attribute("type");
    if (type == "rigid_fixed")
      read_fixed(bc, model);
    else if (type == "rigid_displacement" || type == "rigid_rotation")
      read_prescribed(bc, type == "rigid_rotation", model);
    else
      bc.refuse("type '" + type + "': abut has rigid_fixed, rigid_displacement, rigid_rotation");
  }
  for (Element ic : section.children("rigid_ic")) {
    const std::string type = ic.required_attribute("type");
    if (type == "initial_rigid_velocity" || type == "initial_rigid_angular_velocity")
      read_rigid_velocity(ic, type == "initial_rigid_angular_velocity", model);
    else
      ic.refuse("type '" + type +
                "': abut has initial_rigid_velocity and initial_rigid_angular_velocity");
  }
  for (Element load : section.children("rigid_load")) {
    const std::string type = load.required_attribute("type");
    if (type == "rigid_force" || type == "rigid_moment")
      read_load(load, type, model);
    else
      load.refuse("type '" + type + "': abut has rigid_force and rigid_moment");
  }
  for (Element connector : section.children("rigid_connector"))
    read_connector(connector, model);
}

void read_boundary(Element section, Model& model) {
  constexpr const char* words[] = {"x_dof", "y_dof", "z_dof"};
  for (Element bc : section.children("bc")) {
    const std::string type = bc.required_attribute("type");
    const std::string name = bc.attribute_or("name", ""), place = bc.attribute_or("node_set", "");
    if (place.empty() && type != "rigid_deformation")
      bc.fail("expected an attribute 'node_set'");
    if (type == "rigid") {
      model.ties.push_back({name, place, read_rigid_body(bc, "rb", model), bc.line()});
      continue;
    }
    Displacement d;
    d.name = name;
    d.place = place;
    d.line = bc.line();
    if (type == "zero displacement") {
      for (std::size_t i = 0; i < 3; ++i)
        d.components[i] = bc.flag_or(words[i], false);
    } else if (type == "prescribed displacement") {
      d.components[static_cast<std::size_t>(component(bc.required_child("dof"), {"x", "y", "z"}))] =
          true;
      d.value = bc.required_child("value").value();
      d.relative = bc.flag_or("relative", false);
    } else {
      bc.refuse("type '" + type +
                "': abut has zero displacement, prescribed displacement and rigid");
      continue;
    }
    model.displacements.push_back(d);
  }
}

} // namespace abut::febio
