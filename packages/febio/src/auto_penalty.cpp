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
  if (m.is_mooney_rivlin())
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

/// Faces with one stiffness: Young's modulus, or the penalty itself where they are rigid.
struct Group {
  bool rigid;
  double value;
  std::vector<mesh::SideData> sides;
};

bool same(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-6 * std::abs(a);
}

std::vector<Group> groups(const Surfaces& surfaces, const MeshTranslation& mesh,
                          const std::string& primary) {
  std::vector<Group> result;
  for (const mesh::SideData& side : surfaces.sides(primary)) {
    const Material& m = surfaces.material(side);
    const double v = m.is_rigid() ? m.numbers.at("v") : 0.0;
    const double value =
        m.is_rigid() ? m.numbers.at("E") / (1.0 - v * v) * mesh.inverse_depth(side) : young(m);
    auto group = std::find_if(result.begin(), result.end(), [&](const Group& g) {
      return g.rigid == m.is_rigid() && same(g.value, value);
    });
    if (group == result.end())
      group = result.insert(result.end(), {m.is_rigid(), value, {}});
    group->sides.push_back(side);
  }
  return result;
}

PassPenalty of_rigid(double value, double factor, const std::string& primary) {
  PassPenalty result;
  result.number = rounded(factor * value, 12);
  if (!(result.number > 0.0) || !std::isfinite(result.number))
    result.refused =
        "surface '" + primary +
        "' is rigid, and FEBio's penalty from the E and v of the rigid material is not "
        "above 0: give a number, auto_penalty 0";
  result.note = "FEBio: " + number_text(factor) + ", from the rigid material's E and v";
  return result;
}

PassPenalty of_primary(double modulus, double other, double factor) {
  PassPenalty result;
  result.automatic = true;
  const double ratio = modulus / std::min(modulus, other);
  result.number = factor;
  if (ratio > 1.0 + 1e-6) {
    result.number = rounded(factor * ratio, 12);
    result.note = "FEBio: " + number_text(factor) + ", of the primary's E, here " +
                  number_text(rounded(ratio, 4)) + " times the other's";
  }
  return result;
}

} // namespace

std::vector<PenaltyPart> automatic_penalty(const Model& model, const MeshTranslation& mesh,
                                           double factor, const std::string& primary,
                                           const std::string& secondary) {
  const Surfaces surfaces(model, mesh);
  constexpr std::size_t most = 8; // contacts made of one
  std::vector<PenaltyPart> parts;
  const std::vector<Group> all = groups(surfaces, mesh, primary);
  for (const Group& group : all)
    parts.push_back(
        {group.sides, group.rigid ? of_rigid(group.value, factor, primary)
                                  : of_primary(group.value, surfaces.softest(secondary), factor)});
  if (parts.size() > most)
    parts[0].penalty.refused =
        "surface '" + primary + "' is of " + std::to_string(parts.size()) +
        " stiffnesses, and FEBio takes the penalty of each face from its own: give a number, "
        "auto_penalty 0";
  return parts;
}

} // namespace abut::febio
