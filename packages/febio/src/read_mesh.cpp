// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <unordered_map>

namespace abut::febio {

namespace {

/// How the nodes of a FEBio cell stand in abut's: abut's node i is FEBio's order[i].
struct CellWord {
  const char* word;
  fem::CellType cell;
  int order[27];
};
constexpr CellWord cell_words[] = {
    {"hex8", fem::CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7}},
    // Middles of the vertical edges come before those of the upper ones in Exodus II.
    {"hex20", fem::CellType::hex20, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                     10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
    // Then center, bottom, top, -x, +x, -y, +y; FEBio has -y, +x, +y, -x, bottom, top, center.
    {"hex27", fem::CellType::hex27, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                     18, 19, 12, 13, 14, 15, 26, 24, 25, 23, 21, 20, 22}},
    {"tet4", fem::CellType::tet4, {0, 1, 2, 3}},
    {"tet10", fem::CellType::tet10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
    {"penta6", fem::CellType::wedge6, {0, 1, 2, 3, 4, 5}},
};

/// Shells, which become a cell behind each face where they are rigid.
struct ShellWord {
  const char* word;
  fem::CellType cell;
  std::size_t corners;
};
constexpr ShellWord shell_words[] = {{"quad4", fem::CellType::hex8, 4},
                                     {"tri3", fem::CellType::wedge6, 3}};

struct FacetWord {
  const char* word;
  std::size_t nodes, corners;
};
constexpr FacetWord facet_words[] = {
    {"quad4", 4, 4}, {"quad8", 8, 4}, {"quad9", 9, 4}, {"tri3", 3, 3}, {"tri6", 6, 3}};

Global read_id(Element& e) {
  const std::string text = e.required_attribute("id");
  char* end = nullptr;
  const Global id = std::strtoll(text.c_str(), &end, 10);
  constexpr Global largest = 2000000000; // Exodus files hold 32 bits
  if (end != text.c_str() + text.size() || id < 1 || id > largest)
    e.fail("expected a whole number from 1 to 2000000000 as id, got '" + text + "'");
  return id;
}

class MeshReader {
public:
  explicit MeshReader(Model& model) : model_(model), mesh_(model.mesh) {}

  void read(Element section) {
    mesh_.line = section.line();
    for (Element part : section.children("Nodes"))
      nodes(part);
    for (Element part : section.children("Elements"))
      elements(part);
    for (Element part : section.children("NodeSet"))
      node_set(part);
    for (Element part : section.children("Surface"))
      surface(part);
    for (Element part : section.children("ElementSet"))
      element_set(part);
    for (Element part : section.children("Edge"))
      edge(part);
    for (Element part : section.children("SurfacePair"))
      pair(part);
    section.ignore("DiscreteSet", "for springs in <Discrete>, if there are any");
    if (mesh_.domains.empty())
      section.fail("expected an element <Elements> in it");
  }

private:
  void nodes(Element part) {
    const std::string name = part.attribute_or("name", "");
    NodeSet set{name, part.line(), {}};
    for (Element node : part.bulk()) {
      if (node.name() != "node")
        node.fail("expected <node>");
      const Global id = read_id(node);
      if (!node_line_.emplace(id, node.line()).second)
        node.fail("node " + std::to_string(id) + " is defined in line " +
                  std::to_string(node_line_[id]) + " already");
      const std::vector<double> x = node.numbers(3);
      mesh_.node_id.push_back(id);
      mesh_.x.insert(mesh_.x.end(), x.begin(), x.end());
      set.nodes.push_back(id);
    }
    if (name.empty())
      return;
    require_new_name(part, mesh_.node_sets, name);
    mesh_.node_sets.push_back(std::move(set));
  }

  void require_node(const Element& e, Global id) const {
    if (!node_line_.count(id))
      e.fail("there is no node " + std::to_string(id));
  }

  void elements(Element part) {
    Domain domain;
    domain.line = part.line();
    domain.name = part.required_attribute("name");
    part.attribute("mat"); // MeshDomains decides
    require_new_name(part, mesh_.domains, domain.name);
    const std::string type = part.required_attribute("type");
    const auto word = std::find_if(std::begin(cell_words), std::end(cell_words),
                                   [&](const CellWord& w) { return type == w.word; });
    const auto shell = std::find_if(std::begin(shell_words), std::end(shell_words),
                                    [&](const ShellWord& w) { return type == w.word; });
    const std::vector<Element> list = part.bulk();
    ElementSet set{domain.name, {}};
    if (shell != std::end(shell_words)) {
      domain.cell = shell->cell;
      domain.is_shell = true;
      const CellWord faces{shell->word, shell->cell, {0, 1, 2, 3}};
      for (Element e : list)
        set.elements.push_back(element(e, faces, shell->corners, domain));
    } else if (word == std::end(cell_words)) {
      part.refuse(unknown_cell(type));
    } else {
      domain.cell = word->cell;
      for (Element e : list)
        set.elements.push_back(
            element(e, *word, static_cast<std::size_t>(fem::info(word->cell).nodes), domain));
    }
    if (list.empty())
      part.fail("expected elements in it");
    mesh_.element_sets.push_back(std::move(set));
    mesh_.domains.push_back(std::move(domain));
  }

