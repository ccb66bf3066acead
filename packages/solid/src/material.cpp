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
      ABUT_REQUIRE(i != j || s > 0.0, "the material's tangent is not positive definite");
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

} // namespace

Material make_material(const MaterialOptions& options) {
  const double e = options.young, nu = options.poisson;
  ABUT_REQUIRE(e > 0.0 && nu > -1.0 && nu < 0.5, "material '" + options.name + "' is not valid");
  const double shear = 0.5 * e / (1.0 + nu), lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  if (options.model == MaterialModel::linear_elastic)
    return LinearElastic{shear, lambda};
  return NeoHookean{shear, lambda};
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
