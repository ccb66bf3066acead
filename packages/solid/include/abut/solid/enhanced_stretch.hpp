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
    const T scale = 1.0 / d.jacobian();
    invert(E, scale);
    using std::cbrt;
    const T change = (tr - d.volume_change) * scale; // phi^3 - 1
    const T phi = cbrt(1.0 + change);
    const T more = change / (1.0 + phi * (1.0 + phi)); // phi - 1 without the loss of a difference
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        excess[i][j] += more * E[i][j];
      excess[i][i] += more;
    }
    return true;
  }

private:
  /// scale: 1 / det(I + E)
  KOKKOS_INLINE_FUNCTION void invert(const Mat<T, 3>& E, const T& scale) {
    Mat<T, 3> a = E;
    for (int i = 0; i < 3; ++i)
      a[i][i] += 1.0;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
        inverse[i][j] = inverse[j][i] = scale * (a[k][m] * a[l][n] - a[k][n] * a[l][m]);
      }
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

/// Lanes of the components of E: which they are, as numbers.
struct StrainLanes {
  static constexpr int lanes = 8; ///< components of E, and none
  double row[3][lanes] = {}, column[3][lanes] = {}, trace[lanes] = {};
  double pair[voigt_size][lanes] = {}, times[lanes] = {}; ///< off-diagonal ones are counted twice

  KOKKOS_INLINE_FUNCTION constexpr StrainLanes() {
    for (int v = 0; v < voigt_size; ++v) {
      row[voigt_row[v]][v] = column[voigt_column[v]][v] = 1.0;
      trace[v] = v < 3 ? 1.0 : 0.0;
      times[v] = pair[v][v] = v < 3 ? 1.0 : 2.0;
    }
  }
};

/// Second derivatives of a point's energy: by E, twice, and by E and the rate of deformation of the
/// mean. With M = mean dS S^-1 mean^-1 for each component of E, m = d ln phi, G = (I + E)^-1:
///   mixed:  c sym M + M tau + tau M^T
///   strain: M (c sym M + M tau) + 2 m sym(Z G) dE
///           + tr tau (m m + tr(G dE G dE) / 3 - (tr dE)^2 / (1 + tr E)^2 / 3)
struct StretchTangent {
  static constexpr int lanes = StrainLanes::lanes;
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
    set_volume(stretch, stress);
    set_moved(stretch.inverse * mean_inverse);
    set_stretched(tau, c);
    set_strain(stretch, stress.pressure);
  }

private:
  static constexpr StrainLanes is = {};
  double first[3][lanes] = {}, second[3][lanes] = {}; ///< columns of the mean
  double volume[lanes], by_volume[lanes];             ///< m, sym(Z G) dE
  double moved[3][3][lanes], stretched[3][3][lanes];  ///< M, c sym M + M tau

  KOKKOS_INLINE_FUNCTION void set_volume(const EnhancedStretch<double>& stretch,
                                         const StretchStress<double>& stress) {
    const Mat3 &G = stretch.inverse, &back = stress.back;
    const double part = 1.0 / stretch.volume, third = 1.0 / 3.0;
#pragma omp simd
    for (int v = 0; v < lanes; ++v) {
      volume[v] = third * (is.trace[v] * part - is.pair[0][v] * G[0][0] - is.pair[1][v] * G[1][1] -
                           is.pair[2][v] * G[2][2] - is.pair[3][v] * G[0][1] -
                           is.pair[4][v] * G[1][2] - is.pair[5][v] * G[0][2]);
      by_volume[v] = is.pair[0][v] * back[0][0] + is.pair[1][v] * back[1][1] +
                     is.pair[2][v] * back[2][2] + is.pair[3][v] * back[0][1] +
                     is.pair[4][v] * back[1][2] + is.pair[5][v] * back[0][2];
    }
  }

  /// right: G mean^-1
  KOKKOS_INLINE_FUNCTION void set_moved(const Mat3& right) {
    for (int j = 0; j < 3; ++j) {
      double of_first[lanes], of_second[lanes];
      at(is.column, right, j, of_first);
      at(is.row, right, j, of_second);
      for (int i = 0; i < 3; ++i)
#pragma omp simd
        for (int v = 0; v < lanes; ++v)
          moved[i][j][v] =
              first[i][v] * of_first[v] + second[i][v] * of_second[v] + (i == j ? volume[v] : 0.0);
    }
  }

  KOKKOS_INLINE_FUNCTION void set_stretched(const Mat3& tau, const double (&c)[6][6]) {
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
  }

  /// pressure: tr tau / 3
  KOKKOS_INLINE_FUNCTION void set_strain(const EnhancedStretch<double>& stretch, double pressure) {
    const double part = 1.0 / stretch.volume;
    double row[3][lanes], column[3][lanes]; // of G
    for (int i = 0; i < 3; ++i) {
      at(is.row, stretch.inverse, i, row[i]);
      at(is.column, stretch.inverse, i, column[i]);
    }
    for (int v = 0; v < voigt_size; ++v) {
      const int k = voigt_row[v], l = voigt_column[v];
      const double by_product = 3.0 * pressure * volume[v] + by_volume[v];
      const double by_turned = k == l ? 0.5 * pressure : pressure;
      const double by_trace = k == l ? pressure * part * part : 0.0;
#pragma omp simd
      for (int w = 0; w < lanes; ++w) {
        double sum =
            by_turned * is.times[w] * (row[k][w] * column[l][w] + row[l][w] * column[k][w]) -
            by_trace * is.trace[w] + volume[w] * by_product + volume[v] * by_volume[w];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            sum += moved[i][j][v] * stretched[i][j][w];
        strain[v][w] = sum;
      }
    }
  }

  /// Column j of m at the rows that `which` says of each lane.
  KOKKOS_INLINE_FUNCTION static void at(const double (&which)[3][lanes], const Mat3& m, int j,
                                        double (&out)[lanes]) {
#pragma omp simd
    for (int v = 0; v < lanes; ++v)
      out[v] = which[0][v] * m[0][j] + which[1][v] * m[1][j] + which[2][v] * m[2][j];
  }
};

} // namespace abut::solid
