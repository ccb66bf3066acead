// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

constexpr const char* components[] = {"x", "y", "z", "rx", "ry", "rz"};

/// Numbers of six components, and a curve of each that has one.
struct Six {
  std::array<double, 6> number{};
  std::map<std::size_t, Points> course;
};

/// One curve, or a map of curves where components differ.
void add_curves(FlowMap& map, const Six& six, Curves& curves, const std::string& name,
                const std::string& key) {
  std::map<std::size_t, std::string> names;
  std::set<std::string> different;
  for (const auto& [i, points] : six.course) {
    names[i] = curves.of(points, name).curve;
    different.insert(names[i]);
  }
  if (different.size() == 1 && !different.begin()->empty()) {
    map.add(key, *different.begin());
  } else if (different.size() > 1) {
    FlowMap each;
    for (const auto& [i, curve] : names)
      each.add(components[i], curve.empty() ? curves.ramp() : curve);
    map.add(key + "s", each.text());
  }
}

void add_vector(FlowMap& map, const char* key, const Six& six, std::size_t first) {
  const std::array<double, 3> v{six.number[first], six.number[first + 1], six.number[first + 2]};
  if (v != std::array<double, 3>{})
    map.add(key, vector_text(v));
}

} // namespace

RigidBodies::RigidBodies(const DeckParts& parts, const Runs& displacements, const Runs& forces)
    : parts_(parts), displacements_(displacements), forces_(forces),
      of_node_(parts.model.nodes.size(), -1), is_reference_(parts.model.nodes.size(), false) {
  const Model& model = parts.model;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r) {
    const RigidBody& body = model.rigid_bodies[r];
    const auto claim = [&](int n) {
      int& owner = of_node_[std::size_t(n)];
      if (owner >= 0 && owner != static_cast<int>(r))
        throw InputError(model.where(body.place) + ": node " +
                         std::to_string(model.nodes[std::size_t(n)].label) +
                         " belongs to the rigid body of line " +
                         std::to_string(model.rigid_bodies[std::size_t(owner)].place.line) +
                         " already");
      owner = static_cast<int>(r);
    };
    for (const int e : body.elements) {
      const Element& element = model.elements[std::size_t(e)];
      for (int a = 0; a < element.type->nodes; ++a)
        claim(model.nodes_of(element)[a]);
    }
    for (const int n : body.nodes)
      claim(n);
    for (const int n : {body.reference, body.rotation})
      if (n >= 0) {
        claim(n);
        is_reference_[std::size_t(n)] = true;
      }
  }
  std::set<long long> said;
  for (const Condition& c : model.forces)
    for (const int n : c.nodes)
      if (body_of(n) >= 0 && !is_reference(n) && said.insert(c.place.line).second)
        parts.say(c.place, "*CLOAD", Fate::refused,
                  "forces on nodes that move with a rigid body: put them on its reference node");
}

std::vector<Run> RigidBodies::runs(const Runs& all, std::size_t r, int component) const {
  const RigidBody& body = parts_.model.rigid_bodies[r];
  auto found = all.find({body.reference, component});
  if (component >= 3 && body.rotation >= 0)
    found = all.find({body.rotation, component - 3});
  return found == all.end() ? std::vector<Run>() : found->second;
}

/// What prescribes a component for a time.
std::string RigidBodies::hold(const Run& run, std::size_t component, const std::string& name) {
  FlowMap map;
  if (run.stays || run.is_zero()) {
    map.add("fix", list_text({components[component]}));
  } else {
    const Timed value = parts_.curves.of(run.points, "moves_" + name);
    map.add(components[component], value.number);
    if (!value.curve.empty())
      map.add("curve", value.curve);
  }
  add_window(map, parts_.window(run.first, run.last));
  if (run.stays)
    map.add("relative", "true");
  return map.text();
}

void RigidBodies::add_density(FlowMap& map, const RigidBody& body) const {
  const Model& model = parts_.model;
  double density = 0.0;
  for (const Section& s : model.sections)
    for (const int e : s.elements)
      if (!body.elements.empty() && e == body.elements[0] &&
          model.materials.count(key_of(s.material)))
        density = model.materials.at(key_of(s.material)).density;
  if (density > 0.0)
    map.add("density", density);
  else
    parts_.say(body.place, "*RIGID BODY", Fate::refused,
               "it may move and has no mass: give its solids a *SOLID SECTION with *DENSITY");
}

