// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/principal.hpp"
#include "abut/solid/uncoupled.hpp"

namespace abut::solid {

/// Sum of up to six terms c/m^2 (l1^m + l2^m + l3^m - 3) in principal stretches l.
struct OgdenSum {
  static constexpr int max_terms = 6;
  int terms = 0;
  double c[max_terms] = {}; ///< [pressure]
  double m[max_terms] = {}; ///< not zero [1]

  /// Sum of c/m^2 (l^m - 1) by ln l.
  template <class T> KOKKOS_INLINE_FUNCTION T energy(const T& log_stretch) const {
    T w = T(0.0);
    for (int k = 0; k < terms; ++k)
      w += c[k] / (m[k] * m[k]) * exp_minus_one(T(m[k] * log_stretch));
    return w;
  }
  /// Its derivative by ln l: sum of c/m (l^m - 1) + c/m, without the constant.
  template <class T> KOKKOS_INLINE_FUNCTION T stress(const T& log_stretch) const {
    T g = T(0.0);
    for (int k = 0; k < terms; ++k)
      g += c[k] / m[k] * exp_minus_one(T(m[k] * log_stretch));
    return g;
  }
  /// Derivative of stress by ln l: sum of c l^m.
  KOKKOS_INLINE_FUNCTION double slope(double log_stretch) const {
    using std::exp;
    double q = 0.0;
    for (int k = 0; k < terms; ++k)
      q += c[k] * exp(m[k] * log_stretch);
    return q;
  }
  /// l_p^2 (stress(p) - stress(q)) / (l_p^2 - l_q^2), also where both stretches are the same.
  KOKKOS_INLINE_FUNCTION double difference(double log_p, double log_q) const {
    using std::exp;
    using std::expm1;
    const double log_ratio = 2.0 * (log_p - log_q);
    double d = 0.0;
    for (int k = 0; k < terms; ++k) {
      const double power = 0.5 * m[k];
      const double quotient =
          log_ratio == 0.0 ? power : expm1(power * log_ratio) / expm1(log_ratio);
      d += c[k] / m[k] * quotient * exp(2.0 * (log_p + (power - 1.0) * log_q));
    }
    return d;
  }
};

/// W = sum c/m^2 (l1*^m + l2*^m + l3*^m - 3) + K/2 (ln J)^2 with l* = J^(-1/3) l; at small strain
/// 2 G = sum c.
struct Ogden : Uncoupled<Ogden> {
  OgdenSum sum;

  Ogden(double k, const OgdenSum& terms) : Uncoupled{k}, sum(terms) {}

  template <class T> KOKKOS_INLINE_FUNCTION T isochoric_energy(const Deformation<T>& d) const {
    const PrincipalAxes<T> b(left_strain(d));
    const T third = log_one_plus(d.volume_change) / 3.0;
    return sum.energy(T(b.log_stretch(0) - third)) + sum.energy(T(b.log_stretch(1) - third)) +
           sum.energy(T(b.log_stretch(2) - third));
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION Mat<T, 3> isochoric_stress(const Deformation<T>& d) const {
    const PrincipalAxes<T> b(left_strain(d));
    const T third = log_one_plus(d.volume_change) / 3.0;
    T tau[3];
    for (int p = 0; p < 3; ++p)
      tau[p] = sum.stress(T(b.log_stretch(p) - third));
    const T mean = (tau[0] + tau[1] + tau[2]) / 3.0;
    for (int p = 0; p < 3; ++p)
      tau[p] -= mean;
    return b.assemble(tau);
  }
  KOKKOS_INLINE_FUNCTION void isochoric_tangent(const Deformation<double>& d, Mat3& s,
                                                double c[6][6]) const {
    const PrincipalAxes<double> b(left_strain(d));
    const double third = log_one_plus(d.volume_change) / 3.0;
    double log_stretch[3], tau[3], q[3], normal[3][3], shear[3][3];
    for (int p = 0; p < 3; ++p) {
      log_stretch[p] = b.log_stretch(p) - third;
      tau[p] = sum.stress(log_stretch[p]);
      q[p] = sum.slope(log_stretch[p]);
    }
    const double mean = (tau[0] + tau[1] + tau[2]) / 3.0;
    for (double& t : tau)
      t -= mean;
    for (int p = 0; p < 3; ++p)
      for (int r = 0; r < 3; ++r) {
        normal[p][r] = (q[0] + q[1] + q[2]) / 9.0 - (q[p] + q[r]) / 3.0;
        if (p == r)
          normal[p][r] += q[p] - 2.0 * tau[p];
        shear[p][r] = sum.difference(log_stretch[p], log_stretch[r]) - tau[p];
      }
    s = b.assemble(tau);
    tangent_from_axes(b.axes, normal, shear, c);
  }
};

/// W = sum c/m^2 (l1^m + l2^m + l3^m - 3 - m ln J) + lambda/2 (J - 1)^2; at small strain
/// 2 G = sum c, and lambda is Lame's constant.
struct OgdenUnconstrained {
  static constexpr bool finite_strain = true, uncoupled = false;
  OgdenSum sum;
  double lambda = 0.0; ///< Lame constant [pressure]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    const PrincipalAxes<T> b(left_strain(d));
    const T log_j = log_one_plus(d.volume_change);
    T w = 0.5 * lambda * d.volume_change * d.volume_change;
    for (int p = 0; p < 3; ++p)
      w += sum.energy(b.log_stretch(p));
    for (int k = 0; k < sum.terms; ++k)
      w -= sum.c[k] / sum.m[k] * log_j;
    return w;
  }
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    const PrincipalAxes<T> b(left_strain(d));
    const T pressure = lambda * d.jacobian() * d.volume_change;
    T tau[3];
    for (int p = 0; p < 3; ++p)
      tau[p] = sum.stress(b.log_stretch(p)) + pressure;
    return b.assemble(tau);
  }
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    const PrincipalAxes<double> b(left_strain(d));
    const double J = d.jacobian(), pressure = lambda * J * d.volume_change;
    double log_stretch[3], tau[3], normal[3][3], shear[3][3];
    for (int p = 0; p < 3; ++p) {
      log_stretch[p] = b.log_stretch(p);
      tau[p] = sum.stress(log_stretch[p]) + pressure;
    }
    for (int p = 0; p < 3; ++p)
      for (int r = 0; r < 3; ++r) {
        normal[p][r] = lambda * J * (J + d.volume_change); // of pressure by ln J
        if (p == r)
          normal[p][r] += sum.slope(log_stretch[p]) - 2.0 * tau[p];
        shear[p][r] = sum.difference(log_stretch[p], log_stretch[r]) - tau[p];
      }
    s = b.assemble(tau);
    tangent_from_axes(b.axes, normal, shear, c);
  }
};

} // namespace abut::solid
