// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <Kokkos_Macros.hpp>
#include <cmath>

/// Kinematics and small helpers that all materials share, on any scalar T.
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

/// exp(x) - 1 without loss at small x.
KOKKOS_INLINE_FUNCTION double exp_minus_one(double x) {
  using std::expm1;
  return expm1(x);
}
/// The same, differentiable.
template <class T> KOKKOS_INLINE_FUNCTION T exp_minus_one(const T& x) {
  using std::exp;
  using std::log;
  const T y = exp(x);
  const T rest = y - 1.0;
  if (value_of(rest) == 0.0)
    return x;
  return rest * x / log(y);
}

/// b - I = F F^T - I.
template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> left_strain(const Deformation<T>& d) {
  Mat<T, 3> e;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      e[i][j] = d.H[i][j] + d.H[j][i];
      for (int k = 0; k < 3; ++k)
        e[i][j] += d.H[i][k] * d.H[j][k];
      e[j][i] = e[i][j];
    }
  return e;
}

template <class T> KOKKOS_INLINE_FUNCTION T trace(const Mat<T, 3>& a) {
  return a[0][0] + a[1][1] + a[2][2];
}

/// c += factor a (x) a for a symmetric a, in Voigt order.
KOKKOS_INLINE_FUNCTION void add_dyad(double factor, const Mat3& a, double c[6][6]) {
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w)
      c[v][w] += factor * a[voigt_row[v]][voigt_column[v]] * a[voigt_row[w]][voigt_column[w]];
}

/// c_ijkl += factor (a_ik a_jl + a_il a_jk) / 2 for a symmetric a.
KOKKOS_INLINE_FUNCTION void add_symmetric_product(double factor, const Mat3& a, double c[6][6]) {
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w) {
      const int i = voigt_row[v], j = voigt_column[v], k = voigt_row[w], l = voigt_column[w];
      c[v][w] += 0.5 * factor * (a[i][k] * a[j][l] + a[i][l] * a[j][k]);
    }
}

KOKKOS_INLINE_FUNCTION void clear(double c[6][6]) {
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w)
      c[v][w] = 0.0;
}

/// F^-1, where det F > 0.
template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> inverse_gradient(const Deformation<T>& d) {
  Mat<T, 3> F = d.H;
  for (int i = 0; i < 3; ++i)
    F[i][i] += 1.0;
  return inverse(F, d.jacobian());
}

} // namespace abut::solid
