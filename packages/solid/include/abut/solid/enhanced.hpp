// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/enhanced_reference.hpp"
#include "abut/solid/enhanced_stretch.hpp"

/// hex8 that locks neither in bending nor near incompressibility, after Taylor, Beresford and
/// Wilson (1976), at finite strain and without inner unknowns.
///
/// The mean F = I + sum u_a (x) b_a of the deformation gradient has b_a = int grad N_a dV / V. What
/// is left of a displacement are hourglass modes of amplitudes q; seen in the deformed frame,
/// c = F^-1 q, they are strains E_p(c) at points p beside the mean. By them the element is
/// stretched more or less than the mean, and the law says what that takes:
///   W_e = v W(F) + sum v_p W(F S(E_p(c)))
/// E_p is linear, of the undeformed element, with the incompatible modes that relieve bending
/// already in it, see enhanced_reference.hpp; S is a stretch, see enhanced_stretch.hpp: no rotation
/// enters, and no compressed state has hourglass modes without stiffness. With gradients
/// g_a = F^-T b_a, s_a = gamma_a - b_a c of each node and mode, f = F^-T dW_e/dc of each mode and
/// h_a = sum s_a f:
///   r_a  = (int tau dV) g_a + h_a
///   k_ab = [B_a; s_a] D [B_b; s_b] + g_a (int tau dV) g_b I - h_a g_b - g_a h_b
/// where D are the second derivatives by the mean's rate of deformation and by F c. Mean gradients
/// after Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679; energy at the mean and
/// at corners after the 9 point rule of Simo, Armero and Taylor, Comput. Methods Appl. Mech. Eng.
/// 110 (1993) 359.
namespace abut::solid {

/// Kinematics of an element; T as for element_residual.
template <class T> struct EnhancedState {
  Deformation<T> deformation{Mat<T, 3>::zero()}; ///< mean
  Mat<T, 3> mean, back;                          ///< F and F^-1; I at small strain
  T gradient[3][8];                              ///< g
  T amplitude[hourglass_numbers];                ///< c
  T shape[hourglasses][8];                       ///< s

  /// Returns false when det F <= 0 at finite strain.
  KOKKOS_INLINE_FUNCTION bool set(bool finite_strain, const EnhancedReference& reference,
                                  const T (&u)[3][8]) {
    deformation = Deformation<T>(nodal_gradient(u, reference.gradient));
    mean = back = Mat<T, 3>::identity();
    if (finite_strain) {
      if (!(deformation.jacobian() > 0.0))
        return false;
      back = inverse_gradient(deformation);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          mean[i][j] += deformation.H[i][j];
    }
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 8; ++a)
        gradient[i][a] = back[0][i] * reference.gradient[0][a] +
                         back[1][i] * reference.gradient[1][a] +
                         back[2][i] * reference.gradient[2][a];
    for (int s = 0; s < hourglasses; ++s) {
      Vec<T, 3> q;
      for (int i = 0; i < 3; ++i)
        q[i] = nodal_sum(u[i], reference.hourglass[s]);
      const Vec<T, 3> c = back * q;
      for (int i = 0; i < 3; ++i)
        amplitude[3 * s + i] = c[i];
      for (int a = 0; a < 8; ++a) {
        shape[s][a] = T(reference.hourglass[s][a]);
        if (finite_strain)
          shape[s][a] -= reference.gradient[0][a] * c[0] + reference.gradient[1][a] * c[1] +
                         reference.gradient[2][a] * c[2];
      }
    }
    return true;
  }

  /// E at a point.
  KOKKOS_INLINE_FUNCTION Mat<T, 3>
  strain(const double (&by_amplitude)[6][hourglass_numbers]) const {
    Mat<T, 3> e;
    for (int v = 0; v < voigt_size; ++v) {
      const T value = nodal_sum(amplitude, by_amplitude[v]);
      e[voigt_row[v]][voigt_column[v]] = e[voigt_column[v]][voigt_row[v]] = value;
    }
    return e;
  }

  /// F at a point.
  KOKKOS_INLINE_FUNCTION Deformation<T> stretched(bool finite_strain,
                                                  const EnhancedStretch<T>& stretch) const {
    Mat<T, 3> h = deformation.H;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        h[i][j] += stretch.excess[i][j];
        if (finite_strain)
          h[i][j] += deformation.H[i][0] * stretch.excess[0][j] +
                     deformation.H[i][1] * stretch.excess[1][j] +
                     deformation.H[i][2] * stretch.excess[2][j];
      }
    return Deformation<T>(h);
  }
};

