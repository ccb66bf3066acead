// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/material.hpp"

#include "abut/core/error.hpp"

#include <cmath>

namespace abut::solid {
namespace {

/// Solves the symmetric positive definite c x = b in place by Cholesky.
void solve(double c[6][6], double b[6]) {
  for (int i = 0; i < voigt_size; ++i)
    for (int j = 0; j <= i; ++j) {
      double s = c[i][j];
      for (int k = 0; k < j; ++k)
        s -= c[i][k] * c[j][k];
      if (i == j && !(s > 0.0)) // in exact arithmetic it is
        throw InputError(
            "a material's bulk and shear modulus lie too far apart for the arithmetic");
      c[i][j] = i == j ? std::sqrt(s) : s / c[j][j];
    }
  for (int i = 0; i < voigt_size; ++i) {
    for (int k = 0; k < i; ++k)
      b[i] -= c[i][k] * b[k];
    b[i] /= c[i][i];
  }
  for (int i = voigt_size - 1; i >= 0; --i) {
    for (int k = i + 1; k < voigt_size; ++k)
      b[i] -= c[k][i] * b[k];
    b[i] /= c[i][i];
  }
}

bool is_valid(const MaterialOptions& o) {
  if (!(o.shear_modulus() > 0.0))
    return false;
  if (o.has_young() && !(o.young > 0.0 && o.poisson > -1.0 && o.poisson < 0.5))
    return false;
  if (o.model == MaterialModel::holmes_mow && !(o.beta > 0.0))
    return false;
  if (o.is_uncoupled() && !(o.bulk > 0.0))
    return false;
  if (!o.has_ogden_terms())
    return true;
  if (o.exponents.size() != o.coefficients.size() || o.exponents.empty() ||
      o.exponents.size() > MaterialOptions::max_ogden_terms)
    return false;
  for (const double m : o.exponents)
    if (m == 0.0)
      return false;
  return o.model == MaterialModel::ogden || o.lambda >= 0.0;
}

OgdenSum ogden_sum(const MaterialOptions& o) {
  OgdenSum sum;
  sum.terms = static_cast<int>(o.exponents.size());
  for (std::size_t k = 0; k < o.exponents.size(); ++k) {
    sum.c[k] = o.coefficients[k];
    sum.m[k] = o.exponents[k];
  }
  return sum;
}

} // namespace

Material make_material(const MaterialOptions& options) {
  ABUT_REQUIRE(is_valid(options), "material '" + options.name + "' is not valid");
  const double shear = options.shear_modulus(), nu = options.poisson;
  const double lambda = 2.0 * shear * nu / (1.0 - 2.0 * nu);
  switch (options.model) {
  case MaterialModel::linear_elastic:
    return LinearElastic{shear, lambda};
  case MaterialModel::saint_venant_kirchhoff:
    return SaintVenantKirchhoff{shear, lambda};
  case MaterialModel::holmes_mow:
    return HolmesMow{shear, lambda, options.beta};
  case MaterialModel::mooney_rivlin:
    return MooneyRivlin(options.bulk, options.c1, options.c2);
  case MaterialModel::ogden:
    return Ogden(options.bulk, ogden_sum(options));
  case MaterialModel::ogden_unconstrained:
    return OgdenUnconstrained{ogden_sum(options), options.lambda};
  case MaterialModel::neo_hookean:
    break;
  }
  return NeoHookean{shear, lambda};
}

LameConstants at_rest(const Material& material) {
  return std::visit(
      [](const auto& m) -> LameConstants {
        Mat3 stress;
        double c[6][6];
        m.tangent(Deformation<double>(Mat3::zero()), stress, c);
        return {c[3][3], c[0][1]};
      },
      material);
}

double modulus_along(const Material& material, const Vec3& n) {
  return std::visit(
      [&](const auto& m) {
        Mat3 stress;
        double c[6][6], traction[6], strain[6];
        m.tangent(Deformation<double>(Mat3::zero()), stress, c);
        for (int v = 0; v < voigt_size; ++v)
          strain[v] = traction[v] = n[voigt_row[v]] * n[voigt_column[v]];
        solve(c, strain); // from the uniaxial stress n x n to its strains, shears as engineering
        double compliance = 0.0;
        for (int v = 0; v < voigt_size; ++v)
          compliance += traction[v] * strain[v];
        return 1.0 / compliance;
      },
      material);
}

} // namespace abut::solid
