// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/deformation.hpp"

/// How much more than the mean an enhanced hex8 (enhanced.hpp) is stretched at a point.
namespace abut::solid {

/// The stretch S of a symmetric strain E has the shape of I + E, and its change of volume is tr E,
///   S = phi (I + E),   phi^3 = (1 + tr E) / det(I + E)
/// so that strains that hold the volume to first order hold it. There is no stretch where I + E is
/// not positive definite or tr E <= -1: before, S tends to infinity or zero, and the energy of laws
/// that resist both with it. At small strain S = I + E.
template <class T> struct EnhancedStretch {
  Mat<T, 3> excess;   ///< S - I
  Mat<T, 3> inverse;  ///< (I + E)^-1; I at small strain
  T volume;           ///< 1 + tr E; 1 at small strain
  double least = 1.0; ///< of the volume and the leading minors of I + E

  /// Returns false when there is no stretch.
  KOKKOS_INLINE_FUNCTION bool set(bool finite_strain, const Mat<T, 3>& E) {
    excess = E;
    inverse = Mat<T, 3>::identity();
    volume = T(1.0);
    if (!finite_strain)
      return true;
    const Deformation<T> d(E);
    const T tr = trace(E);
    volume += tr;
    const T first = 1.0 + E[0][0];
    const T second = first * (1.0 + E[1][1]) - E[0][1] * E[0][1];
    least = value_of(volume);
    for (const double minor : {value_of(first), value_of(second), value_of(d.jacobian())})
      least = least <= minor ? least : minor;
    if (!(least > 0.0))
      return false;
    inverse = inverse_gradient(d);
    using std::cbrt;
    const T change = (tr - d.volume_change) / d.jacobian(); // phi^3 - 1
    const T phi = cbrt(1.0 + change);
    const T more = change / (1.0 + phi * (1.0 + phi)); // phi - 1 without the loss of a difference
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        excess[i][j] += more * E[i][j];
      excess[i][i] += more;
    }
    return true;
  }
};

/// Derivative of the energy by E where F = mean S has the Kirchhoff stress tau:
///   sym(Z (I + E)^-1) + tr tau / 3 (I / (1 + tr E) - (I + E)^-1),   Z = mean^T tau mean^-T
template <class T> struct StretchStress {
  Mat<T, 3> back;       ///< sym(Z (I + E)^-1)
  Mat<T, 3> derivative; ///< by E
  T pressure;           ///< tr tau / 3

  KOKKOS_INLINE_FUNCTION StretchStress(const Mat<T, 3>& mean, const Mat<T, 3>& mean_inverse,
                                       const EnhancedStretch<T>& stretch, const Mat<T, 3>& tau) {
    const Mat<T, 3> z = (transpose(mean) * tau) * (transpose(mean_inverse) * stretch.inverse);
    pressure = trace(tau) / 3.0;
    const T volume = pressure / stretch.volume;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        back[i][j] = 0.5 * (z[i][j] + z[j][i]);
        derivative[i][j] = back[i][j] - pressure * stretch.inverse[i][j];
        if (i == j)
          derivative[i][j] += volume;
      }
  }
};

/// Second derivatives of a point's energy: by E, twice, and by E and the rate of deformation of the
/// mean. With M = mean dS S^-1 mean^-1 for each component of E, m = d ln phi, G = (I + E)^-1:
///   mixed:  c sym M + M tau + tau M^T
///   strain: M (c sym M + M tau) + 2 m sym(Z G) dE
///           + tr tau (m m + tr(G dE G dE) / 3 - (tr dE)^2 / (1 + tr E)^2 / 3)
struct StretchTangent {
  static constexpr int lanes = 8;   ///< components of E, and none
  double strain[voigt_size][lanes]; ///< by components of E, off-diagonal ones counted twice
  double mixed[voigt_size][lanes];  ///< [stress][E]

