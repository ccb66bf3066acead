// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut::abaqus {

namespace {

// The two sides of a pair, in the words of the files.
constexpr const char* main_side = "MAS"
                                  "TER";
constexpr const char* other_side = "SLA"
                                   "VE";

constexpr const char* exponential =
    "EXPONENTIAL: abut has no pressure over an open gap; give LINEAR with the slope that the law "
    "has "
    "where the pressure is that of your model, or leave PRESSURE-OVERCLOSURE out for hard contact";
constexpr const char* bent =
    "TABULAR: abut's pressure is linear in the overclosure; give two lines";

std::array<double, 2> pair_of(const Card& card, const DataLine& line) {
  const auto fields = line.fields();
  return {card.number(line, fields, 0, "a number"), card.number(line, fields, 1, "a number")};
}

void read_table(Card& card, Interaction& interaction) {
  std::vector<std::array<double, 2>> points; // pressure, overclosure
  for (const DataLine& line : card.lines)
    points.push_back(pair_of(card, line));
  if (points.size() != 2 || points[0][0] != 0.0) {
    card.refuse(bent);
    return;
  }
  if (!(points[1][1] > points[0][1] && points[1][0] > 0.0))
    card.fail("expected a pressure that grows with the overclosure");
  interaction.normal = Interaction::Normal::linear;
  interaction.stiffness = points[1][0] / (points[1][1] - points[0][1]);
  interaction.clearance = -points[0][1];
}

} // namespace

void read_interaction(Card& card, Model& model) {
  card.use();
  Interaction interaction;
  interaction.name = name_of(card, card.required("NAME"));
  interaction.place = card.place();
  require_new(card, model.interactions, interaction.name);
  card.ignore({"UNSYMM"}, "abut takes the exact tangent");
  model.interactions.emplace(key_of(interaction.name), std::move(interaction));
}

void read_behavior(Card& card, Interaction* interaction) {
  card.use();
  if (!interaction)
    card.fail("expected below a *SURFACE INTERACTION");
  using Normal = Interaction::Normal;
  const std::string law = card.word(
      "PRESSURE-OVERCLOSURE",
      {"HARD", "LINEAR", "EXPONENTIAL", "TABULAR", "TIED", "SCALE FACTOR", "QUADRATIC"}, "HARD");
  interaction->no_separation = card.has("NO SEPARATION");
  for (const char* method : {"AUGMENTED LAGRANGE", "DIRECT", "PENALTY"})
    if (card.has(method))
      card.note(std::string(method) + ": abut holds hard contact by multipliers");
  if (law == "HARD") {
    interaction->normal = Normal::hard;
  } else if (law == "LINEAR" || law == "TIED") {
    if (card.lines.empty())
      card.fail("expected a line with the slope, pressure over overclosure");
    const auto fields = card.lines[0].fields();
    interaction->stiffness = card.number(card.lines[0], fields, 0, "the slope");
    if (!(interaction->stiffness > 0.0))
      card.fail(card.lines[0].place, "expected a slope > 0");
    interaction->normal = law == "TIED" ? Normal::tied : Normal::linear;
    if (fields.size() > 1)
      card.note("CalculiX's tension at large clearances and its c0 are left out: abut has no pull "
                "over an open gap");
  } else if (law == "TABULAR") {
    read_table(card, *interaction);
  } else if (law == "EXPONENTIAL") {
    card.refuse(exponential);
  } else if (!law.empty()) {
    card.refuse(law + ": abut has HARD and LINEAR");
  }
}

