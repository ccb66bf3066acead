// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element.hpp"

/// Readers of the sections of a file, each into the model. All throw InputError as read_model does.
namespace abut::febio {

void read_control(Element section, Model& model);
void read_materials(Element section, Model& model);
void read_mesh(Element section, Model& model);
void read_mesh_domains(Element section, Model& model);
/// Thickness of rigid shells.
void read_mesh_data(Element section, Model& model);
/// Rigid shells become rigid cells behind their faces, as surfaces list these.
void extrude_rigid_shells(Model& model);
void read_boundary(Element section, Model& model);
void read_rigid(Element section, Model& model);
/// A <rigid_connector>.
void read_connector(Element connector, Model& model);
/// The rigid material that the child `key` names.
std::string read_rigid_body(Element parent, const char* key, const Model& model);
void read_loads(Element section, Model& model);
void read_contacts(Element section, Model& model);
/// Walls become rigid bodies and contacts.
void read_constraints(Element section, Model& model);
/// Whether <laugon> asks for multipliers.
bool read_augmentation(Element contact);
void read_load_data(Element section, Model& model);

/// Throws when the name is taken; for lists of items with a name and a line.
template <class List>
void require_new_name(const Element& e, const List& list, const std::string& name) {
  for (const auto& item : list)
    if (item.name == name)
      e.fail("the name '" + name + "' is taken by line " + std::to_string(item.line));
}

} // namespace abut::febio
