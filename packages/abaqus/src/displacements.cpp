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
        for (int i = c.first; i <= c.last; ++i)
          of.emplace(std::pair(static_cast<long long>(n), i - 1), std::pair(c.set, c.place));
  }
};

} // namespace

std::vector<Demand> demands_of(const std::vector<Condition>& conditions) {
  std::vector<Demand> demands;
  for (const Condition& c : conditions)
    for (const int n : c.nodes)
      for (int i = c.first; i <= c.last; ++i)
        demands.push_back({n, i - 1, c.step, c.value, c.amplitude, c.stays, c.place, c.set});
  return demands;
}

std::string displacements_text(const DeckParts& parts, const Runs& runs, const RigidBodies& rigid) {
  const Model& model = parts.model;
  const Origins origins(model.boundaries);
  std::map<std::tuple<int, std::string, Run>, std::vector<int>> groups;
  std::set<long long> noted;
  for (const auto& [key, list] : runs) {
    const int node = static_cast<int>(key.first);
    const auto& origin = origins.of.at(key);
    if (rigid.body_of(node) >= 0) {
      if (!rigid.is_reference(node) && noted.insert(origin.second.line).second)
        parts.say(origin.second, "*BOUNDARY", Fate::used,
                  "nodes of '" + origin.first + "' that move with a rigid body follow it alone");
      continue;
    }
    if (key.second >= 3 || parts.mesh.index(node) < 0)
      continue; // solids have no rotations
    for (const Run& run : list)
      groups[{key.second, origin.first, run}].push_back(node);
  }
  std::vector<Entry> entries;
  for (const auto& [key, nodes] : groups) {
    const auto& [component, name, run] = key;
    Entry e;
    e.nodes = parts.mesh.nodes_of(nodes);
    e.name = name;
    e.window = parts.window(run.first, run.last);
    e.relative = run.stays;
    const bool fixed = run.stays || run.is_zero();
    const Timed value = fixed ? Timed{} : parts.curves.of(run.points, "moves_" + name);
    e.curve = value.curve;
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
  for (const Entry& e : entries) {
    FlowMap map;
    std::vector<std::string> fixed;
    map.add("set", quoted(parts.mesh.node_set(e.nodes, "held_" + e.name)));
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
    out += "  " + names.make(e.name, e.is_fixed() ? "fixed" : "moved") + ": " + map.text() + "\n";
  }
  return out.empty() ? "" : "displacements:\n" + out;
}

} // namespace abut::abaqus