void read_friction(Card& card, Interaction* interaction, FrictionChange* change) {
  card.use();
  if (!interaction && !change)
    card.fail("expected below a *SURFACE INTERACTION or *CHANGE FRICTION");
  card.ignore({"ELASTIC SLIP", "SLIP TOLERANCE", "LAGRANGE"},
              "abut sticks with the stiffness of the normal direction, or by multipliers");
  for (const char* other : {"ROUGH", "TAUMAX", "ANISOTROPIC", "EXPONENTIAL DECAY", "DEPENDENCIES",
                            "USER", "SHEAR TRACTION SLOPE"})
    if (card.has(other))
      card.refuse(std::string(other) +
                  ": abut has Coulomb's law with one coefficient; surfaces that "
                  "never slide are tied");
  if (card.lines.empty())
    card.fail("expected a line with the coefficient");
  if (card.lines.size() > 1)
    card.refuse("it depends on slip rate, pressure or temperature: abut has one coefficient");
  const auto fields = card.lines[0].fields();
  const double mu = card.number(card.lines[0], fields, 0, "the coefficient");
  if (!(mu >= 0.0))
    card.fail(card.lines[0].place, "expected a coefficient >= 0");
  if (change) {
    change->friction = mu;
    return;
  }
  interaction->friction = mu;
  interaction->stick_slope = card.number(card.lines[0], fields, 1, "the stick slope", 0.0);
}

namespace {

std::string pair_name(const Surface& a, const Surface& b) {
  return a.name == b.name ? a.name + "_on_itself" : a.name + "_on_" + b.name;
}

void read_adjust(Card& card, Pair& pair, Lookup& lookup, const Scope& scope) {
  const auto adjust = card.parameter("ADJUST");
  if (!adjust)
    return;
  const std::string key = key_of(*adjust);
  const bool number = !key.empty() && key.find_first_not_of("0123456789.+-ED") == std::string::npos;
  if (number) {
    pair.adjust = card.number({card.place(), {}}, *adjust, "a distance");
    if (!(*pair.adjust >= 0.0))
      card.fail("expected ADJUST >= 0");
    card.note("ADJUST: abut moves no nodes but counts the gaps as closed; the same but for the "
              "shape of the elements");
    return;
  }
  lookup.nodes(card, {card.place(), {}}, *adjust, scope);
  card.refuse("ADJUST by a node set: abut closes gaps up to a distance; give that");
}

} // namespace

void read_pairs(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  Pair pair;
  pair.place = card.place();
  pair.interaction = card.parameter("INTERACTION").value_or("");
  const std::string type = card.word(
      "TYPE",
      {"NODE TO SURFACE", "SURFACE TO SURFACE", "MORTAR", "LINMORTAR", "PGLINMORTAR", "MASSLESS"},
      "NODE TO SURFACE");
  pair.nodal = type == "NODE TO SURFACE";
  pair.mortar = type == "MORTAR" || type == "LINMORTAR" || type == "PGLINMORTAR";
  if (type == "MASSLESS")
    card.refuse("TYPE=MASSLESS: abut has no massless contact");
  if (!card.has("TYPE"))
    card.note("no TYPE: node to surface, as in Abaqus");
  card.ignore({"SMALL SLIDING"}, "abut follows the sliding, also where it is small");
  card.ignore({"NO THICKNESS", "SMOOTH", "TRACKING", "EXTENSION ZONE", "CPSET", "HCRIT",
               "MINIMUM DISTANCE", "GEOMETRIC CORRECTION", "SUPPLEMENTARY CONSTRAINTS"},
              "abut's search and faces are its own");
  if (card.has("TIED")) {
    pair.tied = true;
    pair.keeps_gap = true;
  }
  read_adjust(card, pair, lookup, scope);
  if (card.lines.empty())
    card.fail("expected a line with two surfaces");
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    Pair p = pair;
    p.place = line.place;
    p.first = lookup.surface_key(card, line.place, fields[0], scope);
    p.second = fields.size() > 1 && !fields[1].empty()
                   ? lookup.surface_key(card, line.place, fields[1], scope)
                   : p.first;
    const auto& surfaces = lookup.model().surfaces;
    p.name = pair_name(surfaces.at(p.first), surfaces.at(p.second));
    lookup.model().pairs.push_back(std::move(p));
  }
}