  KOKKOS_INLINE_FUNCTION explicit StretchTangent(const Mat3& mean) {
    for (int i = 0; i < 3; ++i)
      for (int v = 0; v < voigt_size; ++v) {
        const int k = voigt_row[v], l = voigt_column[v];
        first[i][v] = mean[i][k];
        second[i][v] = k == l ? 0.0 : mean[i][l];
      }
  }

  /// tau, c: of the law at F = mean S; at small strain tau is zero.
  KOKKOS_INLINE_FUNCTION void set(const Mat3& mean_inverse, const EnhancedStretch<double>& stretch,
                                  const StretchStress<double>& stress, const Mat3& tau,
                                  const double (&c)[6][6]) {
    const Mat3& G = stretch.inverse;
    const Mat3 right = G * mean_inverse;
    const double part = 1.0 / stretch.volume;
    double volume[lanes] = {}, by_volume[lanes] = {}; // m, sym(Z G) dE
    double of_first[3][lanes] = {}, of_second[3][lanes] = {};
    for (int v = 0; v < voigt_size; ++v) {
      const int k = voigt_row[v], l = voigt_column[v];
      volume[v] = k == l ? (part - G[k][k]) / 3.0 : -2.0 * G[k][l] / 3.0;
      by_volume[v] = k == l ? stress.back[k][k] : 2.0 * stress.back[k][l];
      for (int i = 0; i < 3; ++i) {
        of_first[i][v] = right[l][i];
        of_second[i][v] = right[k][i];
      }
    }
    double moved[3][3][lanes], stretched[3][3][lanes]; // M; c sym M + M tau
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
#pragma omp simd
        for (int v = 0; v < lanes; ++v)
          moved[i][j][v] = first[i][v] * of_first[j][v] + second[i][v] * of_second[j][v] +
                           (i == j ? volume[v] : 0.0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
#pragma omp simd
        for (int v = 0; v < lanes; ++v)
          stretched[i][j][v] =
              moved[i][0][v] * tau[0][j] + moved[i][1][v] * tau[1][j] + moved[i][2][v] * tau[2][j];
    for (int x = 0; x < voigt_size; ++x) {
      const int i = voigt_row[x], j = voigt_column[x];
      const double* d = c[x];
#pragma omp simd
      for (int v = 0; v < lanes; ++v) {
        const double law = d[0] * moved[0][0][v] + d[1] * moved[1][1][v] + d[2] * moved[2][2][v] +
                           d[3] * (moved[0][1][v] + moved[1][0][v]) +
                           d[4] * (moved[1][2][v] + moved[2][1][v]) +
                           d[5] * (moved[0][2][v] + moved[2][0][v]);
        mixed[x][v] = law + stretched[i][j][v] + stretched[j][i][v];
        stretched[i][j][v] += law;
        if (i != j)
          stretched[j][i][v] += law;
      }
    }
    for (int v = 0; v < voigt_size; ++v) {
      const int k = voigt_row[v], l = voigt_column[v];
      const double by_product = 3.0 * stress.pressure * volume[v] + by_volume[v],
                   by_turned = stress.pressure * (k == l ? 1.0 : 2.0);
      // G dE G, of which all lanes take their component
      double g[3][3];
      for (int m = 0; m < 3; ++m)
        for (int n = 0; n < 3; ++n)
          g[m][n] = 0.5 * by_turned * (G[m][k] * G[l][n] + G[m][l] * G[k][n]);
      if (k == l)
        for (int m = 0; m < 3; ++m)
          g[m][m] -= stress.pressure * part * part;
      const double turned[lanes] = {g[0][0],       g[1][1],       g[2][2],
                                    2.0 * g[0][1], 2.0 * g[1][2], 2.0 * g[0][2]};
#pragma omp simd
      for (int w = 0; w < lanes; ++w) {
        double sum = turned[w] + volume[w] * by_product + volume[v] * by_volume[w];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            sum += moved[i][j][v] * stretched[i][j][w];
        strain[v][w] = sum;
      }
    }
  }

private:
  double first[3][lanes] = {}, second[3][lanes] = {}; ///< columns of the mean
};

} // namespace abut::solid
