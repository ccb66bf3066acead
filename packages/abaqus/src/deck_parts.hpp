// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/window.hpp"
#include "courses.hpp"
#include "make_mesh.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

/// The sections of a deck.
namespace abut::abaqus {

using namespace translation;

/// What the sections share.
struct DeckParts {
  const Model& model;
  MeshTranslation& mesh;
  Curves& curves;
  Report& report;

  void say(const Place& place, const std::string& path, Fate fate, const std::string& note) const {
    report.add({place.line, place.file == 0 ? path : model.where(place) + ": " + path, fate, note});
  }
  /// The time of steps first to last.
  Window window(std::size_t first, std::size_t last) const {
    Window w{model.start(first), {}};
    if (last + 1 < model.steps.size())
      w.until = model.start(last + 1);
    return w;
  }
};

/// A rigid body with what moves and loads its reference node.
class RigidBodies {
public:
  RigidBodies(const DeckParts& parts, const Runs& displacements, const Runs& forces);

  /// The rigid body of each node that moves with one; reference nodes too. -1: none.
  int body_of(int node) const { return of_node_[std::size_t(node)]; }
  bool is_reference(int node) const { return is_reference_[std::size_t(node)]; }
  /// Lines below `bodies`.
  std::string text(DeckNames& names);

private:
  std::string one(std::size_t r, const Body* blocks, DeckNames& names);
  std::vector<Run> runs(const Runs& all, std::size_t r, int component) const;
  std::string motion(std::size_t r, const std::string& name);
  std::string hold(const Run& run, std::size_t component, const std::string& name);
  void add_density(FlowMap& map, const RigidBody& body) const;

  DeckParts parts_;
  const Runs& displacements_;
  const Runs& forces_;
  std::vector<int> of_node_;
  std::vector<bool> is_reference_;
};

/// The name of a set, or `otherwise` where a field names a single node or element by its number.
std::string name_of_set(const std::string& field, const std::string& otherwise);

/// Demands of *BOUNDARY and *CLOAD.
std::vector<Demand> demands_of(const std::vector<Condition>& conditions);

std::string materials_text(const DeckParts& parts, std::vector<std::string>& names);
/// `materials`: (sections) name of each in the deck.
std::string bodies_text(const DeckParts& parts, const std::vector<std::string>& materials,
                        RigidBodies& rigid);
std::string displacements_text(const DeckParts& parts, const Runs& runs, const RigidBodies& rigid);
std::string loads_text(const DeckParts& parts, const Runs& forces, const RigidBodies& rigid);
std::string contact_text(const DeckParts& parts);

} // namespace abut::abaqus
