// SPDX-License-Identifier: BSD-3-Clause
#include "versions.hpp"

#include <cstring>

namespace abut::febio {

namespace {

/// Since 3.0 elements have their material from <MeshDomains>, and all that is named has a name.
class Translation {
public:
  Translation(Tree& tree, pugi::xml_node geometry)
      : tree_(tree), root_(tree.root()), geometry_(geometry), names_(geometry, "Elements") {}

  void run() {
    tree_.rename(geometry_, "Mesh");
    for (pugi::xml_node elements : child_elements(geometry_, "Elements"))
      domain(elements);
    for (pugi::xml_node pair : child_elements(geometry_, "SurfacePair"))
      sides(pair);
    for (pugi::xml_node set : child_elements(geometry_, "NodeSet"))
      expand(set);
    for (pugi::xml_node set : child_elements(geometry_, "DiscreteSet"))
      tree_.settle(set, Fate::ignored, "for springs in <Discrete>, if there are any");
    thickness();
  }

private:
  /// Two of one name are told apart; who names them means the first one.
  void domain(pugi::xml_node elements) {
    pugi::xml_attribute name = elements.attribute("name");
    if (!name)
      name = elements.append_attribute("name");
    const std::string given = trimmed(name.value());
    const bool repeated = !given.empty() && !seen_.insert(given).second;
    if (given.empty() || repeated)
      name.set_value(names_.make(given.empty() ? "Part" : given).c_str());
    const auto material = take_attribute(elements, "mat");
    if (!material)
      tree_.fail(elements, "expected an attribute 'mat'");
    const std::string type = trimmed(elements.attribute("type").value());
    const auto begins = [&](const char* word) {
      return type.compare(0, std::strlen(word), word) == 0;
    };
    const bool shell = begins("quad") || begins("tri"), beam = begins("line") || begins("truss");
    const pugi::xml_node domains = tree_.child(root_, "MeshDomains", geometry_);
    pugi::xml_node domain = tree_.append(
        domains, shell ? "ShellDomain" : (beam ? "BeamDomain" : "SolidDomain"), elements);
    tree_.stand_for(domain, elements);
    domain.append_attribute("name").set_value(name.value());
    domain.append_attribute("mat").set_value(name_of_material(*material).c_str());
    if (trimmed(elements.attribute("active").value()) == "true")
      elements.remove_attribute("active");
  }

  /// Materials by name, or else by number.
  std::string name_of_material(const std::string& text) const {
    const pugi::xml_node materials = root_.child("Material");
    if (materials.find_child_by_attribute("material", "name", text.c_str()))
      return text;
    const pugi::xml_node found = materials.find_child_by_attribute("material", "id", text.c_str());
    return found ? found.attribute("name").value() : text;
  }

  void sides(pugi::xml_node pair) {
    const std::pair<const char*, const char*> words[] = {{old_secondary, "secondary"},
                                                         {old_primary, "primary"}};
    for (const auto& [old, name] : words)
      for (pugi::xml_node side : child_elements(pair, old)) {
        tree_.rename(side, name);
        if (const auto surface = take_attribute(side, "surface"))
          side.text().set(surface->c_str());
      }
  }

  /// A set in a set is all its nodes.
  void expand(pugi::xml_node set) {
    for (pugi::xml_node part : child_elements(set)) {
      if (std::strcmp(part.name(), "NodeSet") == 0) {
        const auto name = take_attribute(part, "node_set").value_or("");
        const pugi::xml_node other =
            geometry_.find_child_by_attribute("NodeSet", "name", name.c_str());
        if (!other || other == set || other.child("NodeSet") || !text_of(other).empty())
          tree_.fail(part, "expected the name of a set of single nodes that stands before, got '" +
                               name + "'");
        for (pugi::xml_node node : child_elements(other))
          tree_.append(set, "node", part)
              .append_attribute("id")
              .set_value(node.attribute("id").value());
        set.remove_child(part);
      } else if (std::strcmp(part.name(), "node_list") == 0) {
        const std::string ids = text_of(part);
        for (const std::string& id : words_of(ids, ", \t\r\n"))
          tree_.append(set, "node", part).append_attribute("id").set_value(id.c_str());
        set.remove_child(part);
      }
    }
  }

  /// 2.0 has the thickness of shells among the elements, for each node. One that is the same
  /// everywhere is that of the domains; other data stay, to be refused.
  void thickness() {
    for (pugi::xml_node data : child_elements(geometry_, "ElementData")) {
      std::set<std::string> numbers;
      for (pugi::xml_node element : child_elements(data))
        for (pugi::xml_node value : child_elements(element)) {
          if (std::strcmp(value.name(), "thickness") != 0)
            return;
          for (const std::string& number : words_of(text_of(value), ","))
            numbers.insert(number);
        }
      if (numbers.size() != 1)
        return;
      for (pugi::xml_node domain : child_elements(root_.child("MeshDomains"), "ShellDomain"))
        if (!domain.child("shell_thickness"))
          tree_.append_text(domain, "shell_thickness", *numbers.begin(), data);
      tree_.settle(data, Fate::ignored, "one thickness, that of the domains");
    }
  }

  Tree& tree_;
  pugi::xml_node root_, geometry_;
  FreeNames names_;
  std::set<std::string> seen_;
};

/// Materials may lack a name, which they are called by later.
void name_materials(Tree& tree) {
  const pugi::xml_node materials = tree.root().child("Material");
  FreeNames names(materials, "material");
  for (pugi::xml_node material : child_elements(materials, "material"))
    if (trimmed(material.attribute("name").value()).empty()) {
      take_attribute(material, "name");
      const std::string id = trimmed(material.attribute("id").value());
      material.append_attribute("name").set_value(names.make("Material" + id).c_str());
    }
}

} // namespace

void geometry_to_mesh(Tree& tree) {
  name_materials(tree);
  if (const pugi::xml_node geometry = tree.root().child("Geometry"))
    Translation(tree, geometry).run();
}

} // namespace abut::febio
