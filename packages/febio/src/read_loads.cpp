// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>
#include <cstdlib>

namespace abut::febio {

namespace {

void require_surface(const Element& load, const Model& model, const std::string& name) {
  for (const Surface& s : model.mesh.surfaces)
    if (s.name == name)
      return;
  load.fail("there is no surface '" + name + "'");
}

void read_surface_load(Element load, Model& model) {
  Load l;
  l.name = load.attribute_or("name", "");
  l.line = load.line();
  l.place = load.required_attribute("surface");
  require_surface(load, model, l.place);
  const std::string type = load.required_attribute("type");
  if (type == "pressure") {
    l.vector[0] = load.required_child("pressure").value();
    load.expect("linear", 0, "abut's pressure follows the surface, linear 0");
    load.expect("shell_bottom", 0, "abut has no shells");
    load.ignore("symmetric_stiffness", "abut takes the exact tangent");
  } else if (type == "traction") {
    l.kind = Load::Kind::traction;
    const Value scale = load.value_or("scale", 1.0);
    const std::vector<double> t = load.required_child("traction").numbers(3);
    for (std::size_t i = 0; i < 3; ++i)
      l.vector[i] = {t[i] * scale.number, scale.curve, scale.line};
    l.current_area = !load.flag_or("linear", false);
    load.expect("shell_bottom", 0, "abut has no shells");
  } else {
    load.refuse("type '" + type + "': abut has pressure and traction");
    return;
  }
  model.loads.push_back(l);
}

void read_nodal_load(Element load, Model& model) {
  Load l;
  l.kind = Load::Kind::nodal;
  l.name = load.attribute_or("name", "");
  l.line = load.line();
  l.place = load.required_attribute("node_set");
  const std::string type = load.attribute_or("type", "nodal_load");
  load.expect("relative", 0, "abut has absolute loads, relative 0");
  if (type == "nodal_load") {
    const Element dof = load.required_child("dof");
    const std::string axis = dof.text();
    if (axis != "x" && axis != "y" && axis != "z")
      dof.fail("expected x, y or z, got '" + axis + "'");
    l.vector[static_cast<std::size_t>(axis[0] - 'x')] = load.required_child("scale").value();
  } else if (type == "nodal_force") {
    Element value = load.required_child("value");
    const std::vector<double> f = value.numbers(3);
    const auto lc = value.attribute("lc");
    for (std::size_t i = 0; i < 3; ++i)
      l.vector[i] = {f[i], lc ? std::atoi(lc->c_str()) : 0, value.line()};
  } else {
    load.refuse("type '" + type + "': abut has nodal_load and nodal_force");
    return;
  }
  model.loads.push_back(l);
}

void read_body_load(Element load, Model& model) {
  Load l;
  l.kind = Load::Kind::body_force;
  l.name = load.attribute_or("name", "");
  l.line = load.line();
  const std::string type = load.required_attribute("type");
  if (type != "const") {
    load.refuse("type '" + type + "': abut has const");
    return;
  }
  l.place = load.attribute_or("elem_set", "");
  const auto& domains = model.mesh.domains;
  if (!l.place.empty() && std::none_of(domains.begin(), domains.end(),
                                       [&](const Domain& d) { return d.name == l.place; }))
    load.refuse("abut takes a body load for all bodies or for one <Elements> by its name");
  constexpr const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    l.vector[i] = load.value_or(axes[i], 0.0);
  load.note("force per volume: minus the density times this");
  model.loads.push_back(l);
}

template <class Word, std::size_t n>
Word word_of(Element parent, const char* key, const char* const (&words)[n]) {
  auto child = parent.child(key);
  if (!child)
    return Word{};
  std::string text = child->text();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (std::size_t i = 0; i < n; ++i)
    if (text == words[i])
      return static_cast<Word>(i);
  child->refuse("'" + text + "' is not one of the kinds that abut reads");
  return Word{};
}

void read_curve(Element controller, LoadCurve& curve) {
  curve.interpolation =
      word_of<Interpolation>(controller, "interpolate", {"LINEAR", "STEP", "SMOOTH"});
  curve.extension = word_of<Extension>(controller, "extend",
                                       {"CONSTANT", "EXTRAPOLATE", "REPEAT", "REPEAT OFFSET"});
  Element points = controller.required_child("points");
  for (Element pt : points.bulk()) {
    if (pt.name() != "pt" && pt.name() != "point")
      pt.fail("expected <pt>");
    const std::vector<double> p = pt.numbers(2);
    if (!curve.points.empty() && p[0] <= curve.points.back()[0])
      pt.fail("times must grow from point to point");
    curve.points.push_back({p[0], p[1]});
  }
  if (curve.points.empty())
    points.fail("a load curve needs points");
}

} // namespace

void read_loads(Element section, Model& model) {
  for (Element load : section.children("surface_load"))
    read_surface_load(load, model);
  for (Element load : section.children("nodal_load"))
    read_nodal_load(load, model);
  for (Element load : section.children("body_load"))
    read_body_load(load, model);
}

void read_load_data(Element section, Model& model) {
  for (Element controller : section.children("load_controller")) {
    LoadCurve curve;
    curve.line = controller.line();
    const std::string id = controller.required_attribute("id");
    const int number = std::atoi(id.c_str());
    if (number < 1)
      controller.fail("expected a whole number > 0 as id, got '" + id + "'");
    curve.name = controller.attribute_or("name", "LC" + id);
    const std::string type = controller.required_attribute("type");
    if (type == "loadcurve")
      read_curve(controller, curve);
    else
      controller.refuse("type '" + type + "': abut reads load curves, type=\"loadcurve\"");
    if (!model.curves.emplace(number, curve).second)
      controller.fail("id " + id + " is taken by line " +
                      std::to_string(model.curves[number].line));
  }
}

} // namespace abut::febio