/// Integrals over an element's volume.
template <class T> struct EnhancedStress {
  Mat<T, 3> tau;                  ///< Kirchhoff stress
  T hourglass[hourglass_numbers]; ///< derivative of the energy by c

  KOKKOS_INLINE_FUNCTION void clear() {
    tau = Mat<T, 3>::zero();
    for (T& f : hourglass)
      f = T(0.0);
  }
  KOKKOS_INLINE_FUNCTION void add(double volume, const Mat<T, 3>& more) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        tau[i][j] += volume * more[i][j];
  }
  KOKKOS_INLINE_FUNCTION void add_hourglass(double volume, const Mat<T, 3>& derivative,
                                            const double (&by_amplitude)[6][hourglass_numbers]) {
    for (int v = 0; v < voigt_size; ++v) {
      const T value = (v < 3 ? volume : 2.0 * volume) * derivative[voigt_row[v]][voigt_column[v]];
      for (int m = 0; m < hourglass_numbers; ++m)
        hourglass[m] += value * by_amplitude[v][m];
    }
  }

  /// Forces on the nodes (3, 8) of the hourglass modes.
  KOKKOS_INLINE_FUNCTION void nodal(const EnhancedState<T>& state, T (&h)[3][8]) const {
    for (int i = 0; i < 3; ++i) {
      T f[hourglasses];
      for (int s = 0; s < hourglasses; ++s)
        f[s] = state.back[0][i] * hourglass[3 * s] + state.back[1][i] * hourglass[3 * s + 1] +
               state.back[2][i] * hourglass[3 * s + 2];
      for (int a = 0; a < 8; ++a)
        h[i][a] = f[0] * state.shape[0][a] + f[1] * state.shape[1][a] + f[2] * state.shape[2][a] +
                  f[3] * state.shape[3][a];
    }
  }
};

/// Volume at the mean.
KOKKOS_INLINE_FUNCTION double mean_share(const EnhancedReference& reference) {
  return (1.0 - corner_share) * reference.volume;
}

/// As element_residual; returns det F of the mean or, where a corner is folded, what is left of its
/// stretch.
template <class M, class T>
KOKKOS_INLINE_FUNCTION double enhanced_residual(const EnhancedReference& reference,
                                                const M& material, const T (&u)[3][8],
                                                T (&r)[3][8]) {
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 8; ++a)
      r[i][a] = T(0.0);
  EnhancedState<T> state;
  const bool upright = state.set(M::finite_strain, reference, u);
  const double smallest = M::finite_strain ? value_of(state.deformation.jacobian()) : 1.0;
  if (!upright)
    return smallest;
  EnhancedStress<T> stress;
  stress.clear();
  stress.add(mean_share(reference), material.stress(state.deformation));
  EnhancedStretch<T> stretch;
  for (int p = 0; p < EnhancedReference::points; ++p) {
    if (!stretch.set(M::finite_strain, state.strain(reference.strain[p])))
      return stretch.least;
    const Mat<T, 3> tau = material.stress(state.stretched(M::finite_strain, stretch));
    const StretchStress<T> by_strain(state.mean, state.back, stretch, tau);
    stress.add(reference.share[p], tau);
    stress.add_hourglass(reference.share[p], by_strain.derivative, reference.strain[p]);
  }
  stress.nodal(state, r);
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 8; ++a)
      r[i][a] += stress.tau[i][0] * state.gradient[0][a] + stress.tau[i][1] * state.gradient[1][a] +
                 stress.tau[i][2] * state.gradient[2][a];
  return smallest;
}

/// As element_averages. An element that is turned over has zeros.
template <class M>
KOKKOS_INLINE_FUNCTION void enhanced_averages(const EnhancedReference& reference, const M& material,
                                              const double (&u)[3][8], double stress[6],
                                              double& energy) {
  energy = 0.0;
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = 0.0;
  EnhancedState<double> state;
  if (!state.set(M::finite_strain, reference, u))
    return;
  EnhancedStress<double> sum;
  sum.clear();
  sum.add(mean_share(reference), material.stress(state.deformation));
  double stored = mean_share(reference) * material.energy(state.deformation);
  EnhancedStretch<double> stretch;
  for (int p = 0; p < EnhancedReference::points; ++p) {
    if (!stretch.set(M::finite_strain, state.strain(reference.strain[p])))
      return;
    const Deformation<double> d = state.stretched(M::finite_strain, stretch);
    sum.add(reference.share[p], material.stress(d));
    stored += reference.share[p] * material.energy(d);
  }
  const double volume = reference.volume * (M::finite_strain ? state.deformation.jacobian() : 1.0);
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = sum.tau[voigt_row[v]][voigt_column[v]] / volume;
  energy = stored;
}

} // namespace abut::solid
