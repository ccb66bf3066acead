// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

/// Elements that abut lacks: they are known, so that sets may name them.
const ElementType lacking = {"", 0, {}, nullptr, nullptr, nullptr};

/// Adds what is not in the set yet; sets of one name grow.
void add(std::map<std::string, Set>& sets, const Card& card, const Scope& scope,
         const std::string& name, const std::vector<int>& members) {
  const std::string spelled = scope.spelled + name_of(card, name);
  const auto [at, is_new] = sets.emplace(key_of(spelled), Set{spelled, card.place(), {}});
  std::vector<int>& list = at->second.members;
  if (is_new && members.size() == 1) {
    list = members;
    return;
  }
  std::set<int> known(list.begin(), list.end());
  for (const int m : members)
    if (known.insert(m).second)
      list.push_back(m);
}

/// The fields of one element, which goes on behind a comma.
std::vector<std::string> element_fields(const Card& card, std::size_t& at, std::size_t wanted) {
  std::vector<std::string> fields = card.lines[at].fields();
  const auto goes_on = [&] {
    return wanted > 0 ? fields.size() < wanted
                      : !card.lines[at].text.empty() && card.lines[at].text.back() == ',';
  };
  while (goes_on() && at + 1 < card.lines.size()) {
    const auto more = card.lines[++at].fields();
    fields.insert(fields.end(), more.begin(), more.end());
  }
  return fields;
}

std::string unknown_type(const std::string& type) {
  static const std::string valid[] = {"C3D4",  "C3D6",  "C3D8",   "C3D8I", "C3D8R",
                                      "C3D10", "C3D20", "C3D20R", "R3D3",  "R3D4"};
  return "abut has no elements of type '" + type + "'; " +
         nearest_word_hint(key_of(type), valid, std::size(valid));
}

} // namespace

void read_nodes(Card& card, Scope& scope, Model& model) {
  card.use();
  const auto set = card.parameter("NSET");
  if (card.word("SYSTEM", {"R", "C", "S"}, "R") != "R")
    card.refuse("abut takes rectangular coordinates: SYSTEM=R");
  std::vector<int> members;
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    Node node;
    node.label = card.whole(line, fields[0], "a node number");
    node.place = line.place;
    if (node.label < 1)
      card.fail(line.place, "expected a node number from 1 on");
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = card.number(line, fields, i + 1, "a coordinate", 0.0);
    for (std::size_t i = 0; i < 3; ++i)
      node.x[i] = scope.shift[i] + scope.turn[i][0] * x[0] + scope.turn[i][1] * x[1] +
                  scope.turn[i][2] * x[2];
    const auto [at, is_new] = scope.nodes.emplace(node.label, static_cast<int>(model.nodes.size()));
    if (is_new)
      model.nodes.push_back(node);
    else if (model.nodes[std::size_t(at->second)].x != node.x)
      card.fail(line.place, "node " + std::to_string(node.label) + " is in line " +
                                std::to_string(model.nodes[std::size_t(at->second)].place.line) +
                                " already, elsewhere");
    members.push_back(at->second);
  }
  if (set)
    add(model.node_sets, card, scope, *set, members);
}

void read_elements(Card& card, Scope& scope, Model& model) {
  card.use();
  const std::string type_name = card.required("TYPE");
  const auto set = card.parameter("ELSET");
  const ElementType* type = element_type(type_name);
  if (!type || type->nodes == 0) {
    card.refuse(type ? type->note : unknown_type(type_name));
    type = &lacking;
  } else if (type->note) {
    card.note(type_name + ": " + type->note);
  }
  const auto count = static_cast<std::size_t>(type->nodes);
  std::vector<int> members;
  for (std::size_t at = 0; at < card.lines.size(); ++at) {
    const DataLine& line = card.lines[at];
    const auto fields = element_fields(card, at, count == 0 ? 0 : count + 1);
    Element e;
    e.label = card.whole(line, fields[0], "an element number");
    e.place = line.place;
    e.type = type;
    e.first = model.element_nodes.size();
    if (e.label < 1)
      card.fail(line.place, "expected an element number from 1 on");
    if (count > 0 && fields.size() != count + 1)
      card.fail(line.place, "element " + std::to_string(e.label) + " has " +
                                std::to_string(fields.size() - 1) + " nodes, expected " +
                                std::to_string(count));
    for (std::size_t a = 1; a <= count; ++a) {
      const auto found = scope.nodes.find(card.whole(line, fields[a], "a node number"));
      if (found == scope.nodes.end())
        card.fail(line.place, "there is no node " + fields[a]);
      model.element_nodes.push_back(found->second);
    }
    const auto first = model.element_nodes.begin() + static_cast<std::ptrdiff_t>(e.first);
    for (auto n = first; n != model.element_nodes.end(); ++n)
      if (std::find(first, n, *n) != n)
        card.fail(line.place, "element " + std::to_string(e.label) + " has node " +
                                  std::to_string(model.nodes[std::size_t(*n)].label) + " twice");
    const auto [old, is_new] =
        scope.elements.emplace(e.label, static_cast<int>(model.elements.size()));
    if (!is_new)
      card.fail(line.place,
                "element " + std::to_string(e.label) + " is in line " +
                    std::to_string(model.elements[std::size_t(old->second)].place.line) +
                    " already");
    members.push_back(old->second);
    model.elements.push_back(e);
  }
  if (set)
    add(model.element_sets, card, scope, *set, members);
}

