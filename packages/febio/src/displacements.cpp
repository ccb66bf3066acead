// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

/// One entry of the deck: conditions on the same nodes, all fixed or all with one curve.
struct Entry {
  std::vector<Global> nodes;
  std::string place;
  std::vector<std::string> names; ///< FEBio's
  std::array<bool, 3> fixed{}, given{};
  std::array<double, 3> number{};
  Value curve; ///< of what is given

  bool is_fixed() const { return fixed[0] || fixed[1] || fixed[2]; }
};

class Collector {
public:
  Collector(const Model& model, const RigidBodies& rigid, const MeshTranslation& mesh,
            Report& report)
      : model_(model), rigid_(rigid), mesh_(mesh), report_(report) {}

  std::vector<Entry> collect() {
    for (const Displacement& d : model_.displacements)
      if (!is_fixed(d))
        prescribe(d);
    for (const Displacement& d : model_.displacements)
      if (is_fixed(d))
        fix(d);
    std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return a.is_fixed() && !b.is_fixed(); // as FEBio's files have them
    });
    return std::move(entries_);
  }

private:
  /// A prescribed zero without a curve holds as a fixed one does.
  static bool is_fixed(const Displacement& d) { return d.value.is_zero(); }

  /// Nodes that move with rigid bodies follow these alone.
  std::vector<Global> deformable_nodes(const Displacement& d) {
    std::vector<Global> nodes;
    const std::vector<Global> all = mesh_.nodes_of(d.place, d.line);
    for (const Global id : all)
      if (!rigid_.body_of_node.count(id))
        nodes.push_back(id);
    if (nodes.size() < all.size())
      note(d, std::to_string(all.size() - nodes.size()) + " nodes move with rigid bodies instead");
    return nodes;
  }

  void prescribe(const Displacement& d) {
    const std::vector<Global> nodes = deformable_nodes(d);
    for (std::size_t i = 0; i < 3; ++i)
      if (d.components[i])
        for (const Global id : nodes) {
          const auto [it, is_new] = prescribed_[i].emplace(id, &d);
          if (!is_new && !(it->second->value == d.value))
            throw InputError(model_.where(d.line) + ": node " + std::to_string(id) + " has its " +
                             "xyz"[i] + " displacement prescribed in line " +
                             std::to_string(it->second->line) + " already");
        }
    add(nodes, d, false, d.components);
  }

  /// Nodes that something else prescribes are not fixed, as in FEBio.
  void fix(const Displacement& d) {
    const std::vector<Global> all = deformable_nodes(d);
    std::map<std::vector<Global>, std::array<bool, 3>> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!d.components[i])
        continue;
      std::vector<Global> nodes;
      for (const Global id : all)
        if (!prescribed_[i].count(id))
          nodes.push_back(id);
      if (nodes.size() < all.size())
        note(d, std::to_string(all.size() - nodes.size()) + " nodes have their " + "xyz"[i] +
                    " displacement prescribed instead");
      parts[nodes][i] = true;
    }
    for (const auto& [nodes, components] : parts)
      add(nodes, d, true, components);
  }

  void add(const std::vector<Global>& nodes, const Displacement& d, bool fixed,
           const std::array<bool, 3>& components) {
    if (nodes.empty() || components == std::array<bool, 3>{})
      return;
    auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
      return e.nodes == nodes && e.is_fixed() == fixed && (fixed || e.curve.curve == d.value.curve);
    });
    if (entry == entries_.end()) {
      entries_.push_back({nodes, d.place, {}, {}, {}, {}, d.value});
      entry = entries_.end() - 1;
    }
    if (std::find(entry->names.begin(), entry->names.end(), d.name) == entry->names.end())
      entry->names.push_back(d.name);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!components[i])
        continue;
      (fixed ? entry->fixed : entry->given)[i] = true;
      if (!fixed)
        entry->number[i] = d.value.number;
    }
  }

  void note(const Displacement& d, const std::string& text) {
    report_.add({d.line, "Boundary/bc '" + d.name + "'", Fate::used, text});
  }

  const Model& model_;
  const RigidBodies& rigid_;
  const MeshTranslation& mesh_;
  Report& report_;
  std::map<Global, const Displacement*> prescribed_[3];
  std::vector<Entry> entries_;
};

std::string entry_text(const Entry& e, const std::string& set, DeckCurves& curves) {
  constexpr const char* axes[] = {"x", "y", "z"};
  FlowMap map;
  map.add("set", quoted(set));
  std::vector<std::string> fixed;
  for (std::size_t i = 0; i < 3; ++i) {
    if (e.given[i])
      map.add(axes[i], e.number[i]);
    if (e.fixed[i])
      fixed.push_back(axes[i]);
  }
  if (!fixed.empty())
    map.add("fix", list_text(fixed));
  else
    map.add("curve", curves.of(e.curve));
  return map.text();
}

/// Nodes tied to a rigid body without elements that does not turn, one entry for each set.
std::string tied_text(const RigidBody& body, DeckNames& names, DeckCurves& curves) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::string out;
  for (const std::string& set : body.sets) {
    FlowMap map;
    map.add("set", quoted(set));
    std::vector<std::string> fixed;
    for (std::size_t i = 0; i < 3; ++i)
      if (body.motion[i] == 0.0)
        fixed.push_back(axes[i]);
      else
        map.add(axes[i], body.motion[i]);
    if (!fixed.empty())
      map.add("fix", list_text(fixed));
    if (body.has_motion)
      map.add("curve", curves.of(body.motion_curve));
    out += "  " + names.make(set, "tied") + ": " + map.text() + "  # FEBio: tied to rigid body " +
           body.materials[0] + "\n";
  }
  return out;
}

} // namespace

std::string displacements_text(const Model& model, const RigidBodies& rigid, MeshTranslation& mesh,
                               DeckCurves& curves, Report& report) {
  std::string out;
  DeckNames names;
  for (const Entry& e : Collector(model, rigid, mesh, report).collect()) {
    const std::string name = names.make(e.names[0], e.is_fixed() ? "fixed" : "moved");
    out += "  " + name + ": " + entry_text(e, mesh.set_of(e.nodes, e.place), curves);
    std::string others;
    for (const std::string& febio : e.names)
      if (febio != name)
        others += (others.empty() ? "" : ", ") + febio;
    out += (others.empty() ? "" : "  # FEBio: " + others) + "\n";
  }
  for (const RigidBody& body : rigid.bodies)
    if (body.is_displacement())
      out += tied_text(body, names, curves);
  return out.empty() ? "" : "displacements:\n" + out;
}

} // namespace abut::febio