std::string RigidBodies::motion(std::size_t r, const std::string& name) {
  const Model& model = parts_.model;
  const RigidBody& body = model.rigid_bodies[r];
  Six moves, loads;
  std::vector<std::string> free;
  std::string holds;
  DeckNames hold_names;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<Run> list = runs(displacements_, r, static_cast<int>(i));
    const bool whole = list.size() == 1 && list[0].first == 0 &&
                       list[0].last + 1 == model.steps.size() && !list[0].stays;
    if (whole && !list[0].is_zero()) {
      moves.number[i] = parts_.curves.of(list[0].points, "moves_" + name).number;
      moves.course[i] = list[0].points;
    }
    if (whole)
      continue;
    free.emplace_back(components[i]);
    for (const Run& run : list)
      holds += "        " + hold_names.make(std::string("hold_") + components[i], "hold") + ": " +
               hold(run, i, name) + "\n";
    for (const Run& run : runs(forces_, r, static_cast<int>(i))) {
      loads.number[i] = parts_.curves.of(run.points, "loads_" + name).number;
      loads.course[i] = run.points;
    }
  }
  FlowMap map;
  add_vector(map, "displacement", moves, 0);
  add_vector(map, "rotation", moves, 3);
  map.add("center", vector_text(model.nodes[std::size_t(body.reference)].x));
  add_curves(map, moves, parts_.curves, "moves_" + name, "curve");
  if (!free.empty())
    map.add("free", list_text(free));
  add_vector(map, "force", loads, 0);
  add_vector(map, "moment", loads, 3);
  add_curves(map, loads, parts_.curves, "loads_" + name, "load_curve");
  if (model.is_dynamic() && !free.empty())
    add_density(map, body);
  if (holds.empty())
    return "    rigid: " + map.text() + "\n";
  return "    rigid:\n" + map.lines("      ") + "      holds:\n" + holds;
}

std::string RigidBodies::one(std::size_t r, const Body* blocks, DeckNames& names) {
  const RigidBody& body = parts_.model.rigid_bodies[r];
  const std::string name = names.make(body.name, "rigid");
  std::vector<std::string> list;
  for (const int b : blocks ? blocks->blocks : std::vector<int>())
    list.push_back(quoted(parts_.mesh.data().blocks[std::size_t(b)].name));
  std::vector<int> tied = body.nodes;
  if (parts_.mesh.index(body.reference) >= 0)
    tied.push_back(body.reference);
  std::string out = "  " + name + ":\n";
  if (!list.empty())
    out += "    blocks: " + list_text(list) + "\n";
  const std::vector<Global> nodes = parts_.mesh.nodes_of(tied);
  if (!nodes.empty())
    out += "    node_sets: " + list_text({quoted(parts_.mesh.node_set(nodes, "tied_to_" + name))}) +
           "\n";
  if (list.empty() && nodes.empty()) {
    parts_.say(body.place, "rigid body '" + body.name + "'", Fate::ignored,
               "it has neither elements nor nodes of any");
    return "";
  }
  out += motion(r, name);
  std::array<double, 3> velocity{};
  for (const InitialVelocity& v : parts_.model.initial_velocities)
    if (std::find(v.nodes.begin(), v.nodes.end(), body.reference) != v.nodes.end())
      velocity[std::size_t(v.component - 1)] = v.value;
  if (parts_.model.is_dynamic() && velocity != std::array<double, 3>{})
    out += "    initial_velocity: " + vector_text(velocity) + "\n";
  return out;
}

std::string RigidBodies::text(DeckNames& names) {
  std::string out;
  const auto& bodies = parts_.mesh.bodies();
  for (std::size_t r = 0; r < parts_.model.rigid_bodies.size(); ++r) {
    const auto found = std::find_if(bodies.begin(), bodies.end(),
                                    [&](const Body& b) { return b.rigid == static_cast<int>(r); });
    out += one(r, found == bodies.end() ? nullptr : &*found, names);
  }
  return out;
}

} // namespace abut::abaqus
