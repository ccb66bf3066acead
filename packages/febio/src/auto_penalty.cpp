// SPDX-License-Identifier: BSD-3-Clause
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::febio {

namespace {

double young(double bulk, double shear) {
  return 9.0 * bulk * shear / (3.0 * bulk + shear);
}

/// Young's modulus without strain.
double young(const Material& m) {
  const auto& x = m.numbers;
  if (m.type == "Mooney-Rivlin")
    return young(x.at("k"), 2.0 * (x.at("c1") + x.at("c2")));
  if (m.type != "Ogden" && m.type != "Ogden unconstrained")
    return x.at("E");
  double shear = 0.0;
  for (const char* c : {"c1", "c2", "c3", "c4", "c5", "c6"})
    shear += 0.5 * x.at(c);
  return m.type == "Ogden" ? young(x.at("k"), shear) : young(x.at("cp") + shear / 1.5, shear);
}

class Surfaces {
public:
  Surfaces(const Model& model, const MeshTranslation& mesh) : model_(model), mesh_(mesh) {}

  const std::vector<mesh::SideData>& sides(const std::string& surface) const {
    return mesh_.data().side_sets.at(surface);
  }
  const Material& material(const mesh::SideData& side) const {
    return *model_.material(model_.mesh.domains[static_cast<std::size_t>(side.block)].material);
  }
  double softest(const std::string& surface) const {
    double least = std::numeric_limits<double>::max();
    for (const mesh::SideData& side : sides(surface))
      if (!material(side).is_rigid())
        least = std::min(least, young(material(side)));
    return least;
  }

private:
  const Model& model_;
  const MeshTranslation& mesh_;
};

bool same(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::abs(a);
}

/// One number for all faces of a surface of which at least one is rigid.
PassPenalty of_rigid(const Surfaces& surfaces, const MeshTranslation& mesh, double factor,
                     const std::string& primary) {
  PassPenalty result;
  for (const mesh::SideData& side : surfaces.sides(primary)) {
    const Material& m = surfaces.material(side);
    const double v = m.is_rigid() ? m.numbers.at("v") : 0.0;
    const double e = m.is_rigid() ? m.numbers.at("E") / (1.0 - v * v) : young(m);
    const double penalty = factor * e * mesh.inverse_depth(side);
    if (result.number != 0.0 && !same(result.number, penalty))
      result.refused = "surface '" + primary +
                       "' is rigid, and FEBio takes a penalty for each of its faces from the E and "
                       "v of the rigid material: give a number, auto_penalty 0";
    result.number = penalty;
  }
  if (!(result.number > 0.0) || !std::isfinite(result.number))
    result.refused =
        "surface '" + primary +
        "' is rigid, and FEBio's penalty from the E and v of the rigid material is not "
        "above 0: give a number, auto_penalty 0";
  result.number = rounded(result.number, 12);
  result.note = "FEBio: " + number_text(factor) + ", from the rigid material's E and v";
  return result;
}

} // namespace

PassPenalty automatic_penalty(const Model& model, const MeshTranslation& mesh, double factor,
                              const std::string& primary, const std::string& secondary) {
  const Surfaces surfaces(model, mesh);
  const std::vector<mesh::SideData>& sides = surfaces.sides(primary);
  if (std::any_of(sides.begin(), sides.end(),
                  [&](const mesh::SideData& s) { return surfaces.material(s).is_rigid(); }))
    return of_rigid(surfaces, mesh, factor, primary);
  const double of_primary = surfaces.softest(primary);
  PassPenalty result;
  result.automatic = true;
  for (const mesh::SideData& side : sides)
    if (!same(of_primary, young(surfaces.material(side))))
      result.refused = "surface '" + primary +
                       "' is of several stiffnesses, and FEBio takes the penalty of each face from "
                       "its own: give a number, auto_penalty 0, or a contact for each material";
  const double ratio = of_primary / std::min(of_primary, surfaces.softest(secondary));
  result.number = factor;
  if (ratio > 1.0 + 1e-6) {
    result.number = rounded(factor * ratio, 12);
    result.note = "FEBio: " + number_text(factor) + ", of the primary's E, here " +
                  number_text(rounded(ratio, 4)) + " times the other's";
  }
  return result;
}

} // namespace abut::febio
