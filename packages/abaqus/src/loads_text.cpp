// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/sides.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

/// Sides as keys of demands, and back.
class SideKeys {
public:
  long long key(const mesh::SideData& side) {
    const auto [at, is_new] = key_.try_emplace({side.block, side.element, side.side},
                                               static_cast<long long>(sides_.size()));
    if (is_new)
      sides_.push_back(side);
    return at->second;
  }
  const mesh::SideData& side(long long key) const { return sides_[std::size_t(key)]; }

private:
  std::map<std::tuple<int, Global, int>, long long> key_;
  std::vector<mesh::SideData> sides_;
};

class LoadWriter {
public:
  LoadWriter(const DeckParts& parts, const RigidBodies& rigid) : parts_(parts), rigid_(rigid) {}

  std::string text(const Runs& forces) {
    nodal(forces);
    for (const bool on_surface : {false, true}) {
      on_faces(on_surface, Load::Kind::pressure);
      on_faces(on_surface, Load::Kind::traction);
    }
    on_bodies(Load::Kind::gravity);
    on_bodies(Load::Kind::body_force);
    return out_.empty() ? "" : "loads:\n" + out_;
  }

private:
  /// Keys with the same three courses; the name of one of their sets.
  using Three = std::array<Points, 3>;
  struct Group {
    std::string name;
    std::vector<long long> keys;
  };
  using Groups = std::map<std::pair<std::string, Three>, Group>;

  static Groups groups(const Runs& runs, const std::map<long long, std::string>& names) {
    std::map<long long, Three> of_key;
    for (const auto& [key, list] : runs)
      if (key.second < 3 && !list.empty())
        of_key[key.first][std::size_t(key.second)] = list.back().points;
    Groups groups;
    for (const auto& [key, three] : of_key) {
      const std::string& name = names.at(key);
      Group& group = groups[{name, three}];
      group.name = name;
      group.keys.push_back(key);
    }
    return groups;
  }

  static std::map<long long, std::string> names(const std::vector<Demand>& demands) {
    std::map<long long, std::string> result;
    for (const Demand& d : demands)
      result.emplace(d.key, d.name);
    return result;
  }

  /// An entry for each curve of a vector.
  void vector_load(const std::string& key, const Three& three, double factor,
                   const std::string& name, const std::string& place_key,
                   const std::string& place) {
    std::map<std::string, std::array<double, 3>> of_curve;
    for (std::size_t i = 0; i < 3; ++i) {
      if (three[i].empty())
        continue;
      const Timed t = parts_.curves.of(three[i], "loads_" + name);
      if (t.number != 0.0)
        of_curve[t.curve][i] = factor * t.number;
    }
    for (const auto& [curve, v] : of_curve) {
      FlowMap map;
      map.add(key, vector_text(v));
      map.add(place_key, quoted(place));
      if (!curve.empty())
        map.add("curve", curve);
      out_ += "  " + names_.make(name, "load") + ": " + map.text() + "\n";
    }
  }

  void nodal(const Runs& all) {
    Runs runs;
    for (const auto& [key, list] : all) {
      const int node = static_cast<int>(key.first);
      if (rigid_.body_of(node) < 0 && parts_.mesh.index(node) >= 0)
        runs[key] = list;
    }
    std::map<long long, std::string> name_of_key;
    for (const Condition& c : parts_.model.forces)
      for (const int n : c.nodes)
        name_of_key.emplace(n, name_of_set(c.set, "nodes"));
    for (const auto& [key, group] : groups(runs, name_of_key)) {
      std::vector<int> nodes(group.keys.begin(), group.keys.end());
      const std::vector<Global> set = parts_.mesh.nodes_of(nodes);
      vector_load("force", key.second, 1.0, "force_on_" + group.name, "node_set",
                  parts_.mesh.node_set(set, "loaded_" + group.name));
    }
  }

