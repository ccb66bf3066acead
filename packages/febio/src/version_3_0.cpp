// SPDX-License-Identifier: BSD-3-Clause
#include "versions.hpp"

#include <cstring>

namespace abut::febio {

namespace {

class Translation {
public:
  explicit Translation(Tree& tree) : tree_(tree), root_(tree.root()) {}

  void run() {
    geometry_to_mesh(tree_); // 3.0 reads <Geometry> too
    for (const pugi::xml_node phase : phases(tree_)) {
      for (pugi::xml_node section : child_elements(phase, "Boundary"))
        for (pugi::xml_node bc : child_elements(section, "bc"))
          boundary(bc);
      for (pugi::xml_node section : child_elements(phase, "Rigid"))
        for (pugi::xml_node constraint : child_elements(section, "rigid_constraint"))
          rigid(constraint);
      for (pugi::xml_node section : child_elements(phase, "Loads"))
        for (pugi::xml_node load : child_elements(section, "nodal_load"))
          nodal_load(load);
      walls(phase);
      connectors(phase);
    }
  }

private:
  static void set_type(pugi::xml_node node, const char* type) {
    node.attribute("type").set_value(type);
  }

  void boundary(pugi::xml_node bc) {
    const std::string type = trimmed(bc.attribute("type").value());
    if (type == "fix")
      fix(bc);
    else if (type == "prescribe")
      prescribe(bc);
    else if (type == "rigid")
      for (const char* word : {"clamped_shells", "clamp_shells"})
        if (const pugi::xml_node child = bc.child(word))
          tree_.settle(child, Fate::ignored, "solids have no rotations at their nodes");
  }

  /// <dofs>x,y</dofs> becomes <x_dof>1</x_dof> and <y_dof>1</y_dof>.
  void fix(pugi::xml_node bc) {
    const pugi::xml_node dofs = bc.child("dofs");
    if (!dofs)
      return;
    bool shells = false, solids = false;
    for (const std::string& dof : dofs_of(text_of(dofs))) {
      shells = shells || is_of_shells(dof);
      if (is_of_shells(dof))
        continue;
      solids = true;
      if (dof != "x" && dof != "y" && dof != "z")
        return tree_.settle(bc, Fate::refused,
                            "degree of freedom '" + dof + "': abut has x, y and z");
      if (const std::string word = dof + "_dof"; !bc.child(word.c_str()))
        tree_.append_text(bc, word.c_str(), "1", dofs);
    }
    if (shells)
      tree_.settle(solids ? dofs : bc, Fate::ignored,
                   "solids have no rotations at their nodes, which u, v, w and sx, sy, sz are");
    else
      bc.remove_child(dofs);
    set_type(bc, "zero displacement");
  }

  void prescribe(pugi::xml_node bc) {
    const std::string dof = text_of(bc.child("dof"));
    if (dof != "x" && dof != "y" && dof != "z")
      return tree_.settle(bc, Fate::refused,
                          "degree of freedom '" + dof + "': abut has x, y and z");
    merge_scale_and_value(tree_, bc);
    if (const pugi::xml_node scale = bc.child("scale"))
      tree_.rename(scale, "value");
    set_type(bc, "prescribed displacement");
  }

  /// The index of Rx, Ry, Rz, Ru, Rv, Rw; also the numbers themselves.
  int rigid_dof(pugi::xml_node node, const std::string& word) const {
    const char* const words[] = {"Rx", "Ry", "Rz", "Ru", "Rv", "Rw"};
    for (int i = 0; i < 6; ++i)
      if (word == words[i] || word == std::to_string(i))
        return i;
    tree_.fail(node, "expected Rx, Ry, Rz, Ru, Rv or Rw, got '" + word + "'");
  }

  void rigid(pugi::xml_node node) {
    const std::string type = trimmed(node.attribute("type").value());
    if (type == "fix") {
      tree_.rename(node, "rigid_bc");
      set_type(node, "rigid_fixed");
      rigid_fix(node);
    } else if (type == "prescribe") {
      tree_.rename(node, "rigid_bc");
      rigid_component(node, "rigid_displacement", "rigid_rotation");
    } else if (type == "force") {
      tree_.rename(node, "rigid_load");
      rigid_component(node, "rigid_force", "rigid_moment");
    } else if (type.compare(0, 8, "initial_") == 0) {
      tree_.rename(node, "rigid_ic");
    } else {
      tree_.rename(node, type.compare(0, 8, "follower") == 0 ? "rigid_load" : "rigid_bc");
    }
  }

  void rigid_fix(pugi::xml_node node) {
    const pugi::xml_node dofs = node.child("dofs");
    if (!dofs)
      return;
    const char* const words[] = {"Rx_dof", "Ry_dof", "Rz_dof", "Ru_dof", "Rv_dof", "Rw_dof"};
    for (const std::string& dof : words_of(text_of(dofs), ", \t\r\n")) {
      const char* const word = words[rigid_dof(dofs, dof)];
      if (!node.child(word))
        tree_.append_text(node, word, "1", dofs);
    }
    node.remove_child(dofs);
  }

  void rigid_component(pugi::xml_node node, const char* translation, const char* rotation) {
    pugi::xml_node dof = node.child("dof");
    if (!dof)
      tree_.fail(node, "expected an element <dof> in it");
    const int i = rigid_dof(dof, text_of(dof));
    set_type(node, i < 3 ? translation : rotation);
    const char* const words[] = {"Rx", "Ry", "Rz", "Ru", "Rv", "Rw"};
    dof.text().set(words[i]);
  }

  /// Early files of 3.0 have them as 2.5 does.
  void nodal_load(pugi::xml_node load) {
    const auto bc = take_attribute(load, "bc");
    if (!bc)
      return;
    if (!load.attribute("type"))
      load.append_attribute("type").set_value("nodal_load");
    tree_.append_text(load, "dof", *bc, load);
    merge_scale_and_value(tree_, load);
  }

  /// Rigid walls were contacts.
  void walls(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Contact"))
      for (pugi::xml_node contact : child_elements(section, "contact"))
        if (trimmed(contact.attribute("type").value()) == "rigid_wall")
          tree_.rename(tree_.child(phase, "Constraints", contact).append_move(contact),
                       "constraint");
  }

  /// Joints were constraints.
  void connectors(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Constraints"))
      for (pugi::xml_node constraint : child_elements(section, "constraint"))
        if (trimmed(constraint.attribute("type").value()).compare(0, 6, "rigid ") == 0)
          tree_.rename(tree_.child(phase, "Rigid", constraint).append_move(constraint),
                       "rigid_connector");
  }

  Tree& tree_;
  pugi::xml_node root_;
};

} // namespace

void from_3_0(Tree& tree) {
  Translation(tree).run();
}

} // namespace abut::febio
