// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <set>

namespace abut::febio {

namespace {

/// One entry of the deck: conditions on the same nodes, all fixed or all with one curve.
struct Entry {
  std::vector<Global> nodes;
  std::string place;
  std::vector<std::string> names; ///< FEBio's
  std::array<bool, 3> fixed{}, given{};
  std::array<double, 3> number{};
  std::string curve; ///< of what is given
  Window window{};
  bool relative = false;

  bool is_fixed() const { return fixed[0] || fixed[1] || fixed[2]; }
};

class Collector {
public:
  Collector(const Model& model, const RigidBodies& rigid, const MeshTranslation& mesh,
            DeckCurves& curves, Report& report)
      : model_(model), rigid_(rigid), mesh_(mesh), curves_(curves), report_(report) {}

  std::vector<Entry> collect() {
    collect_steps();
    for (const Displacement& d : model_.displacements)
      if (!in_one_step(d) && !is_fixed(d))
        prescribe(d);
    for (const Displacement& d : model_.displacements)
      if (!in_one_step(d) && is_fixed(d))
        fix(d);
    follow_steps();
    std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return a.is_fixed() && !b.is_fixed(); // as FEBio's files have them
    });
    return std::move(entries_);
  }

private:
  using InSteps = std::vector<const Displacement*>; ///< (steps)

  /// A prescribed zero without a curve holds as a fixed one does.
  static bool is_fixed(const Displacement& d) { return d.value.is_zero() && !d.relative; }
  bool in_one_step(const Displacement& d) const { return d.step >= 0 && model_.steps.size() > 1; }

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

  [[noreturn]] void prescribed_twice(const Displacement& d, std::size_t i, Global id,
                                     const Displacement& other) const {
    throw InputError(model_.where(d.line) + ": node " + std::to_string(id) + " has its " +
                     "xyz"[i] + " displacement prescribed in line " + std::to_string(other.line) +
                     " already");
  }

