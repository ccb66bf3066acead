// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"
#include "abut/solid/material.hpp"
#include "abut/solid/options.hpp"

namespace abut::solid {

/// As in decks: "enhanced", ...
const char* name_of(ElementFormulation formulation);

/// What cells of this type and material are: what was asked for, or what `automatic` means for
/// them. Throws InputError where there are no such elements.
ElementFormulation element_formulation(ElementFormulation asked, fem::CellType cell,
                                       const Material& material);

/// What such elements are known to be too stiff against.
struct Locking {
  bool volume = false;  ///< a volume that hardly changes: Poisson's ratio at rest is .49 or more
  bool bending = false; ///< bending, even with several elements across
};
Locking locking(ElementFormulation formulation, fem::CellType cell, const Material& material);

} // namespace abut::solid
