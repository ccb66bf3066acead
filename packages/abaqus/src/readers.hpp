// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "card.hpp"

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

/// Readers of cards, each into the model. All throw InputError as read_model does.
namespace abut::abaqus {

/// Where numbers and names are looked up: the whole file, or an instance of a part.
struct Scope {
  std::string prefix;  ///< of keys: "INSTANCE."; empty for the whole file
  std::string spelled; ///< "Instance."
  std::array<std::array<double, 3>, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> shift{};
  std::unordered_map<Global, int> nodes, elements; ///< index of a number
};

/// A card in a scope, within a step or before all of them (-1).
struct Item {
  Card* card;
  Scope* scope;
  int step;
};

/// What the cards mean, apart from the bulk of the mesh.
class Lookup {
public:
  Lookup(Model& model, std::vector<Scope*> scopes) : model_(model), scopes_(std::move(scopes)) {}

  Model& model() { return model_; }
  /// Nodes or elements that a field names: a number, a set, or either of an instance, INSTANCE.X.
  std::vector<int> nodes(const Card& card, const DataLine& line, const std::string& field,
                         const Scope& scope) const;
  std::vector<int> elements(const Card& card, const DataLine& line, const std::string& field,
                            const Scope& scope) const;
  /// The only node that a field names.
  int node(const Card& card, const std::string& field, const Scope& scope) const;
  const Scope& instance(const Card& card, const std::string& name) const;
  const Surface& surface(const Card& card, const Place& at, const std::string& name,
                         const Scope& scope) const;
  std::string surface_key(const Card& card, const Place& at, const std::string& name,
                          const Scope& scope) const;

private:
  std::vector<int> members(const Card& card, const DataLine& line, const std::string& field,
                           const Scope& scope, bool of_nodes) const;

  Model& model_;
  std::vector<Scope*> scopes_;
};

/// The cards in the order in which they count, those of parts for each of their instances.
/// Structure alone (*PART, *INSTANCE, *STEP, ...) is used up here.
class Structure {
public:
  explicit Structure(Cards& cards);
  std::vector<Item> items;
  std::vector<Card*> steps;                   ///< their *STEP
  std::vector<std::unique_ptr<Scope>> scopes; ///< the first: the whole file

private:
  void card(std::size_t& at);
  void part(std::size_t& at);
  void instance(Card& card);
  std::vector<Card>& cards_;
  std::unordered_map<std::string, std::vector<std::size_t>> parts_; ///< their cards
  std::unordered_map<std::string, bool> placed_;
  Scope* scope_ = nullptr;
  const Card* open_step_ = nullptr;
  bool in_assembly_ = false;
};

const ElementType* element_type(const std::string& name); ///< nullptr: unknown
/// Side of Exodus II (0-based) for a face of Abaqus (0-based); -1 when the cell has none.
int exodus_side(fem::CellType cell, int face);

void read_nodes(Card& card, Scope& scope, Model& model);
void read_elements(Card& card, Scope& scope, Model& model);
void read_set(Card& card, const Scope& scope, Lookup& lookup);
void read_surface(Card& card, const Scope& scope, Lookup& lookup);
/// Adds a face (0-based, or a word of Face) of each element.
void add_faces(const Card& card, const DataLine& line, const std::vector<int>& elements, int face,
               const Model& model, std::vector<Face>& faces);
void read_section(Card& card, const Scope& scope, Lookup& lookup);
void read_rigid_body(Card& card, const Scope& scope, Lookup& lookup);
void read_coupling(Card& card, const Scope& scope, Lookup& lookup);
void read_kinematic(Card& card, RigidBody* coupling);

/// Cards below *MATERIAL.
void read_material(Card& card, Model& model);
void read_material_part(Card& card, Material* material);

void read_interaction(Card& card, Model& model);
void read_behavior(Card& card, Interaction* interaction);
void read_friction(Card& card, Interaction* interaction, FrictionChange* change);
void read_pairs(Card& card, const Scope& scope, Lookup& lookup);
void read_tie(Card& card, const Scope& scope, Lookup& lookup);
void read_clearance(Card& card, const Scope& scope, Lookup& lookup);
void read_model_change(Card& card, const Scope& scope, int step, Lookup& lookup);

void read_step(Card& card, Model& model);
void read_static(Card& card, Step& step);
void read_dynamic(Card& card, Step& step);
void read_amplitude(Card& card, Model& model);
void read_boundary(Card& card, const Scope& scope, int step, Lookup& lookup);
void read_forces(Card& card, const Scope& scope, int step, Lookup& lookup);
void read_loads(Card& card, const Scope& scope, int step, Lookup& lookup);
void read_initial(Card& card, const Scope& scope, Lookup& lookup);

/// Throws when a key of a map is taken.
template <class Map> void require_new(const Card& card, const Map& map, const std::string& name) {
  const auto found = map.find(key_of(name));
  if (found != map.end())
    card.fail("the name '" + name + "' is taken by line " +
              std::to_string(found->second.place.line));
}

/// A name for the model: at most so long as Abaqus and CalculiX take.
std::string name_of(const Card& card, const std::string& value);

} // namespace abut::abaqus
