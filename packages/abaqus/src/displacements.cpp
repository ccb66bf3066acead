// SPDX-License-Identifier: BSD-3-Clause
#include "deck_parts.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

constexpr const char* axes[] = {"x", "y", "z"};

/// One entry of the deck: conditions on the same nodes, all fixed or all with one curve.
struct Entry {
  std::vector<Global> nodes;
  std::string name; ///< of the set in the file
  std::array<bool, 3> fixed{}, given{};
  std::array<double, 3> number{};
  std::string curve;
  Window window{};
  bool relative = false;

  bool is_fixed() const { return fixed[0] || fixed[1] || fixed[2]; }
};

/// Names of sets that the lines give to a node's component, and the place of one of them.
struct Origins {
  std::map<std::pair<long long, int>, std::pair<std::string, Place>> of;

  explicit Origins(const std::vector<Condition>& conditions) {
    for (const Condition& c : conditions)
      for (const int n : c.nodes)
        for (int i = c.first; i <= c.last; ++i) {
          auto& origin = of[{n, i - 1}];
          if (origin.first.empty() || origin.first == "nodes") // a set says more
            origin = {name_of_set(c.set, "nodes"), c.place};
        }
  }
};

} // namespace

std::string name_of_set(const std::string& field, const std::string& otherwise) {
  const std::string own = field.substr(field.find_last_of('.') + 1);
  return own.find_first_not_of("0123456789") == std::string::npos ? otherwise : field;
}

std::vector<Demand> demands_of(const std::vector<Condition>& conditions) {
  std::vector<Demand> demands;
  for (const Condition& c : conditions)
    for (const int n : c.nodes)
      for (int i = c.first; i <= c.last; ++i)
        demands.push_back({n, i - 1, c.step, c.value, c.amplitude, c.stays, c.place, c.set});
  return demands;
}

namespace {

using Groups = std::map<std::tuple<int, std::string, Run>, std::vector<int>>;

/// Nodes by component, name of their set, and course; those of rigid bodies follow these.
Groups groups_of(const DeckParts& parts, const Runs& runs, const RigidBodies& rigid) {
  const Origins origins(parts.model.boundaries);
  Groups groups;
  std::set<long long> noted;
  const auto note = [&](const Place& place, const std::string& text) {
    if (noted.insert(place.line).second)
      parts.say(place, "*BOUNDARY", Fate::used, text);
  };
  for (const auto& [key, list] : runs) {
    const int node = static_cast<int>(key.first);
    const auto& [name, place] = origins.of.at(key);
    if (rigid.body_of(node) >= 0) {
      if (!rigid.is_reference(node))
        note(place, "nodes of '" + name + "' that move with a rigid body follow it alone");
      continue;
    }
    if (key.second >= 3 || parts.mesh.index(node) < 0)
      continue; // solids have no rotations
    for (const Run& run : list) {
      groups[{key.second, name, run}].push_back(node);
      if (run.first > 0 && !run.stays && !run.is_zero())
        note(place, "nodes of '" + name + "' were free before: they start from zero");
    }
  }
  return groups;
}

std::string entry_text(const Entry& e, const std::string& set) {
  FlowMap map;
  std::vector<std::string> fixed;
  map.add("set", quoted(set));
  for (std::size_t i = 0; i < 3; ++i) {
    if (e.given[i])
      map.add(axes[i], e.number[i]);
    if (e.fixed[i])
      fixed.emplace_back(axes[i]);
  }
  if (!fixed.empty())
    map.add("fix", list_text(fixed));
  else if (!e.curve.empty())
    map.add("curve", e.curve);
  add_window(map, e.window);
  if (e.relative)
    map.add("relative", "true");
  return map.text();
}

} // namespace

std::string displacements_text(const DeckParts& parts, const Runs& runs, const RigidBodies& rigid) {
  std::vector<Entry> entries;
  for (const auto& [key, nodes] : groups_of(parts, runs, rigid)) {
    const auto& [component, name, run] = key;
    const bool fixed = run.stays || run.is_zero();
    const Timed value = fixed ? Timed{} : parts.curves.of(run.points, "moves_" + name);
    Entry e{parts.mesh.nodes_of(nodes),        name,     {}, {}, {}, value.curve,
            parts.window(run.first, run.last), run.stays};
    const auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry& other) {
      return other.nodes == e.nodes && other.is_fixed() == fixed && other.curve == e.curve &&
             other.window == e.window && other.relative == e.relative;
    });
    Entry& entry = same == entries.end() ? *entries.insert(entries.end(), e) : *same;
    const auto i = static_cast<std::size_t>(component);
    (fixed ? entry.fixed : entry.given)[i] = true;
    entry.number[i] = value.number;
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.is_fixed() && !b.is_fixed(); });
  std::string out;
  DeckNames names;
  for (const Entry& e : entries)
    out += "  " + names.make(e.name, e.is_fixed() ? "fixed" : "moved") + ": " +
           entry_text(e, parts.mesh.node_set(e.nodes, "held_" + e.name)) + "\n";
  return out.empty() ? "" : "displacements:\n" + out;
}

} // namespace abut::abaqus