  static std::string unknown_cell(const std::string& type) {
    std::vector<std::string> valid;
    for (const CellWord& w : cell_words)
      valid.push_back(w.word);
    const bool shell = type.compare(0, 4, "quad") == 0 || type.compare(0, 3, "tri") == 0;
    return "elements of type '" + type + "'" +
           (shell ? " are shells, of which abut has rigid quad4 and tri3; " : "; ") +
           nearest_word_hint(type, valid.data(), valid.size());
  }

  Global element(Element e, const CellWord& word, std::size_t wanted, Domain& domain) {
    if (e.name() != "elem")
      e.fail("expected <elem>");
    const Global id = read_id(e);
    if (!element_line_.emplace(id, e.line()).second)
      e.fail("element " + std::to_string(id) + " is defined in line " +
             std::to_string(element_line_[id]) + " already");
    const std::vector<Global> nodes = e.integers();
    if (nodes.size() != wanted)
      e.fail("element " + std::to_string(id) + " of type " + word.word + " has " +
             std::to_string(nodes.size()) + " nodes, expected " + std::to_string(wanted));
    for (std::size_t a = 0; a < wanted; ++a) {
      require_node(e, nodes[a]);
      if (std::count(nodes.begin(), nodes.end(), nodes[a]) > 1)
        e.fail("element " + std::to_string(id) + " has node " + std::to_string(nodes[a]) +
               " more than once");
      domain.nodes.push_back(nodes[static_cast<std::size_t>(word.order[a])]);
    }
    domain.id.push_back(id);
    domain.lines.push_back(e.line());
    return id;
  }

  /// A list "1, 2, 5:9, 10:20:2"; or, as older files have it, an element <n id="1"/> for each.
  std::vector<Global> ids(Element part) {
    std::vector<Global> result;
    for (Element n : part.bulk())
      result.push_back(read_id(n));
    std::string text = part.text();
    for (char& c : text)
      if (c == ',' || c == '\n' || c == '\t' || c == '\r')
        c = ' ';
    for (std::size_t at = text.find_first_not_of(' '); at != std::string::npos;) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      range(part, text.substr(at, end - at), result);
      at = text.find_first_not_of(' ', end);
    }
    return result;
  }

  void range(const Element& part, const std::string& word, std::vector<Global>& result) const {
    Global numbers[3] = {0, 0, 1};
    int count = 0;
    const char* at = word.c_str();
    for (;;) {
      char* end = nullptr;
      const Global n = std::strtoll(at, &end, 10);
      if (end == at || count == 3 || (*end != ':' && *end != '\0'))
        part.fail("expected ids or ranges FIRST:LAST:STEP, got '" + word + "'");
      numbers[count++] = n;
      if (*end == '\0')
        break;
      at = end + 1;
    }
    if (count == 1)
      numbers[1] = numbers[0];
    if (numbers[2] < 1 || numbers[1] < numbers[0])
      part.fail("expected a range FIRST:LAST:STEP that grows, got '" + word + "'");
    const auto most = static_cast<Global>(node_line_.size() + element_line_.size());
    if (numbers[0] < 0 || (numbers[1] - numbers[0]) / numbers[2] > most)
      part.fail("the range '" + word + "' is longer than the mesh");
    result.push_back(numbers[0]);
    while (numbers[1] - result.back() >= numbers[2])
      result.push_back(result.back() + numbers[2]);
  }

  void node_set(Element part) {
    NodeSet set{part.required_attribute("name"), part.line(), {}};
    part.attribute("id");
    require_new_name(part, mesh_.node_sets, set.name);
    set.nodes = ids(part);
    for (const Global id : set.nodes)
      require_node(part, id);
    mesh_.node_sets.push_back(std::move(set));
  }

  void surface(Element part) {
    Surface surface{part.required_attribute("name"), part.line(), {}};
    part.attribute("id");
    require_new_name(part, mesh_.surfaces, surface.name);
    for (Element e : part.bulk()) {
      e.attribute("id");
      const auto word = std::find_if(std::begin(facet_words), std::end(facet_words),
                                     [&](const FacetWord& w) { return e.name() == w.word; });
      if (word == std::end(facet_words))
        e.fail("abut has no such face; it has quad4, quad8, quad9, tri3 and tri6");
      Facet facet{e.line(), e.integers(), word->corners};
      if (facet.nodes.size() != word->nodes)
        e.fail("expected " + std::to_string(word->nodes) + " nodes, got " +
               std::to_string(facet.nodes.size()));
      for (const Global id : facet.nodes)
        require_node(e, id);
      surface.facets.push_back(std::move(facet));
    }
    mesh_.surfaces.push_back(std::move(surface));
  }

