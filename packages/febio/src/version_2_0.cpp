// SPDX-License-Identifier: BSD-3-Clause
#include "abut/translation/yaml_text.hpp"
#include "versions.hpp"

#include <cstdlib>

namespace abut::febio {

namespace {

/// In 2.0 conditions, loads and contacts hold their nodes and faces themselves; since 2.5 these are
/// sets and surfaces of the geometry.
class Translation {
public:
  explicit Translation(Tree& tree)
      : tree_(tree), root_(tree.root()), geometry_(find_geometry()), sets_(geometry_, "NodeSet"),
        surfaces_(geometry_, "Surface"), pairs_(geometry_, "SurfacePair") {}

  void run() {
    if (!root_.child("Module"))
      tree_.append(root_, "Module", root_).append_attribute("type").set_value("solid");
    geometry();
    for (const pugi::xml_node phase : phases(tree_)) {
      boundary(phase);
      contact(phase);
      loads(phase);
      constraints(phase);
      initial(phase);
      for (pugi::xml_node module : child_elements(phase, "Module"))
        if (phase != root_ && trimmed(module.attribute("type").value()) == "solid")
          tree_.settle(module, Fate::ignored, "that of the whole file");
    }
  }

private:
  pugi::xml_node find_geometry() const {
    const pugi::xml_node geometry = root_.child("Geometry");
    if (!geometry)
      tree_.fail(root_, "expected an element <Geometry> in it");
    return geometry;
  }

  static void rename_attribute(pugi::xml_node node, const char* from, const char* to) {
    if (pugi::xml_attribute a = node.attribute(from); a && !node.attribute(to))
      a.set_name(to);
  }

  void geometry() {
    for (pugi::xml_node nodes : child_elements(geometry_, "Nodes")) {
      rename_attribute(nodes, "set", "name");
      sets_.make(name_of(nodes, ""));
    }
    for (pugi::xml_node elements : child_elements(geometry_, "Elements"))
      rename_attribute(elements, "elset", "name");
    for (pugi::xml_node set : child_elements(geometry_, "NodeSet"))
      for (pugi::xml_node part : child_elements(set, "NodeSet"))
        rename_attribute(part, "set", "node_set");
  }

  /// Child nodes with the same text, in the order in which the texts come.
  using Groups = std::vector<std::pair<std::string, std::vector<pugi::xml_node>>>;
  static Groups groups(const std::vector<pugi::xml_node>& nodes, const char* attribute = nullptr) {
    Groups result;
    std::map<std::string, std::size_t> place;
    for (const pugi::xml_node node : nodes) {
      const std::string key =
          attribute ? trimmed(node.attribute(attribute).value()) : text_of(node);
      const auto [it, is_new] = place.emplace(key, result.size());
      if (is_new)
        result.push_back({key, {}});
      result[it->second].second.push_back(node);
    }
    return result;
  }

  /// Moves nodes into a set of their own and returns its name.
  std::string node_set(const std::string& base, const std::vector<pugi::xml_node>& nodes,
                       pugi::xml_node from) {
    const std::string name = sets_.make(base);
    pugi::xml_node set = tree_.append(geometry_, "NodeSet", from);
    set.append_attribute("name").set_value(name.c_str());
    for (pugi::xml_node node : nodes)
      set.append_move(node);
    return name;
  }

  /// Moves the faces of a node into a surface of their own, or takes the one that it names.
  std::string surface(const std::string& base, pugi::xml_node holder) {
    if (const auto set = take_attribute(holder, "set"))
      return *set;
    const std::string name = surfaces_.make(base);
    pugi::xml_node surface = tree_.append(geometry_, "Surface", holder);
    surface.append_attribute("name").set_value(name.c_str());
    for (pugi::xml_node face : child_elements(holder))
      surface.append_move(face);
    return name;
  }

  static std::string name_of(pugi::xml_node node, const char* otherwise) {
    const std::string name = trimmed(node.attribute("name").value());
    return name.empty() ? otherwise : name;
  }

  /// What is left over stays, to be refused.
  static void remove_used(pugi::xml_node node) {
    if (!node.first_attribute() && child_elements(node).empty())
      node.parent().remove_child(node);
  }

  void boundary(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Boundary")) {
      for (pugi::xml_node fix : child_elements(section, "fix"))
        this->fix(fix);
      for (pugi::xml_node prescribe : child_elements(section, "prescribe"))
        this->prescribe(prescribe, "prescribed");
    }
  }

  void fix(pugi::xml_node fix) {
    if (fix.attribute("set"))
      return rename_attribute(fix, "set", "node_set");
    if (!fix.attribute("bc"))
      return tree_.settle(fix, Fate::refused, "expected an attribute 'bc' and nodes in it");
    fix.append_attribute("node_set")
        .set_value(node_set(name_of(fix, "fixed"), child_elements(fix), fix).c_str());
  }

  /// Each node of a list has a factor of its own, which FEBio 2 reads; FEBio 4 takes 1 for all.
  /// The element becomes one for each of the factors.
  void prescribe(pugi::xml_node node, const char* set_name) {
    const std::string scale = take_attribute(node, "scale").value_or("1");
    if (pugi::xml_attribute set = node.attribute("set")) {
      const std::string own = text_of(node);
      prescribed(node, trimmed(set.value()), own.empty() ? scale : own);
    } else {
      for (const auto& [factor, nodes] : groups(child_elements(node)))
        prescribed(node, node_set(set_name, nodes, node), product(scale, factor));
    }
    node.parent().remove_child(node);
  }