void read_tie(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  Pair pair;
  pair.tied = true;
  pair.name = card.parameter("NAME").value_or("");
  for (const char* kind : {"CYCLIC SYMMETRY", "MULTISTAGE", "FLUIDPERIODIC", "FLUIDCYCLIC"})
    if (card.has(kind)) {
      card.refuse(std::string(kind) + ": abut ties surfaces that lie on each other");
      return;
    }
  if (card.has("TIED NSET"))
    card.refuse("TIED NSET: give a surface of the nodes");
  pair.tolerance = card.number_parameter("POSITION TOLERANCE");
  card.parameter("POSITION TOLERANCE");
  if (card.word("ADJUST", {"YES", "NO"}, "YES") == "YES")
    card.note("abut moves no nodes on the other surface: their distance strains nothing");
  const std::string type =
      card.word("TYPE", {"NODE TO SURFACE", "SURFACE TO SURFACE"}, "SURFACE TO SURFACE");
  pair.nodal = type == "NODE TO SURFACE";
  card.ignore({"NO ROTATION", "NO THICKNESS", "CONSTRAINT RATIO"}, "abut has no shells");
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    if (fields.size() < 2)
      card.fail(line.place, "expected two surfaces");
    Pair p = pair;
    p.place = line.place;
    p.first = lookup.surface_key(card, line.place, fields[0], scope);
    p.second = lookup.surface_key(card, line.place, fields[1], scope);
    const auto& surfaces = lookup.model().surfaces;
    if (p.name.empty())
      p.name = pair_name(surfaces.at(p.first), surfaces.at(p.second));
    lookup.model().pairs.push_back(std::move(p));
  }
}

namespace {

Pair& find_pair(const Card& card, const Place& at, const std::string& first,
                const std::string& second, const Scope& scope, Lookup& lookup) {
  const std::string a = lookup.surface_key(card, at, first, scope),
                    b = lookup.surface_key(card, at, second, scope);
  auto& pairs = lookup.model().pairs;
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const Pair& p) {
    return !p.tied && p.first == a && p.second == b;
  });
  if (found == pairs.end())
    card.fail(at, "there is no *CONTACT PAIR of '" + first + "' and '" + second + "'");
  return *found;
}

} // namespace

void read_clearance(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  const std::string main = card.required(main_side), other = card.required(other_side);
  for (const char* word : {"TABULAR", "BOLT"})
    if (card.has(word)) {
      card.refuse(std::string(word) + ": abut takes one VALUE for all nodes");
      return;
    }
  if (card.has("CPSET"))
    card.refuse("CPSET: name the two surfaces");
  const auto value = card.number_parameter("VALUE");
  if (!value)
    card.fail("expected the parameter VALUE=...");
  find_pair(card, card.place(), other, main, scope, lookup).clearance = *value;
}

void read_model_change(Card& card, const Scope& scope, int step, Lookup& lookup) {
  card.use();
  if (card.word("TYPE", {"CONTACT PAIR", "ELEMENT"}, "ELEMENT") != "CONTACT PAIR") {
    card.refuse("abut takes pairs out and in alone: TYPE=CONTACT PAIR");
    return;
  }
  const bool off = card.has("REMOVE");
  if (off == card.has("ADD"))
    card.fail("expected ADD or REMOVE");
  if (step < 0)
    card.fail("expected within a *STEP");
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    if (fields.size() < 2)
      card.fail(line.place, "expected two surfaces");
    Pair& pair = find_pair(card, line.place, fields[0], fields[1], scope, lookup);
    const auto now = static_cast<std::size_t>(step);
    pair.is_off.resize(now, !pair.is_off.empty() && pair.is_off.back());
    pair.is_off.resize(now + 1, off);
    pair.is_off[now] = off;
  }
}

} // namespace abut::abaqus