namespace {

/// FIRST, LAST, STEP; numbers of nothing in between are left out.
void generate(const Card& card, const DataLine& line,
              const std::unordered_map<Global, int>& numbers, std::vector<int>& members) {
  const auto fields = line.fields();
  const Global first = card.whole(line, fields[0], "a number");
  const Global last = fields.size() > 1 ? card.whole(line, fields[1], "a number") : first;
  const Global step =
      fields.size() > 2 && !fields[2].empty() ? card.whole(line, fields[2], "an increment") : 1;
  if (step < 1 || last < first)
    card.fail(line.place, "expected FIRST, LAST and an increment, growing");
  std::vector<Global> labels;
  if ((last - first) / step < static_cast<Global>(numbers.size())) {
    for (Global n = first; n <= last; n += step)
      if (numbers.count(n))
        labels.push_back(n);
  } else {
    for (const auto& entry : numbers)
      if (entry.first >= first && entry.first <= last && (entry.first - first) % step == 0)
        labels.push_back(entry.first);
    std::sort(labels.begin(), labels.end());
  }
  for (const Global n : labels)
    members.push_back(numbers.at(n));
}

} // namespace

void read_set(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  const bool of_nodes = card.is("NSET");
  Model& model = lookup.model();
  const std::string name = card.required(of_nodes ? "NSET" : "ELSET");
  const bool generates = card.has("GENERATE");
  card.ignore({"INTERNAL", "UNSORTED"}, "");
  card.ignore({"FREQUENCY"}, "a set has none");
  const auto instance = card.parameter("INSTANCE");
  const Scope& from = instance ? lookup.instance(card, *instance) : scope;
  std::vector<int> members;
  if (const auto elements = of_nodes ? card.parameter("ELSET") : std::nullopt)
    for (const int e : lookup.elements(card, {card.place(), {}}, *elements, from)) {
      const Element& element = model.elements[std::size_t(e)];
      members.insert(members.end(), model.nodes_of(element),
                     model.nodes_of(element) + element.type->nodes);
    }
  for (const DataLine& line : card.lines) {
    if (generates) {
      generate(card, line, of_nodes ? from.nodes : from.elements, members);
      continue;
    }
    for (const std::string& field : line.fields()) {
      if (field.empty())
        continue;
      const auto list = of_nodes ? lookup.nodes(card, line, field, from)
                                 : lookup.elements(card, line, field, from);
      members.insert(members.end(), list.begin(), list.end());
    }
  }
  add(of_nodes ? model.node_sets : model.element_sets, card, scope, name, members);
}

namespace {

/// S1, S2, ... or SPOS, SNEG; nothing: all faces that no other element has.
int face_of(const Card& card, const DataLine& line, const std::string& word) {
  const std::string key = key_of(word);
  if (key.empty())
    return Face::outer;
  if (key == "SPOS")
    return Face::positive;
  if (key == "SNEG")
    return Face::negative;
  if (key.size() == 2 && key[0] == 'S' && key[1] >= '1' && key[1] <= '6')
    return key[1] - '1';
  card.fail(line.place, "expected a face S1 to S6, SPOS or SNEG, got '" + key.substr(0, 40) + "'");
}

} // namespace

void add_faces(const Card& card, const DataLine& line, const std::vector<int>& elements, int face,
               const Model& model, std::vector<Face>& faces) {
  for (const int e : elements) {
    const Element& element = model.elements[std::size_t(e)];
    const ElementType& type = *element.type;
    const bool exists =
        type.nodes == 0 ||
        (type.cell ? face == Face::outer || exodus_side(*type.cell, face) >= 0 : face < 0);
    if (!exists)
      card.fail(line.place, "element " + std::to_string(element.label) + " of type " + type.name +
                                " has no such face");
    faces.push_back({e, type.is_facet() && face == Face::outer ? Face::positive : face});
  }
}

void read_surface(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  Model& model = lookup.model();
  Surface surface;
  surface.name = scope.spelled + name_of(card, card.required("NAME"));
  surface.place = card.place();
  const std::string type = card.word("TYPE", {"ELEMENT", "NODE"}, "ELEMENT");
  surface.of_nodes = type == "NODE";
  card.ignore({"INTERNAL"}, "");
  if (type.empty()) { // refused; what names it shall still find it
    model.surfaces.emplace(key_of(surface.name), std::move(surface));
    return;
  }
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    if (surface.of_nodes) {
      const auto list = lookup.nodes(card, line, fields[0], scope);
      surface.nodes.insert(surface.nodes.end(), list.begin(), list.end());
      continue;
    }
    const int face = face_of(card, line, fields.size() > 1 ? fields[1] : "");
    add_faces(card, line, lookup.elements(card, line, fields[0], scope), face, model,
              surface.faces);
  }
  if (surface.faces.empty() && surface.nodes.empty())
    card.fail("the surface has no faces");
  const std::string key = key_of(surface.name);
  if (const auto found = model.surfaces.find(key); found != model.surfaces.end())
    card.refuse("there is a surface of this name in line " +
                std::to_string(found->second.place.line) + " already");
  model.surfaces.emplace(key, std::move(surface));
}

void read_section(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  Section section;
  const std::string set = card.required("ELSET");
  section.material = card.required("MATERIAL");
  section.place = card.place();
  section.elements = lookup.elements(card, {card.place(), {}}, set, scope);
  section.set = scope.spelled + set;
  card.ignore({"CONTROLS"}, "settings of elements");
  if (card.has("ORIENTATION"))
    card.refuse("ORIENTATION: abut has no directions in materials");
  lookup.model().sections.push_back(std::move(section));
}

} // namespace abut::abaqus
