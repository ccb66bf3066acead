// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cmath>

namespace abut::abaqus {

namespace {

constexpr const char* one_temperature =
    "it depends on temperature, which abut has not: give one line";

/// The numbers of the only line, at most so many and a temperature.
std::vector<double> only_line(Card& card, std::size_t most) {
  std::vector<double> x = card.numbers();
  if (card.lines.size() > (most + 8) / 8)
    card.refuse(one_temperature);
  if (x.size() > most + 1)
    card.refuse("expected at most " + std::to_string(most) + " numbers");
  x.resize(most, 0.0);
  return x;
}

void read_elastic(Card& card, Material& material) {
  const std::string type = card.word(
      "TYPE", {"ISOTROPIC", "ISO", "ORTHOTROPIC", "ENGINEERING CONSTANTS", "LAMINA", "ANISOTROPIC"},
      "ISO");
  card.ignore({"MODULI"}, "the elastic ones");
  if (type != "ISO" && type != "ISOTROPIC") {
    card.refuse("abut's elastic materials are isotropic");
    return;
  }
  if (card.lines.empty())
    card.fail("expected a line of Young's modulus and Poisson's ratio");
  if (card.lines.size() > 1)
    card.refuse(one_temperature);
  const auto fields = card.lines[0].fields();
  Elastic e;
  e.young = card.number(card.lines[0], fields, 0, "Young's modulus");
  e.poisson = card.number(card.lines[0], fields, 1, "Poisson's ratio", 0.0);
  if (!(e.young > 0.0))
    card.fail(card.lines[0].place, "expected Young's modulus > 0");
  if (!(e.poisson > -1.0 && e.poisson < 0.5))
    card.fail(card.lines[0].place, "expected Poisson's ratio > -1 and < 0.5");
  material.elastic = e;
}

/// Energy of the volume: 1/D1 (J - 1)^2 there, K/2 (ln J)^2 here, the same where J is near one.
void note_volume(Card& card, const Hyperelastic& h) {
  if (h.compressibility == 0.0) {
    card.note("D1 = 0, incompressible: abut takes a bulk modulus of 1000 times the shear modulus");
    return;
  }
  const double ratio = 2.0 / h.compressibility / h.shear();
  constexpr double soft = 20.0; // there the volume changes by percents
  if (ratio < soft)
    card.note("the volume can change much, and abut's law is K/2 (ln J)^2 with K = 2/D1 instead of "
              "(J - 1)^2/D1: the same at small changes of volume alone");
}

/// A Ogden potential 2 mu/a^2 (l1^a + ...) is c/a^2 (...) with c = 2 mu.
void read_ogden(Card& card, std::size_t terms, Hyperelastic& h) {
  const std::vector<double> x = only_line(card, 3 * terms);
  h.is_ogden = true;
  for (std::size_t i = 0; i < terms; ++i) {
    if (x[2 * i] == 0.0)
      continue;
    h.coefficients.push_back(2.0 * x[2 * i]);
    h.exponents.push_back(x[2 * i + 1]);
    if (x[2 * i + 1] == 0.0)
      card.fail("expected exponents that are not zero");
  }
  h.compressibility = x[2 * terms];
  for (std::size_t i = 1; i < terms; ++i)
    if (x[2 * terms + i] != 0.0)
      card.refuse("D2 and higher: abut's energy of the volume has one constant");
}

void read_hyperelastic(Card& card, Material& material) {
  Hyperelastic h;
  h.place = card.place();
  card.ignore({"MODULI"}, "those of long term are the ones of a static model");
  const double n = card.number_parameter("N").value_or(1.0);
  if (!(n >= 1.0 && n <= 6.0) || n != std::floor(n))
    card.fail("expected N from 1 to 6");
  const std::size_t terms = static_cast<std::size_t>(n);
  const bool ogden = card.has("OGDEN");
  const bool neo = card.has("NEO HOOKE") || card.has("NEOHOOKE") ||
                   (card.has("REDUCED POLYNOMIAL") && terms == 1);
  const bool mooney = card.has("MOONEY-RIVLIN") || (card.has("POLYNOMIAL") && terms == 1);
  if (card.has("TEST DATA INPUT")) {
    card.refuse("TEST DATA INPUT: give the coefficients");
    return;
  }
  if (!ogden && !neo && !mooney) {
    for (const char* other : {"ARRUDA-BOYCE", "MARLOW", "VAN DER WAALS", "YEOH"})
      if (card.has(other)) {
        card.refuse(std::string(other) + ": abut has NEO HOOKE, MOONEY-RIVLIN and OGDEN");
        return;
      }
    card.refuse("expected NEO HOOKE, MOONEY-RIVLIN or OGDEN, or another with N=1");
    return;
  }
  if (card.lines.empty())
    card.fail("expected a line of coefficients");
  if (ogden) {
    read_ogden(card, terms, h);
  } else {
    const std::vector<double> x = only_line(card, neo ? 2 : 3);
    h.coefficients = {x[0], neo ? 0.0 : x[1]};
    h.compressibility = x[neo ? 1 : 2];
  }
  if (!(h.shear() > 0.0))
    card.fail("expected a shear modulus > 0 of all coefficients");
  if (!(h.compressibility >= 0.0))
    card.fail("expected D1 >= 0");
  note_volume(card, h);
  material.hyperelastic = h;
}

} // namespace

void read_material(Card& card, Model& model) {
  card.use();
  Material material;
  material.name = name_of(card, card.required("NAME"));
  material.place = card.place();
  card.ignore({"RTOL", "SRATE FACTOR"}, "");
  require_new(card, model.materials, material.name);
  model.materials.emplace(key_of(material.name), std::move(material));
}

void read_material_part(Card& card, Material* material) {
  card.use();
  if (!material)
    card.fail("expected below a *MATERIAL");
  if (card.is("ELASTIC")) {
    read_elastic(card, *material);
  } else if (card.is("HYPERELASTIC")) {
    read_hyperelastic(card, *material);
  } else if (card.is("DENSITY")) {
    material->density = only_line(card, 1)[0];
    if (!(material->density >= 0.0))
      card.fail("expected a density >= 0");
  } else { // EXPANSION
    const std::vector<double> x = card.numbers();
    card.ignore({"ZERO", "TYPE"}, "");
    // Behind each coefficient stands a temperature.
    material->expands = std::any_of(x.begin(), x.end(), [](double v) { return v != 0.0; });
    if (!material->expands || !card.lines.empty())
      card.note("it counts only with *TEMPERATURE in a step");
  }
}

} // namespace abut::abaqus
