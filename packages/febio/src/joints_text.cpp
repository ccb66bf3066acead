// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

namespace abut::febio {

namespace {

using Kind = RigidConnector::Kind;

const char* kind_word(Kind kind) {
  switch (kind) {
  case Kind::revolute:
    return "revolute";
  case Kind::prismatic:
    return "prismatic";
  case Kind::cylindrical:
    return "cylindrical";
  case Kind::spherical:
    return "spherical";
  case Kind::lock:
    return "lock";
  case Kind::spring:
    return "spring";
  }
  throw Defect("a kind of connector without a word");
}

std::string point_text(const Vec3& x) {
  return vector_text({x[0], x[1], x[2]});
}

class JointWriter {
public:
  JointWriter(const Model& model, const RigidBodies& rigid, DeckCurves& curves, Report& report)
      : model_(model), rigid_(rigid), curves_(curves), report_(report) {}

  std::string text() {
    std::string out;
    for (const RigidConnector& c : model_.connectors) {
      if (c.step >= 0 && model_.steps.size() > 1) {
        refuse(c, "it holds in one step alone: put it outside of the steps");
        continue;
      }
      const std::string name = names_.make(c.name, kind_word(c.kind));
      out += "  " + name + ": " + map(c).text() +
             (name == c.name || c.name.empty() ? "" : "  # FEBio: " + c.name) + "\n";
    }
    return out.empty() ? "" : "joints:\n" + out;
  }

private:
  void refuse(const RigidConnector& c, const std::string& why) {
    report_.add({c.line, "Rigid/rigid_connector '" + c.name + "'", Fate::refused, why});
  }

  const std::string& body(const RigidConnector& c, std::size_t i) const {
    const RigidBody* found = rigid_.of_material(c.bodies[i]);
    if (!found)
      throw InputError(model_.where(c.line) + ": rigid body '" + c.bodies[i] +
                       "' has neither elements nor nodes");
    return found->deck_name;
  }

  FlowMap map(const RigidConnector& c) {
    FlowMap map;
    map.add("kind", kind_word(c.kind));
    if (rigid_.of_material(c.bodies[0]) == rigid_.of_material(c.bodies[1]))
      throw InputError(model_.where(c.line) + ": <rigid_connector> connects '" + c.bodies[0] +
                       "' with itself");
    map.add("bodies", list_text({body(c, 0), body(c, 1)}));
    if (c.kind == Kind::spring) {
      map.add("from", point_text(c.origin));
      map.add("to", point_text(c.axis));
      map.add("stiffness", c.stiffness);
      if (c.free_length > 0.0)
        map.add("free_length", c.free_length);
      return map;
    }
    if (model_.is_dynamic())
      refuse(c, "of all connectors abut has only springs with inertia; take out DYNAMIC where "
                "inertia does not matter");
    map.add("origin", point_text(c.origin));
    if (c.kind != Kind::spherical && c.kind != Kind::lock)
      map.add("axis", point_text(c.axis));
    if (c.kind == Kind::spherical) {
      if (c.rotation_vector)
        add(c, map, "rotation_vector", *c.rotation_vector, 1.0, "curve");
      add(c, map, "moment_vector", c.moment_vector, -1.0, "load_curve");
      return map;
    }
    const auto values = [&](const char* key, std::initializer_list<Item> items) {
      std::string curve;
      for (const Item& item : items)
        add(c, map, item, curve);
      if (!curve.empty())
        map.add(key, curve);
    };
    values("curve", {{"rotation", c.rotation, 1.0}, {"translation", c.translation, 1.0}});
    // FEBio's loads act on the first body
    values("load_curve", {{"moment", c.moment, -1.0}, {"force", c.force, -1.0}});
    return map;
  }

  struct Item {
    const char* key;
    std::optional<Value> value;
    double factor;
  };
  /// Adds a value where it means something, and remembers its curve.
  void add(const RigidConnector& c, FlowMap& map, const Item& item, std::string& curve) {
    const bool load = item.factor < 0.0;
    if (!item.value || (load && item.value->is_zero()))
      return;
    map.add(item.key, item.factor * item.value->number);
    if (item.value->is_zero())
      return;
    const std::string name = curves_.of(*item.value);
    if (!curve.empty() && curve != name)
      refuse(c, "its rotation and translation, or its moment and force, follow different load "
                "curves: abut has one curve for both");
    curve = name;
  }

  /// A vector; zero means nothing but for a motion.
  void add(const RigidConnector& c, FlowMap& map, const char* key,
           const std::array<Value, 3>& values, double factor, const char* curve_key) {
    std::array<double, 3> v{};
    std::string curve;
    for (std::size_t i = 0; i < 3; ++i) {
      if (values[i].is_zero())
        continue;
      v[i] = factor * values[i].number;
      const std::string name = curves_.of(values[i]);
      if (!curve.empty() && name != curve)
        refuse(c, "its components follow different load curves: abut has one curve for them");
      curve = name;
    }
    if (curve.empty() && factor < 0.0)
      return;
    map.add(key, vector_text(v));
    if (!curve.empty())
      map.add(curve_key, curve);
  }

  const Model& model_;
  const RigidBodies& rigid_;
  DeckCurves& curves_;
  Report& report_;
  DeckNames names_;
};

} // namespace

std::string joints_text(const Model& model, const RigidBodies& rigid, DeckCurves& curves,
                        Report& report) {
  return JointWriter(model, rigid, curves, report).text();
}

} // namespace abut::febio
