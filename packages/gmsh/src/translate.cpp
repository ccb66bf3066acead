// SPDX-License-Identifier: BSD-3-Clause
#include "abut/gmsh/import.hpp"
#include "deck_text.hpp"
#include "make_mesh.hpp"

#include "abut/core/error.hpp"

#include <utility>

namespace abut::gmsh {

Scene translate(const Model& model, const std::string& name, translation::Report report) {
  Scene scene;
  scene.mesh = make_mesh(model, report);
  scene.mesh.title = model.file;
  scene.report = std::move(report);
  if (scene.report.count(translation::Fate::refused) == 0)
    scene.deck = deck_text(scene.mesh, name);
  return scene;
}

Scene import(const std::string& text, const std::string& file, const std::string& name) {
  translation::Report report;
  const Model model = read_model(text, file, report);
  Scene scene = translate(model, name, std::move(report));
  scene.report.require_nothing_refused(file);
  return scene;
}

} // namespace abut::gmsh
