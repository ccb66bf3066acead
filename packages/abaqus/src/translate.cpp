// SPDX-License-Identifier: BSD-3-Clause
#include "abut/abaqus/import.hpp"

#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::abaqus {

namespace {

constexpr int most_guessed = 20; // increments of a step whose first one is a guess

/// Increments that a step is begun with.
double increment(const Step& step, bool& fewer) {
  const double count = std::max(1.0, std::round(step.period / step.increment));
  const bool guessed = !step.direct && !step.dynamic && count > most_guessed;
  fewer = fewer || guessed;
  return step.period / (guessed ? most_guessed : count);
}

/// Steps of one size, the smallest of the file's or finer, that meet the ends of all steps.
int step_count(const DeckParts& parts) {
  constexpr int finest = 20;
  const Model& model = parts.model;
  const double end = model.end();
  double size = end;
  bool fewer = false;
  for (const Step& step : model.steps)
    size = std::min(size, increment(step, fewer));
  if (fewer)
    parts.say(model.steps[0].place, "*STATIC", Fate::used,
              "a small first increment is a guess: abut begins with " +
                  std::to_string(most_guessed) + " and cuts those that fail; DIRECT asks for all");
  constexpr double most = 1e6;
  if (end / size > most)
    throw InputError(model.where(model.steps[0].place) +
                     ": *STEP: the smallest increment is less than a millionth of all steps");
  const int count = std::max(1, static_cast<int>(std::lround(end / size)));
  for (int finer = 1; finer <= finest; ++finer) {
    const double steps = finer * count;
    bool meets = true;
    for (std::size_t s = 1; s < model.steps.size(); ++s) {
      const double at = model.start(s) / end * steps;
      meets = meets && std::abs(at - std::round(at)) < 1e-6;
    }
    if (meets)
      return finer * count;
  }
  parts.say(
      model.steps[0].place, "*STEP", Fate::refused,
      "abut's steps have one size, and none above a twentieth of the smallest increment meets "
      "the ends of all steps: choose periods that have a common measure");
  return count;
}

/// Of the rule of Hilber, Hughes and Taylor.
double spectral_radius(double alpha) {
  return rounded((1.0 + alpha) / (1.0 - alpha), 6);
}

} // namespace

Scene translate(const Model& model, const std::string& name, Report report) {
  Scene scene;
  MeshTranslation mesh(model, report);
  Curves curves(model);
  const DeckParts parts{model, mesh, curves, report};
  const Runs displacements = runs_of(model, demands_of(model.boundaries), Kind::displacement,
                                     Renewal::Kind::boundary, report);
  const Runs forces =
      runs_of(model, demands_of(model.forces), Kind::load, Renewal::Kind::nodal, report);
  RigidBodies rigid(parts, displacements, forces);
  std::vector<std::string> materials;
  const std::string file = model.files[0].substr(model.files[0].find_last_of('/') + 1);
  std::string deck = "# From Abaqus or CalculiX: " + file +
                     "\ntitle: " + quoted(model.title.empty() ? name : model.title) +
                     "\nmesh: {file: " + quoted(name + ".exo") + "}\n";
  deck += materials_text(parts, materials);
  deck += bodies_text(parts, materials, rigid);
  deck += displacements_text(parts, displacements, rigid);
  const std::string loads = loads_text(parts, forces, rigid);
  const std::string contact = contact_text(parts);
  deck += loads + curves.text() + contact;
  deck += "time: {end: " + number_text(model.end()) +
          ", steps: " + std::to_string(step_count(parts)) + "}\n";
  if (model.is_dynamic())
    deck +=
        "dynamics: {spectral_radius: " + number_text(spectral_radius(model.steps[0].alpha)) + "}\n";
  scene.deck = deck + "output: {name: " + quoted(name + "_results") + "}\n";
  scene.mesh = std::move(mesh.data());
  scene.report = std::move(report);
  return scene;
}

Scene import(const std::string& text, const std::string& file, const std::string& name) {
  Report report;
  const ReadFile none = [](const std::string& path) -> std::string {
    throw InputError("cannot read the file '" + path + "'");
  };
  const Model model = read_model(text, file, none, report);
  report.require_nothing_refused(file);
  Scene scene = translate(model, name, std::move(report));
  scene.report.require_nothing_refused(file);
  return scene;
}

} // namespace abut::abaqus
