// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/amount.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut::solid {

enum class MaterialModel {
  neo_hookean,            ///< W = G/2 (I1-3) - G ln J + lambda/2 (ln J)^2, finite strain
  linear_elastic,         ///< small strain: sigma = C : sym grad u on the reference configuration
  saint_venant_kirchhoff, ///< second Piola-Kirchhoff stress linear in Green's strain
  holmes_mow,             ///< stiffens exponentially
  mooney_rivlin,          ///< uncoupled: c1 (I1* - 3) + c2 (I2* - 3) + K/2 (ln J)^2
  ogden,                  ///< uncoupled: powers of the isochoric principal stretches
  ogden_unconstrained,    ///< powers of the principal stretches, compressible
};

struct MaterialOptions {
  static constexpr std::size_t max_ogden_terms = 6;

  std::string name;
  MaterialModel model = MaterialModel::neo_hookean;
  double young = 0.0;               ///< [pressure]
  double poisson = 0.0;             ///< -1 < nu < 1/2
  double beta = 0.0;                ///< of holmes_mow, > 0
  double c1 = 0.0, c2 = 0.0;        ///< of mooney_rivlin [pressure]
  double bulk = 0.0;                ///< K of uncoupled models [pressure]
  double lambda = 0.0;              ///< of ogden_unconstrained [pressure]
  std::vector<double> coefficients; ///< c of Ogden's terms [pressure]
  std::vector<double> exponents;    ///< m of Ogden's terms, as many, not zero
  std::optional<double> density;    ///< for dynamics, > 0 [mass/length^3]

  bool has_young() const {
    return model == MaterialModel::neo_hookean || model == MaterialModel::linear_elastic ||
           model == MaterialModel::saint_venant_kirchhoff || model == MaterialModel::holmes_mow;
  }
  bool is_uncoupled() const {
    return model == MaterialModel::mooney_rivlin || model == MaterialModel::ogden;
  }
  bool has_ogden_terms() const {
    return model == MaterialModel::ogden || model == MaterialModel::ogden_unconstrained;
  }
  /// G at small strain; > 0 for a valid material [pressure].
  double shear_modulus() const {
    if (has_young())
      return 0.5 * young / (1.0 + poisson);
    if (model == MaterialModel::mooney_rivlin)
      return 2.0 * (c1 + c2);
    double sum = 0.0;
    for (const double c : coefficients)
      sum += c;
    return 0.5 * sum;
  }
};

/// What an element makes of its nodes' displacements.
enum class ElementFormulation {
  /// hex8 and wedge6 of uncoupled models: mean_dilatation; hex8 of others where Poisson's ratio is
  /// .49 or more: enhanced; else displacement
  automatic,
  displacement,    ///< strains of the shape functions, at all points
  mean_dilatation, ///< of uncoupled models: the volume changes by its mean over the element
  enhanced,        ///< hex8 that locks neither in bending nor near incompressibility
};

enum class LoadKind {
  traction,   ///< dead force per area of a side set, vector
  pressure,   ///< follower pressure per current area of a side set, positive pushes inwards
  body_force, ///< dead force per reference volume of a block, vector
  force,      ///< dead force on each node of a node set, vector
};

struct LoadOptions {
  std::string name;
  LoadKind kind = LoadKind::traction;
  std::string place; ///< side set, block or node set
  std::array<Amount, 3> vector{};
  bool current_area = false; ///< a traction is per current area, instead of per reference area
  Amount pressure;
  std::string curve;

  /// Whether forces depend on how the surface deforms.
  bool follows_surface() const {
    return kind == LoadKind::pressure || (kind == LoadKind::traction && current_area);
  }
};

} // namespace abut::solid