  void on_faces(bool on_surface, Load::Kind kind) {
    SideKeys keys;
    std::vector<Demand> demands;
    for (const Load& l : parts_.model.loads) {
      if (l.on_surface != on_surface || l.kind != kind)
        continue;
      const std::string name = name_of_set(l.name, "faces") + (on_surface ? "" : "_" + l.label);
      for (const mesh::SideData& side : parts_.mesh.sides_of(l.faces))
        for (int i = 0; i < (kind == Load::Kind::traction ? 3 : 1); ++i) {
          const double value =
              kind == Load::Kind::traction ? l.value * l.direction[std::size_t(i)] : l.value;
          demands.push_back({keys.key(side), i, l.step, value, l.amplitude, false, l.place, name});
        }
    }
    const Runs runs =
        runs_of(parts_.model, demands, Kind::load,
                on_surface ? Renewal::Kind::surface : Renewal::Kind::element, parts_.report);
    for (const auto& [key, group] : groups(runs, names(demands))) {
      std::vector<mesh::SideData> sides;
      for (const long long k : group.keys)
        sides.push_back(keys.side(k));
      const std::string set = parts_.mesh.side_set(sides, "loaded_" + group.name);
      if (kind == Load::Kind::traction)
        vector_load("traction", key.second, 1.0, group.name, "side_set", set);
      else
        pressure(key.second[0], group.name, set);
    }
  }

  void pressure(const Points& points, const std::string& name, const std::string& set) {
    const Timed t = parts_.curves.of(points, "loads_" + name);
    if (t.number == 0.0)
      return;
    FlowMap map;
    map.add("pressure", t.number);
    map.add("side_set", quoted(set));
    if (!t.curve.empty())
      map.add("curve", t.curve);
    out_ += "  " + names_.make("pressure_on_" + name, "pressure") + ": " + map.text() + "\n";
  }

  void on_bodies(Load::Kind kind) {
    std::vector<Demand> demands;
    for (const Load& l : parts_.model.loads)
      if (l.kind == kind)
        for (const int e : l.elements)
          for (int i = 0; i < 3; ++i)
            demands.push_back({e, i, l.step, l.value * l.direction[std::size_t(i)], l.amplitude,
                               false, l.place, l.name});
    if (demands.empty())
      return;
    const Runs runs =
        runs_of(parts_.model, demands, Kind::load, Renewal::Kind::element, parts_.report);
    const Place place = demands[0].place;
    for (const Body& body : parts_.mesh.bodies())
      for (const int b : body.blocks)
        on_block(body, b, runs, place, kind == Load::Kind::gravity);
  }

  void on_block(const Body& body, int b, const Runs& runs, const Place& place, bool gravity) {
    const Model& model = parts_.model;
    std::set<Three> different;
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
      if (parts_.mesh.block(static_cast<int>(e)) != b)
        continue;
      Three three;
      for (int i = 0; i < 3; ++i)
        if (const auto found = runs.find({static_cast<long long>(e), i}); found != runs.end())
          three[std::size_t(i)] = found->second.back().points;
      different.insert(three);
    }
    const std::string& block = parts_.mesh.data().blocks[std::size_t(b)].name;
    if (different.size() > 1) {
      parts_.say(place, "*DLOAD", Fate::refused,
                 "it acts on a part of block '" + block +
                     "': abut's body forces act on whole "
                     "blocks, each of one *SOLID SECTION");
      return;
    }
    if (*different.begin() == Three{})
      return;
    if (body.rigid >= 0) {
      parts_.say(place, "*DLOAD", Fate::used,
                 "not on the rigid body '" + block + "': where it may move, give it a force");
      return;
    }
    double factor = 1.0;
    if (gravity) {
      const auto m =
          model.materials.find(key_of(model.sections[std::size_t(body.section)].material));
      factor = m == model.materials.end() ? 0.0 : m->second.density;
      if (factor == 0.0)
        parts_.say(place, "*DLOAD", Fate::refused,
                   "GRAV on block '" + block + "', whose material has no *DENSITY");
    }
    vector_load("body_force", *different.begin(), factor, "weight_of_" + block, "block", block);
  }

  const DeckParts& parts_;
  const RigidBodies& rigid_;
  DeckNames names_;
  std::string out_;
};

} // namespace

std::string loads_text(const DeckParts& parts, const Runs& forces, const RigidBodies& rigid) {
  return LoadWriter(parts, rigid).text(forces);
}

} // namespace abut::abaqus
