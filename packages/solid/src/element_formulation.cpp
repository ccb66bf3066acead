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
    return cell == CellType::hex8 && is_uncoupled(material) ? ElementFormulation::mean_dilatation
                                                            : ElementFormulation::displacement;
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
  const LameConstants law = at_rest(material);
  const double poisson = 0.5 * law.lambda / (law.lambda + law.shear);
  const bool simplex = cell == CellType::tet4 || cell == CellType::wedge6;
  const bool plain =
      formulation == ElementFormulation::displacement && (simplex || cell == CellType::hex8);
  return {poisson >= nearly_incompressible && (plain || simplex), simplex};
}

} // namespace abut::solid
