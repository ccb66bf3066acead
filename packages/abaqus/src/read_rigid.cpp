// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

namespace abut::abaqus {

namespace {

void append(std::vector<int>& list, const std::vector<int>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

} // namespace

void read_rigid_body(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  RigidBody body;
  body.place = card.place();
  const DataLine here{card.place(), {}};
  for (const char* key : {"ELSET", "NSET", "TIE NSET", "PIN NSET"})
    if (const auto set = card.parameter(key)) {
      if (body.name.empty())
        body.name = scope.spelled + name_of(card, *set);
      append(std::string(key) == "ELSET" ? body.elements : body.nodes,
             std::string(key) == "ELSET" ? lookup.elements(card, here, *set, scope)
                                         : lookup.nodes(card, here, *set, scope));
    }
  body.reference = lookup.node(card, card.required("REF NODE"), scope);
  if (const auto rotation = card.parameter("ROT NODE"))
    body.rotation = lookup.node(card, *rotation, scope);
  if (card.has("ANALYTICAL SURFACE"))
    card.refuse("ANALYTICAL SURFACE: mesh it with R3D4 or R3D3");
  if (card.word("POSITION", {"INPUT", "CENTER OF MASS"}, "INPUT") != "INPUT")
    card.refuse("POSITION=CENTER OF MASS: put the reference node there");
  card.ignore({"ISOTHERMAL"}, "abut has no temperature");
  card.lines.clear(); // thickness of facets
  if (body.elements.empty() && body.nodes.empty())
    card.fail("expected ELSET, NSET, TIE NSET or PIN NSET");
  lookup.model().rigid_bodies.push_back(std::move(body));
}

void read_coupling(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  RigidBody body;
  body.place = card.place();
  body.reference = lookup.node(card, card.required("REF NODE"), scope);
  const std::string surface_name = card.required("SURFACE");
  const Surface& surface = lookup.surface(card, card.place(), surface_name, scope);
  body.name = card.parameter("CONSTRAINT NAME").value_or(surface_name);
  for (const char* other : {"INFLUENCE RADIUS", "ORIENTATION"})
    if (card.has(other))
      card.refuse(std::string(other) + ": abut couples all nodes of the surface, along x, y and z");
  body.nodes = surface.nodes;
  const Model& model = lookup.model();
  for (const Face& f : surface.faces) {
    const Element& e = model.elements[std::size_t(f.element)];
    if (!e.type->cell) {
      append(body.nodes, {model.nodes_of(e), model.nodes_of(e) + e.type->nodes});
      continue;
    }
    if (f.face < 0) {
      card.refuse("its surface has no faces S1, S2, ...: abut needs them here");
      break;
    }
    const fem::CellSide& side = fem::side(*e.type->cell, exodus_side(*e.type->cell, f.face));
    for (int a = 0; a < fem::face_nodes(side.type); ++a)
      body.nodes.push_back(
          model.nodes_of(e)[e.type->order ? e.type->order[side.nodes[a]] : side.nodes[a]]);
  }
  lookup.model().rigid_bodies.push_back(std::move(body));
}

void read_kinematic(Card& card, RigidBody* coupling) {
  card.use();
  if (!coupling)
    card.fail("expected below a *COUPLING");
  bool held[3] = {card.lines.empty(), card.lines.empty(), card.lines.empty()};
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    const Global first = card.whole(line, fields[0], "a component");
    const Global last = fields.size() > 1 && !fields[1].empty()
                            ? card.whole(line, fields[1], "a component")
                            : first;
    if (first < 1 || last > 6 || last < first)
      card.fail(line.place, "expected components from 1 to 6");
    for (Global i = first; i <= last && i <= 3; ++i)
      held[i - 1] = true;
  }
  if (!(held[0] && held[1] && held[2]))
    card.refuse("abut couples all of x, y and z: nodes that move with a rigid body");
}

} // namespace abut::abaqus
