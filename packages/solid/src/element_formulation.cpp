// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/element_formulation.hpp"

#include "abut/core/error.hpp"

namespace abut::solid {
namespace {

using fem::CellType;

constexpr double nearly_incompressible = 0.49; ///< Poisson's ratio

bool is_uncoupled(const Material& material) {
  return std::visit([](const auto& m) { return m.uncoupled; }, material);
}

double poisson_at_rest(const Material& material) {
  const LameConstants law = at_rest(material);
  return 0.5 * law.lambda / (law.lambda + law.shear);
}

/// The cheapest that does not lock in volume. Against bending 'enhanced' is asked for by name:
/// under contact its faces bend more easily than those of 'displacement', and more first steps are
/// cut.
ElementFormulation automatic_formulation(CellType cell, const Material& material) {
  if (is_uncoupled(material))
    return cell == CellType::hex8 || cell == CellType::wedge6 ? ElementFormulation::mean_dilatation
                                                              : ElementFormulation::displacement;
  return cell == CellType::hex8 && poisson_at_rest(material) >= nearly_incompressible
             ? ElementFormulation::enhanced
             : ElementFormulation::displacement;
}

} // namespace

const char* name_of(ElementFormulation formulation) {
  switch (formulation) {
  case ElementFormulation::automatic:
    return "automatic";
  case ElementFormulation::displacement:
    return "displacement";
  case ElementFormulation::mean_dilatation:
    return "mean_dilatation";
  case ElementFormulation::enhanced:
    break;
  }
  return "enhanced";
}

ElementFormulation element_formulation(ElementFormulation asked, CellType cell,
                                       const Material& material) {
  const std::string of = std::string("; these are ") + fem::info(cell).name;
  switch (asked) {
  case ElementFormulation::automatic:
    return automatic_formulation(cell, material);
  case ElementFormulation::enhanced:
    if (cell != CellType::hex8)
      throw InputError("'enhanced' elements are hex8" + of);
    break;
  case ElementFormulation::mean_dilatation:
    if (cell != CellType::hex8 && cell != CellType::wedge6)
      throw InputError("elements with a 'mean_dilatation' are hex8 or wedge6" + of);
    if (!is_uncoupled(material))
      throw InputError("a 'mean_dilatation' needs an uncoupled material, mooney_rivlin or ogden");
    break;
  case ElementFormulation::displacement:
    break;
  }
  return asked;
}

Locking locking(ElementFormulation formulation, CellType cell, const Material& material) {
  const bool simplex = cell == CellType::tet4 || cell == CellType::wedge6;
  const bool plain_hex = cell == CellType::hex8 && formulation == ElementFormulation::displacement;
  return {(simplex || plain_hex) && poisson_at_rest(material) >= nearly_incompressible, simplex};
}

} // namespace abut::solid