  void prescribe(const Displacement& d) {
    const std::vector<Global> nodes = deformable_nodes(d);
    for (std::size_t i = 0; i < 3; ++i)
      if (d.components[i])
        for (const Global id : nodes) {
          const auto [it, is_new] = prescribed_[i].emplace(id, &d);
          if (!is_new && !(it->second->value == d.value))
            prescribed_twice(d, i, id, *it->second);
        }
    add(nodes, {&d}, false, d.components);
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
        if (!prescribed_[i].count(id) && !moves_in_a_step(i, id, d))
          nodes.push_back(id);
      if (nodes.size() < all.size())
        note(d, std::to_string(all.size() - nodes.size()) + " nodes have their " + "xyz"[i] +
                    " displacement prescribed instead");
      fixed_[i].insert(nodes.begin(), nodes.end());
      parts[nodes][i] = true;
    }
    for (const auto& [nodes, components] : parts)
      add(nodes, {&d}, true, components);
  }

  /// Then what is fixed in all steps holds in the others.
  bool moves_in_a_step(std::size_t i, Global id, const Displacement& d) {
    const auto found = course_[i].find(id);
    if (found == course_[i].end() ||
        std::none_of(found->second.begin(), found->second.end(),
                     [](const Displacement* s) { return s && !is_fixed(*s); }))
      return false;
    for (const Displacement*& step : found->second)
      if (!step)
        step = &d;
    return true;
  }

  /// What holds in one step alone.
  void collect_steps() {
    for (const Displacement& d : model_.displacements) {
      if (!in_one_step(d))
        continue;
      const std::vector<Global> nodes = deformable_nodes(d);
      for (std::size_t i = 0; i < 3; ++i)
        if (d.components[i])
          for (const Global id : nodes)
            hold(course_[i][id], d, i, id);
    }
  }

  void hold(InSteps& course, const Displacement& d, std::size_t i, Global id) const {
    course.resize(model_.steps.size());
    const Displacement*& mine = course[static_cast<std::size_t>(d.step)];
    if (mine && !is_fixed(*mine) && !is_fixed(d) && !(mine->value == d.value))
      prescribed_twice(d, i, id, *mine);
    if (!mine || is_fixed(*mine))
      mine = &d;
  }

  void follow_steps() {
    for (std::size_t i = 0; i < 3; ++i) {
      std::map<InSteps, std::vector<Global>> groups;
      for (const auto& [id, in_steps] : course_[i])
        if (!fixed_[i].count(id) && !prescribed_[i].count(id))
          groups[in_steps].push_back(id);
        else
          check_against_all_steps(in_steps, i, id);
      std::array<bool, 3> components{};
      components[i] = true;
      for (const auto& [in_steps, nodes] : groups)
        if (std::all_of(in_steps.begin(), in_steps.end(),
                        [](const auto* d) { return d && !d->relative; }))
          add(nodes, in_steps,
              std::all_of(in_steps.begin(), in_steps.end(),
                          [](const auto* d) { return is_fixed(*d); }),
              components);
        else
          add_parts(nodes, in_steps, components);
    }
  }

  /// An entry for each step, or for several with one after the other that fix the same.
  void add_parts(const std::vector<Global>& nodes, const InSteps& in_steps,
                 const std::array<bool, 3>& components) {
    for (std::size_t s = 0; s < in_steps.size(); ++s) {
      const Displacement* d = in_steps[s];
      if (!d)
        continue;
      const std::size_t first = s;
      while (is_fixed(*d) && s + 1 < in_steps.size() && in_steps[s + 1] &&
             is_fixed(*in_steps[s + 1]))
        ++s;
      add(nodes, {d}, is_fixed(*d), components, model_.window(first, s));
    }
  }

  void check_against_all_steps(const InSteps& in_steps, std::size_t i, Global id) const {
    const auto other = prescribed_[i].find(id);
    for (const Displacement* d : in_steps)
      if (d && !is_fixed(*d) && other != prescribed_[i].end())
        prescribed_twice(*d, i, id, *other->second);
  }

  Timed timed(const InSteps& in_steps) {
    Course course;
    for (const Displacement* d : in_steps)
      course.push_back(d->value);
    return curves_.of(course);
  }

  void add(const std::vector<Global>& nodes, const InSteps& in_steps, bool fixed,
           const std::array<bool, 3>& components, const Window& window = {}) {
    if (nodes.empty() || components == std::array<bool, 3>{})
      return;
    const Timed value = fixed ? Timed{} : timed(in_steps);
    const bool relative = in_steps[0]->relative;
    auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
      return e.nodes == nodes && e.is_fixed() == fixed && e.curve == value.curve &&
             e.window == window && e.relative == relative;
    });
    if (entry == entries_.end()) {
      entries_.push_back(
          {nodes, in_steps[0]->place, {}, {}, {}, {}, value.curve, window, relative});
      entry = entries_.end() - 1;
    }
    for (const Displacement* d : in_steps)
      if (std::find(entry->names.begin(), entry->names.end(), d->name) == entry->names.end())
        entry->names.push_back(d->name);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!components[i])
        continue;
      (fixed ? entry->fixed : entry->given)[i] = true;
      if (!fixed)
        entry->number[i] = value.number;
    }
  }

  void note(const Displacement& d, const std::string& text) {
    report_.add({d.line, "Boundary/bc '" + d.name + "'", Fate::used, text});
  }

  const Model& model_;
  const RigidBodies& rigid_;
  const MeshTranslation& mesh_;
  DeckCurves& curves_;
  Report& report_;
  std::map<Global, const Displacement*> prescribed_[3];
  std::set<Global> fixed_[3];
  std::map<Global, InSteps> course_[3]; ///< of nodes that something holds in one step
  std::vector<Entry> entries_;
};

std::string entry_text(const Entry& e, const std::string& set) {
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
    map.add("curve", e.curve);
  add_window(map, e.window);
  if (e.relative)
    map.add("relative", "true");
  return map.text();
}

/// Nodes tied to a rigid body without elements that does not turn, for each set an entry for each
/// curve.
std::string tied_text(const RigidBody& body, DeckNames& names, DeckCurves& curves) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> fixed;
  std::map<std::string, std::array<double, 3>> moved; // by curve
  for (std::size_t i = 0; i < 3; ++i)
    if (body.motion[i].empty()) {
      fixed.push_back(axes[i]);
    } else {
      const Timed t = curves.of(body.motion[i]);
      moved[t.curve][i] = t.number;
    }
  if (moved.empty())
    moved[""] = {};
  std::string out;
  for (const std::string& set : body.sets)
    for (const auto& [curve, numbers] : moved) {
      FlowMap map;
      map.add("set", quoted(set));
      for (std::size_t i = 0; i < 3; ++i)
        if (numbers[i] != 0.0)
          map.add(axes[i], numbers[i]);
      if (!fixed.empty() && curve == moved.begin()->first)
        map.add("fix", list_text(fixed));
      if (!curve.empty())
        map.add("curve", curve);
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
  for (const Entry& e : Collector(model, rigid, mesh, curves, report).collect()) {
    const std::string name = names.make(e.names[0], e.is_fixed() ? "fixed" : "moved");
    out += "  " + name + ": " + entry_text(e, mesh.set_of(e.nodes, e.place));
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