  static std::string product(const std::string& a, const std::string& b) {
    if (a == "1")
      return b;
    char *end_a = nullptr, *end_b = nullptr;
    const double value = std::strtod(a.c_str(), &end_a) * std::strtod(b.c_str(), &end_b);
    return a.empty() || b.empty() || *end_a || *end_b ? a + " " + b
                                                      : translation::number_text(value);
  }

  void prescribed(pugi::xml_node from, const std::string& set, const std::string& factor) {
    pugi::xml_node node = tree_.insert_before(from, from.name());
    for (const pugi::xml_attribute a : from.attributes()) {
      const std::string key = a.name();
      if (key != "set" && key != "lc" && key != "type")
        node.append_copy(a);
    }
    node.append_attribute("node_set").set_value(set.c_str());
    pugi::xml_node scale = tree_.append(node, "scale", from);
    scale.text().set(factor.c_str());
    if (const pugi::xml_attribute curve = from.attribute("lc"))
      scale.append_attribute("lc").set_value(curve.value());
    const std::string type = trimmed(from.attribute("type").value());
    if (type == "relative")
      tree_.append_text(node, "relative", "1", from);
    else if (!type.empty() && type != "absolute")
      node.append_attribute("type").set_value(type.c_str());
  }

  void contact(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Contact"))
      for (pugi::xml_node contact : child_elements(section, "contact")) {
        const std::string type = trimmed(contact.attribute("type").value());
        const auto sides = child_elements(contact, "surface");
        if (type == "rigid")
          rigid_nodes(contact, phase);
        else if (type == "rigid_wall")
          hold_surface(contact);
        else if (!sides.empty())
          surface_pair(contact, sides);
        else if (type.compare(0, 6, "rigid ") == 0)
          tree_.rename(tree_.child(phase, "Constraints", contact).append_move(contact),
                       "constraint");
      }
  }

  /// Nodes that move with rigid bodies, a list of both.
  void rigid_nodes(pugi::xml_node contact, pugi::xml_node phase) {
    const pugi::xml_node boundary = tree_.child(phase, "Boundary", contact);
    for (const auto& [body, nodes] : groups(child_elements(contact), "rb")) {
      pugi::xml_node rigid = tree_.append(boundary, "rigid", contact);
      rigid.append_attribute("rb").set_value(body.c_str());
      for (pugi::xml_node node : nodes)
        node.remove_attribute("rb");
      rigid.append_attribute("node_set")
          .set_value(node_set(name_of(contact, "rigid"), nodes, contact).c_str());
    }
    contact.parent().remove_child(contact);
  }

  void surface_pair(pugi::xml_node contact, const std::vector<pugi::xml_node>& sides) {
    for (const pugi::xml_node side : sides)
      if (trimmed(side.attribute("format").value()) == "element face")
        return tree_.settle(contact, Fate::refused,
                            "faces by number of element: give the nodes of each face");
    const std::string name = pairs_.make(name_of(contact, "contact"));
    pugi::xml_node pair = tree_.append(geometry_, "SurfacePair", contact);
    pair.append_attribute("name").set_value(name.c_str());
    for (const pugi::xml_node side : sides) {
      take_attribute(side, "format");
      // A word that is neither ends as an element that nobody knows.
      const std::string type = take_attribute(side, "type").value_or("");
      const bool known = type == old_primary || type == old_secondary;
      if (!known)
        tree_.fail(side, std::string("expected type=\"") + old_secondary + "\" or type=\"" +
                             old_primary + "\", got '" + type + "'");
      pugi::xml_node part = tree_.append(pair, type.c_str(), side);
      const std::string faces = surface(name + "_" + type, side);
      part.append_attribute("surface").set_value(faces.c_str());
      remove_used(side);
    }
    contact.append_attribute("surface_pair").set_value(name.c_str());
  }

  /// The surface of an element becomes its attribute.
  void hold_surface(pugi::xml_node node) {
    const pugi::xml_node side = node.child("surface");
    if (!side)
      return;
    take_attribute(side, "format");
    const std::string faces = surface(name_of(node, "surface"), side);
    node.append_attribute("surface").set_value(faces.c_str());
    remove_used(side);
  }

  void loads(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Loads")) {
      for (pugi::xml_node load : child_elements(section, "surface_load"))
        hold_surface(load);
      for (pugi::xml_node load : child_elements(section, "nodal_load"))
        prescribe(load, "loaded");
    }
  }

  void constraints(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Constraints")) {
      for (pugi::xml_node body : child_elements(section, "rigid_body"))
        tree_.child(phase, "Boundary", body).append_move(body);
      for (pugi::xml_node constraint : child_elements(section, "constraint"))
        hold_surface(constraint);
    }
  }

  void initial(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Initial"))
      for (pugi::xml_node velocity : child_elements(section, "velocity")) {
        for (const auto& [value, nodes] : groups(child_elements(velocity))) {
          pugi::xml_node ic = tree_.append(section, "ic", velocity);
          ic.append_attribute("type").set_value("velocity");
          ic.append_attribute("node_set").set_value(node_set("velocity", nodes, velocity).c_str());
          tree_.append_text(ic, "value", value, velocity);
        }
        remove_used(velocity);
      }
  }

  Tree& tree_;
  pugi::xml_node root_, geometry_;
  FreeNames sets_, surfaces_, pairs_;
};

} // namespace

void from_2_0(Tree& tree) {
  Translation(tree).run();
}

} // namespace abut::febio