  void element_set(Element part) {
    ElementSet set{part.required_attribute("name"), {}};
    part.attribute("id");
    set.elements = ids(part);
    for (const Global id : set.elements)
      if (!element_line_.count(id))
        part.fail("there is no element " + std::to_string(id));
    mesh_.element_sets.push_back(std::move(set));
  }

  /// As a place for boundary conditions an edge is a node set, "@edge:NAME".
  void edge(Element part) {
    NodeSet set{"@edge:" + part.required_attribute("name"), part.line(), {}};
    part.attribute("id");
    for (Element e : part.bulk()) {
      e.attribute("id");
      for (const Global id : e.integers()) {
        require_node(e, id);
        set.nodes.push_back(id);
      }
    }
    mesh_.node_sets.push_back(std::move(set));
  }

  void pair(Element part) {
    SurfacePair pair;
    pair.name = part.required_attribute("name");
    pair.line = part.line();
    require_new_name(part, mesh_.pairs, pair.name);
    for (const auto& [key, target] :
         {std::pair<const char*, std::string*>{"primary", &pair.primary},
          {"secondary", &pair.secondary}}) {
      const Element side = part.required_child(key);
      *target = side.text();
      const auto same = [&](const Surface& s) { return s.name == *target; };
      if (std::none_of(mesh_.surfaces.begin(), mesh_.surfaces.end(), same))
        side.fail("there is no surface '" + *target + "'");
    }
    mesh_.pairs.push_back(std::move(pair));
  }

  Model& model_;
  Mesh& mesh_;
  std::unordered_map<Global, int> node_line_, element_line_;
};

} // namespace

void read_mesh(Element section, Model& model) {
  MeshReader(model).read(section);
}

namespace {

Domain& find_domain(Element part, Model& model) {
  const std::string name = part.required_attribute("name");
  for (Domain& d : model.mesh.domains)
    if (d.name == name) {
      if (!d.material.empty())
        part.fail("'" + name + "' has its material '" + d.material + "' already");
      return d;
    }
  part.fail("there is no <Elements> '" + name + "'");
}

const Material& find_material(Element part, const Model& model) {
  const std::string name = part.required_attribute("mat");
  if (const Material* found = model.material(name))
    return *found;
  std::vector<std::string> names;
  for (const Material& m : model.materials)
    names.push_back(m.name);
  part.fail("there is no material '" + name + "'; " +
            nearest_word_hint(name, names.data(), names.size()));
}

/// Beams and shells that bend are refused; rigid shells are solids behind their faces.
void read_structures(Element section, Model& model) {
  for (Element part : section.children("BeamDomain")) {
    find_domain(part, model).material = part.required_attribute("mat");
    part.refuse("abut has solid elements alone");
  }
  for (Element part : section.children("ShellDomain")) {
    Domain& domain = find_domain(part, model);
    const Material& material = find_material(part, model);
    domain.material = material.name;
    part.attribute("type");
    domain.thickness = part.number_or("shell_thickness", 0.0);
    part.ignore("shell_normal_nodal", "the shell is rigid");
    if (!material.is_rigid())
      part.refuse("abut has shells of rigid material alone: extrude it to hex8, hex20 or penta6, "
                  "several across the thickness where it bends");
    else if (domain.is_shell)
      part.note("each face has a rigid cell behind it");
  }
}

} // namespace

void read_mesh_domains(Element section, Model& model) {
  read_structures(section, model);
  for (Element part : section.children("SolidDomain")) {
    Domain& domain = find_domain(part, model);
    const Material& material = find_material(part, model);
    domain.material = material.name;
    if (domain.is_shell && !material.is_rigid())
      part.refuse("its elements are shells: expected <ShellDomain>");
    const std::string type = part.attribute_or("type", "");
    const bool uncoupled = material.numbers.count("k") > 0;
    const bool rigid = material.is_rigid() && type == "rigid-solid";
    if (!type.empty() && !rigid && type != (uncoupled ? "three-field-solid" : "elastic-solid"))
      part.refuse("type '" + type +
                  "': abut takes displacement elements, and for uncoupled "
                  "materials in hex8 those with a mean dilatation");
    const std::string rule = part.attribute_or("elem_type", "");
    if (!rule.empty())
      part.refuse("elem_type '" + rule + "': abut has one integration rule for each cell");
  }
  for (const Domain& d : model.mesh.domains)
    if (d.material.empty())
      section.fail("expected a <SolidDomain> for <Elements> '" + d.name + "' in line " +
                   std::to_string(d.line));
  extrude_rigid_shells(model);
}

} // namespace abut::febio
