// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/deformation.hpp"

/// W = isochoric energy of J^(-1/3) F + U(J) with U = K/2 (ln J)^2, for rubber and tissue that
/// hardly change their volume. Elements with mean_dilatation.hpp take U at their mean J.
namespace abut::solid {

/// What every uncoupled law shares. A law derives from it and gives
///   T isochoric_energy(const Deformation<T>&) const;
///   Mat<T,3> isochoric_stress(const Deformation<T>&) const;      Kirchhoff, without trace
///   void isochoric_tangent(const Deformation<double>&, Mat3& stress, double c[6][6]) const;
template <class Law> struct Uncoupled {
  static constexpr bool finite_strain = true, uncoupled = true;
  double bulk = 0.0; ///< K [pressure]

  template <class T> KOKKOS_INLINE_FUNCTION T energy(const Deformation<T>& d) const {
    return law().isochoric_energy(d) + volume_energy(d.volume_change);
  }
  template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> stress(const Deformation<T>& d) const {
    Mat<T, 3> s = law().isochoric_stress(d);
    const T pressure = bulk * log_one_plus(d.volume_change);
    for (int i = 0; i < 3; ++i)
      s[i][i] += pressure;
    return s;
  }
  KOKKOS_INLINE_FUNCTION void tangent(const Deformation<double>& d, Mat3& s, double c[6][6]) const {
    law().isochoric_tangent(d, s, c);
    const double pressure = bulk * log_one_plus(d.volume_change);
    add_pressure(pressure, bulk, s, c);
  }

  /// U by J - 1.
  template <class T> KOKKOS_INLINE_FUNCTION T volume_energy(const T& volume_change) const {
    const T log_j = log_one_plus(volume_change);
    return 0.5 * bulk * log_j * log_j;
  }
  /// Mean Cauchy stress dU/dJ by J - 1, positive in tension [pressure].
  template <class T> KOKKOS_INLINE_FUNCTION T mean_stress(const T& volume_change) const {
    return bulk * log_one_plus(volume_change) / (1.0 + volume_change);
  }
  /// d^2U/dJ^2 by J - 1 [pressure].
  KOKKOS_INLINE_FUNCTION double mean_stress_slope(double volume_change) const {
    const double J = 1.0 + volume_change;
    return bulk * (1.0 - log_one_plus(volume_change)) / (J * J);
  }

  /// s += p I, c += d I (x) I - 2 p I_sym.
  KOKKOS_INLINE_FUNCTION static void add_pressure(double p, double d, Mat3& s, double c[6][6]) {
    for (int i = 0; i < 3; ++i) {
      s[i][i] += p;
      for (int j = 0; j < 3; ++j)
        c[i][j] += d;
      c[i][i] -= 2.0 * p;
      c[i + 3][i + 3] -= p;
    }
  }

private:
  KOKKOS_INLINE_FUNCTION const Law& law() const { return static_cast<const Law&>(*this); }
};

} // namespace abut::solid
