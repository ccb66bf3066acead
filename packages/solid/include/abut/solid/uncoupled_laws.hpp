// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/uncoupled.hpp"

namespace abut::solid {

/// W = c1 (I1* - 3) + c2 (I2* - 3) + K/2 (ln J)^2 with the invariants of b* = J^(-2/3) b; at small
/// strain G = 2 (c1 + c2). Holzapfel, Nonlinear Solid Mechanics, 6.4-6.6.
struct MooneyRivlin : Uncoupled<MooneyRivlin> {
  double c1 = 0.0, c2 = 0.0; ///< [pressure]

  MooneyRivlin(double k, double first, double second) : Uncoupled{k}, c1(first), c2(second) {}

  template <class T> KOKKOS_INLINE_FUNCTION T isochoric_energy(const Deformation<T>& d) const {
    const Mat<T, 3> e = left_strain(d);
    const T s = scale(d), tr = trace(e);
    T square = T(0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        square += e[i][j] * e[i][j];
    const T first = s * (3.0 + tr) - 3.0;
    const T second = s * s * (3.0 + 2.0 * tr + 0.5 * (tr * tr - square)) - 3.0;
    return c1 * first + c2 * second;
  }
  /// dev(2 (c1 + c2 I1*) b* - 2 c2 b*^2)
  template <class T>
  KOKKOS_INLINE_FUNCTION Mat<T, 3> isochoric_stress(const Deformation<T>& d) const {
    const Mat<T, 3> e = left_strain(d);
    const T s = scale(d);
    const T first = 2.0 * s * (c1 + c2 * s * (3.0 + trace(e))), second = 2.0 * c2 * s * s;
    Mat<T, 3> tau;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        // b = I + e; multiples of I have no deviator.
        tau[i][j] = (first - 2.0 * second) * e[i][j];
        for (int k = 0; k < 3; ++k)
          tau[i][j] -= second * e[i][k] * e[k][j];
        tau[j][i] = tau[i][j];
      }
    const T mean = trace(tau) / 3.0;
    for (int i = 0; i < 3; ++i)
      tau[i][i] -= mean;
    return tau;
  }
  KOKKOS_INLINE_FUNCTION void isochoric_tangent(const Deformation<double>& d, Mat3& s,
                                                double c[6][6]) const {
    s = isochoric_stress(d);
    Mat3 b = left_strain(d); // becomes b*
    for (int i = 0; i < 3; ++i)
      b[i][i] += 1.0;
    for (auto& row : b.m)
      for (double& value : row)
        value *= scale(d);
    const double i1 = trace(b);
    double square = 0.0; // trace of b*^2
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        square += b[i][j] * b[i][j];
    const double whole = 2.0 * (c1 + c2 * i1) * i1 - 2.0 * c2 * square; // trace before the deviator
    clear(c);
    add_dyad(4.0 * c2, b, c);
    add_symmetric_product(-4.0 * c2, b, c);
    project(c);
    add_symmetric_product(2.0 / 3.0 * whole, Mat3::identity(), c);
    add_dyad(-2.0 / 9.0 * whole, Mat3::identity(), c);
    for (int v = 0; v < voigt_size; ++v)
      for (int i = 0; i < 3; ++i) {
        c[v][i] -= 2.0 / 3.0 * s[voigt_row[v]][voigt_column[v]];
        c[i][v] -= 2.0 / 3.0 * s[voigt_row[v]][voigt_column[v]];
      }
  }

private:
  /// J^(-2/3)
  template <class T> KOKKOS_INLINE_FUNCTION static T scale(const Deformation<T>& d) {
    using std::exp;
    return exp(-2.0 / 3.0 * log_one_plus(d.volume_change));
  }
  /// c becomes P : c : P, P the projection on deviators.
  KOKKOS_INLINE_FUNCTION static void project(double c[6][6]) {
    for (int w = 0; w < voigt_size; ++w) {
      const double mean = (c[0][w] + c[1][w] + c[2][w]) / 3.0;
      for (int i = 0; i < 3; ++i)
        c[i][w] -= mean;
    }
    for (int v = 0; v < voigt_size; ++v) {
      const double mean = (c[v][0] + c[v][1] + c[v][2]) / 3.0;
      for (int i = 0; i < 3; ++i)
        c[v][i] -= mean;
    }
  }
};

} // namespace abut::solid
