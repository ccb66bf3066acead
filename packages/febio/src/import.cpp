// SPDX-License-Identifier: BSD-3-Clause
#include "abut/febio/import.hpp"

#include "deck_text.hpp"

namespace abut::febio {

Scene translate(const Model& model, const std::string& name, Report report) {
  MeshTranslation mesh(model, report);
  Scene scene;
  scene.deck = deck_text(model, name, mesh, report);
  scene.mesh = std::move(mesh.data());
  scene.report = std::move(report);
  return scene;
}

Scene import(const std::string& text, const std::string& file, const std::string& name) {
  Report report;
  const Model model = read_model(text, file, report);
  report.require_nothing_refused(file);
  Scene scene = translate(model, name, std::move(report));
  scene.report.require_nothing_refused(file);
  return scene;
}

} // namespace abut::febio
