// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/solid/options.hpp"

#include <Kokkos_Macros.hpp>
#include <variant>

/// Materials: stress and tangent at a point, on any scalar T (double or an AD type).
///
/// A material is a struct with
///   static constexpr bool finite_strain;
///   T energy(const Deformation<T>&) const;               per reference volume [pressure]
///   Mat<T,3> stress(const Deformation<T>&) const;        Kirchhoff stress J sigma if
///   finite_strain,
///                                                        else the small-strain stress
///   void tangent(const Deformation<double>&, Mat3& stress, double c[6][6]) const;
/// c relates the Lie derivative of the Kirchhoff stress to the rate of deformation (finite strain)
/// or stress to strain (small strain); Voigt order xx, yy, zz, xy, yz, xz with engineering shears.
/// A new material needs these members, a place in `Material` and in make_material, nothing else.
namespace abut::solid {

constexpr int voigt_size = 6;
constexpr int voigt_row[voigt_size] = {0, 1, 2, 0, 1, 0};
constexpr int voigt_column[voigt_size] = {0, 1, 2, 1, 2, 2};

/// The displacement gradient instead of F: at small strain nothing is lost to cancellation.
template <class T> struct Deformation {
  Mat<T, 3> H;     ///< du/dX = F - I
  T volume_change; ///< J - 1

  KOKKOS_INLINE_FUNCTION explicit Deformation(const Mat<T, 3>& gradient) : H(gradient) {
    const T trace = H[0][0] + H[1][1] + H[2][2];
    const T second = H[0][0] * H[1][1] - H[0][1] * H[1][0] + H[1][1] * H[2][2] - H[1][2] * H[2][1] +
                     H[0][0] * H[2][2] - H[0][2] * H[2][0];
    volume_change = trace + second + det(H);
  }
  KOKKOS_INLINE_FUNCTION T jacobian() const { return 1.0 + volume_change; }
};

/// log(1 + x) without loss at small x, differentiable (what rounding drops from 1 + x is put back).
template <class T> KOKKOS_INLINE_FUNCTION T log_one_plus(const T& x) {
  using std::log;
  const T y = 1.0 + x;
  const T dropped = x - (y - 1.0);
  return log(y) + dropped / y;
}

/// c = lambda 1x1 + 2 mu I_sym.
KOKKOS_INLINE_FUNCTION void isotropic_tangent(double lambda, double mu, double c[6][6]) {
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      c[i][j] = i < 3 && j < 3 ? lambda : 0.0;
  for (int i = 0; i < 3; ++i) {
    c[i][i] += 2.0 * mu;
    c[i + 3][i + 3] = mu;
  }
}

/// W = G/2 (I1-3) - G ln J + lambda/2 (ln J)^2;  J sigma = G (b - I) + lambda ln J I.
/// Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, 6.4.3.
struct NeoHookean {
  static constexpr bool finite_strain = true;
  double shear = 0.0;  ///< G [pressure]
  double lambda = 0.0; ///< Lame constant [pressure]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    const T log_j = log_one_plus(d.volume_change);
    T invariant = T(0.0); // I1 - 3
    for (int i = 0; i < 3; ++i) {
      invariant += 2.0 * d.H[i][i];
      for (int j = 0; j < 3; ++j)
        invariant += d.H[i][j] * d.H[i][j];
    }
    return 0.5 * shear * invariant - shear * log_j + 0.5 * lambda * log_j * log_j;
  }
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    return stress(d, log_one_plus(d.volume_change));
  }
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    const double log_j = log_one_plus(d.volume_change);
    s = stress(d, log_j);
    isotropic_tangent(lambda, shear - lambda * log_j, c);
  }

private:
  template <class T>
  KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d, const T& log_j) const {
    Mat<T, 3> s;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        T strain = d.H[i][j] + d.H[j][i]; // b - I
        for (int k = 0; k < 3; ++k)
          strain += d.H[i][k] * d.H[j][k];
        s[i][j] = shear * strain;
        if (i == j)
          s[i][j] += lambda * log_j;
        s[j][i] = s[i][j];
      }
    return s;
  }
};

/// sigma = lambda tr(e) I + 2 G e with e = sym(du/dX), on the reference configuration.
struct LinearElastic {
  static constexpr bool finite_strain = false;
  double shear = 0.0;  ///< G [pressure]
  double lambda = 0.0; ///< Lame constant [pressure]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    const Mat<T, 3> s = stress(d);
    T w = T(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        w += 0.5 * s[i][j] * d.H[i][j];
    return w;
  }
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    const T pressure = lambda * (d.H[0][0] + d.H[1][1] + d.H[2][2]);
    Mat<T, 3> s;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        s[i][j] = shear * (d.H[i][j] + d.H[j][i]);
        if (i == j)
          s[i][j] += pressure;
        s[j][i] = s[i][j];
      }
    return s;
  }
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    s = stress(d);
    isotropic_tangent(lambda, shear, c);
  }
};

using Material = std::variant<NeoHookean, LinearElastic>;

/// Options must be valid: young > 0, -1 < poisson < 1/2 (else Defect).
Material make_material(const MaterialOptions& options);

/// Young's modulus along the unit vector n in the undeformed state: 1 / (n x n : C^-1 : n x n).
double modulus_along(const Material& material, const Vec3& n);

} // namespace abut::solid
