// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/deformation.hpp"

/// Principal axes of b, and tensors that have them.
namespace abut::solid {

/// b - I = sum over p of strain[p] n_p n_p, with n_p the column p of axes.
template <class T> struct PrincipalAxes {
  T strain[3]; ///< squares of the stretches minus one
  Mat<T, 3> axes;

  /// Jacobi's rotations: no loss when stretches are close, and exact for any scalar as long as they
  /// differ.
  KOKKOS_INLINE_FUNCTION explicit PrincipalAxes(Mat<T, 3> a) : axes(Mat<T, 3>::identity()) {
    constexpr int sweeps = 12;
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (int p = 0; p < 2; ++p)
        for (int q = p + 1; q < 3; ++q)
          rotate(a, p, q);
    for (int i = 0; i < 3; ++i)
      strain[i] = a[i][i];
  }
  /// ln of stretch p.
  KOKKOS_INLINE_FUNCTION T log_stretch(int p) const { return 0.5 * log_one_plus(strain[p]); }

  /// Sum over p of value[p] n_p n_p.
  KOKKOS_INLINE_FUNCTION Mat<T, 3> assemble(const T (&value)[3]) const {
    Mat<T, 3> s;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        s[i][j] = T(0.0);
        for (int p = 0; p < 3; ++p)
          s[i][j] += value[p] * axes[i][p] * axes[j][p];
        s[j][i] = s[i][j];
      }
    return s;
  }

private:
  KOKKOS_INLINE_FUNCTION void rotate(Mat<T, 3>& a, int p, int q) {
    using std::sqrt;
    const double off = value_of(a[p][q]), difference = value_of(a[q][q]) - value_of(a[p][p]);
    double size = 0.0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        size += value_of(a[i][j]) * value_of(a[i][j]);
    if (off * off <= 1e-40 * size)
      return;
    const T ratio = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
    const T root = sqrt(ratio * ratio + 1.0);
    const T t = difference * off >= 0.0 ? T(1.0 / (ratio + root)) : T(1.0 / (ratio - root));
    const T c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = T(0.0);
    const int r = 3 - p - q;
    const T rp = c * a[r][p] - s * a[r][q], rq = s * a[r][p] + c * a[r][q];
    a[r][p] = a[p][r] = rp;
    a[r][q] = a[q][r] = rq;
    for (int i = 0; i < 3; ++i) {
      const T ip = c * axes[i][p] - s * axes[i][q], iq = s * axes[i][p] + c * axes[i][q];
      axes[i][p] = ip;
      axes[i][q] = iq;
    }
  }
};

/// c from its components in principal axes: normal[p][q] between n_p n_p and n_q n_q, and
/// shear[p][q], p < q, of n_p n_q with itself.
KOKKOS_INLINE_FUNCTION void tangent_from_axes(const Mat3& axes, const double (&normal)[3][3],
                                              const double (&shear)[3][3], double c[6][6]) {
  double turn[6][6]; // Voigt stress in axes to Voigt stress
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w) {
      const int i = voigt_row[v], j = voigt_column[v], p = voigt_row[w], q = voigt_column[w];
      turn[v][w] = axes[i][p] * axes[j][q];
      if (p != q)
        turn[v][w] += axes[i][q] * axes[j][p];
    }
  double half[6][6]; // turn times c in axes
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w)
      half[v][w] =
          w < 3 ? turn[v][0] * normal[0][w] + turn[v][1] * normal[1][w] + turn[v][2] * normal[2][w]
                : turn[v][w] * shear[voigt_row[w]][voigt_column[w]];
  for (int v = 0; v < voigt_size; ++v)
    for (int w = 0; w < voigt_size; ++w) {
      c[v][w] = 0.0;
      for (int k = 0; k < voigt_size; ++k)
        c[v][w] += half[v][k] * turn[w][k];
    }
}

} // namespace abut::solid
