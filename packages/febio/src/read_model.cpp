// SPDX-License-Identifier: BSD-3-Clause
#include "abut/febio/import.hpp"
#include "readers.hpp"

namespace abut::febio {

namespace {

void read_module(Element root) {
  Element module = root.required_child("Module");
  const std::string type = module.required_attribute("type");
  if (type != "solid")
    module.refuse("module '" + type + "': abut has solid mechanics alone, type=\"solid\"");
}

/// Sections that change the answer and that abut has nothing for.
void refuse_sections(Element parent) {
  const std::pair<const char*, const char*> sections[] = {
      {"Constraints", "abut has none; make a rigid wall a rigid body of one hex8 and a contact"},
      {"Initial", "abut is static and starts without strain"},
      {"Discrete", "abut has no springs"},
      {"MeshData", "abut has no data that vary from element to element"},
      {"MeshAdaptor", "abut keeps its mesh"}};
  for (const auto& [name, why] : sections)
    for (Element section : parent.children(name))
      if (!section.children().empty())
        section.refuse(why);
}

/// Sections that may also stand in a step.
void read_physics(Element parent, Model& model) {
  refuse_sections(parent);
  if (const auto section = parent.child("Control"))
    read_control(*section, model);
  if (const auto section = parent.child("Boundary"))
    read_boundary(*section, model);
  if (const auto section = parent.child("Rigid"))
    read_rigid(*section, model);
  if (const auto section = parent.child("Loads"))
    read_loads(*section, model);
  if (const auto section = parent.child("Contact"))
    read_contacts(*section, model);
}

void read_steps(Element root, Model& model) {
  auto section = root.child("Step");
  if (!section)
    return;
  std::vector<Element> steps = section->children("step");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i].attribute("id");
    steps[i].attribute("name");
    steps[i].attribute("type");
    if (i == 0)
      read_physics(steps[i], model);
    else
      steps[i].refuse("what holds in one step only needs as many runs: make a file of each step; "
                      "abut imports one");
  }
}

} // namespace

const Material* Model::material(const std::string& name) const {
  for (const Material& m : materials)
    if (m.name == name)
      return &m;
  return nullptr;
}

Model read_model(const std::string& text, const std::string& file, Report& report) {
  Document document(text, file);
  Element root = document.root("febio_spec");
  const std::string version = root.required_attribute("version");
  if (version != "4.0")
    root.fail("version '" + version +
              "': expected a file of version 4.0, as FEBio Studio saves it");
  Model model;
  model.file = file;
  read_module(root);
  root.ignore("Globals", "temperature and gas constants: solid mechanics has no use for them");
  if (const auto section = root.child("Material"))
    read_materials(*section, model);
  read_mesh(root.required_child("Mesh"), model);
  read_mesh_domains(root.required_child("MeshDomains"), model);
  if (auto section = root.child("LoadData"))
    read_load_data(*section, model);
  read_physics(root, model);
  read_steps(root, model);
  root.ignore("Output", "abut writes displacement, contact fields, stress and energy always");
  if (!model.control.given)
    root.fail("expected an element <Control> in it or in its <step>");
  report = document.report();
  return model;
}

} // namespace abut::febio
