// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/material.hpp"

#include <vector>

namespace abut::solid {

/// Results of one block's elements on this rank.
struct ElementFields {
  std::vector<double> stress;    ///< (E, 6) Cauchy, averaged over the element; xx yy zz xy yz xz
  std::vector<double> von_mises; ///< (E) of the averaged stress
  std::vector<double> energy;    ///< (E) strain energy of the element [force length]

  double total_energy() const; ///< over this rank's elements
};

/// fields.u as for SolidContribution, ghosts up to date. Points with det F <= 0 are left out.
ElementFields element_fields(const mesh::Mesh& mesh, int block, const Material& material,
                             const NodalFields& fields);

/// Von Mises stress of a stress in the order xx yy zz xy yz xz.
double von_mises(const double stress[6]);

} // namespace abut::solid
