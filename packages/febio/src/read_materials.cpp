// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "readers.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

struct Parameter {
  const char* name;
  bool required;
  double initial;
};

void read_numbers(Element material, std::initializer_list<Parameter> parameters, Material& m) {
  for (const Parameter& p : parameters) {
    if (p.required)
      material.required_child(p.name);
    if (const auto value = material.child(p.name))
      m.numbers[p.name] = value->number();
    else
      m.numbers[p.name] = p.initial;
  }
}

void read_ogden_terms(Element material, Material& m) {
  double sum = 0.0;
  for (int k = 1; k <= 6; ++k) {
    const std::string c = "c" + std::to_string(k), power = "m" + std::to_string(k);
    m.numbers[c] = material.number_or(c.c_str(), 0.0);
    m.numbers[power] = material.number_or(power.c_str(), 1.0);
    if (m.numbers[c] != 0.0 && m.numbers[power] == 0.0)
      material.required_child(power.c_str()).fail("expected a power that is not zero");
    sum += m.numbers[c];
  }
  if (!(sum > 0.0))
    material.fail("expected terms c1, ... whose sum, twice the shear modulus, is > 0");
}

void read_pressure_model(Element material) {
  auto model = material.child("pressure_model");
  if (model && model->text() != "default" && model->text() != "0")
    model->refuse("'" + model->text() + "': abut has the default one, k/2 (ln J)^2");
}

void require(Element material, const Material& m, const char* key, bool holds,
             const char* expected) {
  if (!holds)
    material.required_child(key).fail(std::string("expected ") + expected + ", got " +
                                      std::to_string(m.numbers.at(key)));
}

void read_elastic(Element material, Material& m) {
  read_numbers(material, {{"E", true, 0.0}, {"v", true, 0.0}}, m);
  require(material, m, "E", m.numbers["E"] > 0.0, "a number > 0");
  require(material, m, "v", m.numbers["v"] > -1.0 && m.numbers["v"] < 0.5,
          "a number > -1 and < 0.5");
}

void read_uncoupled(Element material, Material& m) {
  read_numbers(material, {{"k", true, 0.0}}, m);
  require(material, m, "k", m.numbers["k"] > 0.0, "a number > 0");
  read_pressure_model(material);
  material.expect("laugon", 0, "abut has no multipliers for volumes: set 0");
  material.ignore("atol", "has no effect without laugon");
}

void read_rigid_body(Element material, Material& m) {
  read_numbers(material, {{"E", false, 1.0}, {"v", false, 0.0}}, m);
  if (const auto center = material.child("center_of_mass")) {
    const std::vector<double> x = center->numbers(3);
    m.center_of_mass = Vec3{{x[0], x[1], x[2]}};
  }
  material.ignore("override_com");
}

} // namespace

void read_materials(Element section, Model& model) {
  static const std::string types[] = {"neo-Hookean",         "Mooney-Rivlin", "Ogden",
                                      "Ogden unconstrained", "Holmes-Mow",    "isotropic elastic",
                                      "St.Venant-Kirchhoff", "rigid body",    "incomp neo-Hookean"};
  for (Element material : section.children("material")) {
    Material m;
    m.line = material.line();
    m.id = material.attribute_or("id", "");
    m.name = material.required_attribute("name");
    m.type = material.required_attribute("type");
    require_new_name(material, model.materials, m.name);
    m.numbers["density"] = material.number_or("density", 1.0);
    require(material, m, "density", m.numbers["density"] >= 0.0, "a number >= 0");
    if (m.is_rigid()) {
      read_rigid_body(material, m);
    } else if (m.type == "neo-Hookean" || m.type == "isotropic elastic" ||
               m.type == "St.Venant-Kirchhoff") {
      read_elastic(material, m);
    } else if (m.type == "Holmes-Mow") {
      read_elastic(material, m);
      read_numbers(material, {{"beta", true, 0.0}}, m);
      require(material, m, "beta", m.numbers["beta"] > 0.0, "a number > 0");
    } else if (m.type == "Mooney-Rivlin") {
      read_uncoupled(material, m);
      read_numbers(material, {{"c1", true, 0.0}, {"c2", false, 0.0}}, m);
      require(material, m, "c1", m.numbers["c1"] + m.numbers["c2"] > 0.0, "c1 + c2 > 0");
    } else if (m.type == "incomp neo-Hookean") {
      read_uncoupled(material, m);
      read_numbers(material, {{"G", true, 0.0}}, m);
      require(material, m, "G", m.numbers["G"] > 0.0, "a number > 0");
      m.numbers["c1"] = 0.5 * m.numbers["G"];
      m.numbers["c2"] = 0.0;
    } else if (m.type == "Ogden") {
      read_uncoupled(material, m);
      read_ogden_terms(material, m);
    } else if (m.type == "Ogden unconstrained") {
      read_numbers(material, {{"cp", true, 0.0}}, m);
      require(material, m, "cp", m.numbers["cp"] >= 0.0, "a number >= 0");
      read_ogden_terms(material, m);
    } else {
      material.refuse("type '" + m.type + "'; " +
                      nearest_word_hint(m.type, types, std::size(types)));
    }
    model.materials.push_back(std::move(m));
  }
}

} // namespace abut::febio
