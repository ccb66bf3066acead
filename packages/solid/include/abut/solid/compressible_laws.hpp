// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/deformation.hpp"

/// Materials whose energy is a closed form of b = F F^T and J; see material.hpp for the members.
namespace abut::solid {

/// W = G/2 (I1-3) - G ln J + lambda/2 (ln J)^2;  J sigma = G (b - I) + lambda ln J I.
/// Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, 6.4.3.
struct NeoHookean {
  static constexpr bool finite_strain = true, uncoupled = false;
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
    Mat<T, 3> s = left_strain(d);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        s[i][j] *= shear;
      s[i][i] += lambda * log_j;
    }
    return s;
  }
};

/// sigma = lambda tr(e) I + 2 G e with e = sym(du/dX), on the reference configuration.
struct LinearElastic {
  static constexpr bool finite_strain = false, uncoupled = false;
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

/// W = lambda/2 (tr E)^2 + G E:E with Green's strain E, the second Piola-Kirchhoff stress is linear
/// in E. It softens under compression: det F -> 0 costs no energy.
struct SaintVenantKirchhoff {
  static constexpr bool finite_strain = true, uncoupled = false;
  double shear = 0.0;  ///< G [pressure]
  double lambda = 0.0; ///< Lame constant [pressure]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    // tr E and E:E from b - I, which has the eigenvalues of 2 E.
    const Mat<T, 3> e = left_strain(d);
    const T tr = 0.5 * trace(e);
    T square = T(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        square += 0.25 * e[i][j] * e[i][j];
    return 0.5 * lambda * tr * tr + shear * square;
  }
  /// J sigma = lambda tr E b + G b (b - I)
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    const Mat<T, 3> e = left_strain(d);
    const T pressure = 0.5 * lambda * trace(e);
    Mat<T, 3> s;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        s[i][j] = (pressure + shear) * e[i][j];
        for (int k = 0; k < 3; ++k)
          s[i][j] += shear * e[i][k] * e[k][j];
        if (i == j)
          s[i][j] += pressure;
        s[j][i] = s[i][j];
      }
    return s;
  }
  /// lambda b (x) b + 2 G b (.) b
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    s = stress(d);
    Mat3 b = left_strain(d);
    for (int i = 0; i < 3; ++i)
      b[i][i] += 1.0;
    clear(c);
    add_dyad(lambda, b, c);
    add_symmetric_product(2.0 * shear, b, c);
  }
};

/// W = (M / 4 beta) (e^Q - 1), Q = beta / M ((2G - lambda)(I1-3) + lambda (I2-3) - 2 M ln J) with
/// M = lambda + 2 G: a matrix that stiffens exponentially, linear elastic at small strain. Holmes
/// and Mow, J. Biomech. 23 (1990) 1145.
struct HolmesMow {
  static constexpr bool finite_strain = true, uncoupled = false;
  double shear = 0.0;  ///< G [pressure]
  double lambda = 0.0; ///< Lame constant [pressure]
  double beta = 0.0;   ///< stiffening, > 0 [1]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    return 0.25 * confined() / beta * exp_minus_one(exponent(d, left_strain(d)));
  }
  /// J sigma = e^Q / 2 ((2 G + lambda (I1 - 1)) b - lambda b^2 - M I)
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    const Mat<T, 3> e = left_strain(d);
    return stress(e, exponent(d, e));
  }
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    const Mat3 e = left_strain(d);
    const double q = exponent(d, e);
    s = stress(e, q);
    Mat3 b = e;
    for (int i = 0; i < 3; ++i)
      b[i][i] += 1.0;
    using std::exp;
    const double half = 0.5 * exp(q);
    clear(c);
    add_dyad(4.0 * beta / (confined() * 2.0 * half), s, c);
    add_dyad(2.0 * half * lambda, b, c);
    add_symmetric_product(-2.0 * half * lambda, b, c);
    add_symmetric_product(2.0 * half * confined(), Mat3::identity(), c);
  }

private:
  KOKKOS_INLINE_FUNCTION double confined() const { return lambda + 2.0 * shear; }

  /// e = b - I; I1 - 3 = tr e, I2 - 3 = 2 tr e + ((tr e)^2 - e:e) / 2.
  template <class T>
  KOKKOS_INLINE_FUNCTION T exponent(const Deformation<T>& d, const Mat<T, 3>& e) const {
    const T tr = trace(e);
    T square = T(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        square += e[i][j] * e[i][j];
    return beta / confined() *
           ((2.0 * shear + lambda) * tr + 0.5 * lambda * (tr * tr - square) -
            2.0 * confined() * log_one_plus(d.volume_change));
  }
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Mat<T, 3>& e, const T& q) const {
    using std::exp;
    const T half = 0.5 * exp(q), tr = trace(e);
    Mat<T, 3> s;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        // (2G + lambda (2 + tr)) (I + e) - lambda (I + 2 e + e^2) - M I
        s[i][j] = (2.0 * shear + lambda * tr) * e[i][j];
        for (int k = 0; k < 3; ++k)
          s[i][j] -= lambda * e[i][k] * e[k][j];
        if (i == j)
          s[i][j] += lambda * tr;
        s[i][j] *= half;
        s[j][i] = s[i][j];
      }
    return s;
  }
};

} // namespace abut::solid
