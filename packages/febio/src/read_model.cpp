// SPDX-License-Identifier: BSD-3-Clause
#include "abut/febio/import.hpp"
#include "abut/translation/yaml_text.hpp"
#include "readers.hpp"
#include "versions.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

void read_module(Element root) {
  Element module = root.required_child("Module");
  const std::string type = module.required_attribute("type");
  module.ignore("units", "numbers are taken as they are: units must agree with each other");
  if (type != "solid")
    module.refuse("module '" + type + "': abut has solid mechanics alone, type=\"solid\"");
}

/// Sections that change the answer and that abut has nothing for.
void refuse_sections(Element parent) {
  const std::pair<const char*, const char*> sections[] = {{"Discrete", "abut has no springs"},
                                                          {"MeshAdaptor", "abut keeps its mesh"}};
  for (const auto& [name, why] : sections)
    for (Element section : parent.children(name))
      if (!section.children().empty())
        section.refuse(why);
}

/// Velocities at the start.
void read_initial(Element section, Model& model) {
  for (Element ic : section.children("ic")) {
    const std::string type = ic.required_attribute("type");
    if (type != "velocity" && type != "initial velocity") {
      ic.refuse("type '" + type + "': abut has velocity");
      continue;
    }
    InitialVelocity v;
    v.name = ic.attribute_or("name", "");
    v.place = ic.required_attribute("node_set");
    v.line = ic.line();
    const std::vector<double> value = ic.required_child("value").numbers(3);
    std::copy(value.begin(), value.end(), v.value.begin());
    model.initial_velocities.push_back(v);
  }
}

/// Sections that may also stand in a step, but for Control.
void read_physics(Element parent, Model& model) {
  refuse_sections(parent);
  for (Element section : parent.children("MeshData"))
    read_mesh_data(section, model);
  if (const auto section = parent.child("Boundary"))
    read_boundary(*section, model);
  if (const auto section = parent.child("Rigid"))
    read_rigid(*section, model);
  if (const auto section = parent.child("Loads"))
    read_loads(*section, model);
  if (const auto section = parent.child("Contact"))
    read_contacts(*section, model);
}

/// A wall is there in all steps, its contact perhaps in one alone.
void read_walls(Element parent, Model& model, int step) {
  const std::size_t before = model.contacts.size();
  if (const auto section = parent.child("Constraints"))
    read_constraints(*section, model);
  for (std::size_t i = before; i < model.contacts.size(); ++i)
    model.contacts[i].step = step;
}

/// What begins with the run begins at rest.
void forget_relative(Model& model) {
  for (Displacement& d : model.displacements)
    d.relative = false;
  for (RigidCondition& c : model.rigid_conditions)
    c.relative = false;
}

/// Reads what holds in one step alone.
class StepReader {
public:
  explicit StepReader(Model& model) : model_(model) {}

  void read(Element step, int index) {
    each([](auto& list, std::size_t& before) { before = list.size(); });
    read_physics(step, model_);
    each([&](auto& list, std::size_t& before) {
      for (std::size_t i = before; i < list.size(); ++i)
        list[i].step = index;
    });
    if (index == 0)
      forget_relative(model_);
  }

private:
  template <class F> void each(F f) {
    f(model_.displacements, before_[0]);
    f(model_.ties, before_[1]);
    f(model_.rigid_conditions, before_[2]);
    f(model_.rigid_loads, before_[3]);
    f(model_.loads, before_[4]);
    f(model_.contacts, before_[5]);
    f(model_.connectors, before_[6]);
  }

  Model& model_;
  std::array<std::size_t, 7> before_{};
};

void read_steps(Element root, Model& model) {
  auto control = root.child("Control");
  auto section = root.child("Step");
  std::vector<Element> steps = section ? section->children("step") : std::vector<Element>{};
  if (control)
    read_control(*control, model);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const char* key : {"id", "name", "type"})
      steps[i].attribute(key);
    auto own = steps[i].child("Control");
    if (control && own)
      own->fail("a second one; the first is in line " + std::to_string(control->line()) +
                ", outside of the steps");
    if (own)
      read_control(*own, model);
    else if (!control || steps.size() > 1)
      steps[i].fail("expected an element <Control> in it");
    const std::size_t velocities = model.initial_velocities.size();
    StepReader(model).read(steps[i], static_cast<int>(i));
    if (const auto initial = steps[i].child("Initial"))
      read_initial(*initial, model);
    if (i > 0 && model.initial_velocities.size() > velocities)
      steps[i].refuse("abut has velocities at the start of the run, not of a later step");
    read_walls(steps[i], model, static_cast<int>(i));
  }
  if (model.steps.empty())
    root.fail("expected an element <Control> in it or in its <step>");
}

} // namespace

double Model::start(std::size_t step) const {
  double t = 0.0;
  for (std::size_t i = 0; i < step; ++i)
    t += steps[i].count * steps[i].size;
  return translation::rounded(t, 12);
}

Course Model::course(const Value& value, int step) const {
  if (step < 0 || steps.size() == 1)
    return {value};
  Course result(steps.size(), Value{0.0, 0, value.line});
  result[static_cast<std::size_t>(step)] = value;
  return result;
}

const Material* Model::material(const std::string& name) const {
  for (const Material& m : materials)
    if (m.name == name)
      return &m;
  return nullptr;
}

Model read_model(const std::string& text, const std::string& file, Report& report) {
  Tree tree(text, file);
  to_specification_4(tree);
  Document document(tree);
  Element root = document.root();
  root.attribute("version");
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
  if (const auto section = root.child("Initial"))
    read_initial(*section, model);
  forget_relative(model);
  read_walls(root, model, -1);
  read_steps(root, model);
  root.ignore("Output", "abut writes displacement, contact fields, stress and energy always");
  report = document.report();
  return model;
}

} // namespace abut::febio
