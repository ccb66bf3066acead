// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/enhanced_reference.hpp"
#include "abut/solid/tangent_blocks.hpp"

/// hex8 that locks neither in bending nor near incompressibility. The material is evaluated once,
/// at the mean F = I + sum u_a (x) b_a of the deformation gradient, b_a = int grad N_a dV / V. What
/// is left of a displacement are hourglass modes of amplitudes q; seen in the deformed frame they
/// are strains c = F^-1 q, with the stiffness K of the undeformed element with incompatible modes:
///   W_e = V W(F) + c K c / 2
/// At small strain this is the element of Taylor, Beresford and Wilson (1976) with the mean
/// dilatation. K is positive and c turns with the body, so that no homogeneous state, however
/// compressed, has an hourglass mode without stiffness; there are no inner unknowns. With
/// gradients g_a = F^-T b_a, f_a = F^-T K c of each mode and s_a = gamma_a - b_a c of each node:
///   r_a  = V tau g_a + sum s_a f
///   k_ab = V (B_a^T c B_b + g_a tau g_b I) + sum s_a F^-T K F^-1 s_b - h_a g_b - g_a h_b
/// where h_a is the second part of r_a. Mean gradients after Flanagan and Belytschko, Int. J.
/// Numer. Methods Eng. 17 (1981) 679; stiffness from assumed strains after Belytschko and Bindeman,
/// Comput. Methods Appl. Mech. Eng. 105 (1993) 225.
namespace abut::solid {

/// Kinematics of an element; T as for element_residual.
template <class T> struct EnhancedState {
  Deformation<T> deformation{Mat<T, 3>::zero()}; ///< mean
  Mat<T, 3> back;                                ///< F^-1; I at small strain
  T gradient[3][8];                              ///< g
  Vec<T, 3> strain[hourglasses];                 ///< c
  T shape[hourglasses][8];                       ///< s

  /// Returns false when det F <= 0 at finite strain.
  KOKKOS_INLINE_FUNCTION bool set(bool finite_strain, const EnhancedReference& reference,
                                  const T (&u)[3][8]) {
    deformation = Deformation<T>(nodal_gradient(u, reference.gradient));
    back = Mat<T, 3>::identity();
    if (finite_strain) {
      if (!(deformation.jacobian() > 0.0))
        return false;
      back = inverse_gradient(deformation);
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
      strain[s] = back * q;
      for (int a = 0; a < 8; ++a) {
        shape[s][a] = T(reference.hourglass[s][a]);
        if (finite_strain)
          shape[s][a] -= reference.gradient[0][a] * strain[s][0] +
                         reference.gradient[1][a] * strain[s][1] +
                         reference.gradient[2][a] * strain[s][2];
      }
    }
    return true;
  }

  /// K c
  KOKKOS_INLINE_FUNCTION void stress(const EnhancedReference& reference,
                                     Vec<T, 3> (&out)[hourglasses]) const {
    for (auto& v : out)
      v = Vec<T, 3>::zero();
    for (int s = 0; s < hourglasses; ++s)
      for (int t = s; t < hourglasses; ++t) {
        const auto& K = reference.stiffness[hourglass_pair(s, t)];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            out[s][i] += K[i][j] * strain[t][j];
            if (t > s)
              out[t][j] += K[i][j] * strain[s][i];
          }
      }
  }

  /// Forces on the nodes (3, 8) of the hourglass modes.
  KOKKOS_INLINE_FUNCTION void hourglass_force(const EnhancedReference& reference,
                                              T (&h)[3][8]) const {
    Vec<T, 3> stresses[hourglasses];
    stress(reference, stresses);
    for (int i = 0; i < 3; ++i) {
      T f[hourglasses];
      for (int s = 0; s < hourglasses; ++s)
        f[s] =
            back[0][i] * stresses[s][0] + back[1][i] * stresses[s][1] + back[2][i] * stresses[s][2];
      for (int a = 0; a < 8; ++a)
        h[i][a] = f[0] * shape[0][a] + f[1] * shape[1][a] + f[2] * shape[2][a] + f[3] * shape[3][a];
    }
  }
};

/// As element_residual.
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
  state.hourglass_force(reference, r);
  const Mat<T, 3> tau = material.stress(state.deformation);
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 8; ++a)
      r[i][a] +=
          reference.volume * (tau[i][0] * state.gradient[0][a] + tau[i][1] * state.gradient[1][a] +
                              tau[i][2] * state.gradient[2][a]);
  return smallest;
}

/// Adds what hourglass modes give to a tangent.
template <bool finite_strain>
KOKKOS_INLINE_FUNCTION void add_hourglass_tangent(const EnhancedReference& reference,
                                                  const EnhancedState<double>& state,
                                                  TangentBlocks<8>& blocks) {
  double K[hourglasses][hourglasses][3][3]; // F^-T K F^-1
  for (int s = 0; s < hourglasses; ++s)
    for (int t = s; t < hourglasses; ++t) {
      const auto& at_rest = reference.stiffness[hourglass_pair(s, t)];
      double half[3][3]; // K F^-1
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          half[i][j] = at_rest[i][0] * state.back[0][j] + at_rest[i][1] * state.back[1][j] +
                       at_rest[i][2] * state.back[2][j];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          K[s][t][i][j] = K[t][s][j][i] = state.back[0][i] * half[0][j] +
                                          state.back[1][i] * half[1][j] +
                                          state.back[2][i] * half[2][j];
    }
  double h[3][8];
  if (finite_strain)
    state.hourglass_force(reference, h);
  for (int pair = 0; pair < 6; ++pair) {
    const int i = voigt_row[pair], j = voigt_column[pair];
    double row[hourglasses][8];
    for (int s = 0; s < hourglasses; ++s)
#pragma omp simd
      for (int b = 0; b < 8; ++b)
        row[s][b] = K[s][0][i][j] * state.shape[0][b] + K[s][1][i][j] * state.shape[1][b] +
                    K[s][2][i][j] * state.shape[2][b] + K[s][3][i][j] * state.shape[3][b];
    for (int a = 0; a < 8; ++a) {
      const double s0 = state.shape[0][a], s1 = state.shape[1][a], s2 = state.shape[2][a],
                   s3 = state.shape[3][a];
#pragma omp simd
      for (int b = 0; b < 8; ++b)
        blocks.block[pair][a][b] +=
            s0 * row[0][b] + s1 * row[1][b] + s2 * row[2][b] + s3 * row[3][b];
      if (finite_strain) {
        const double ha = h[j][a], ga = state.gradient[j][a];
#pragma omp simd
        for (int b = 0; b < 8; ++b)
          blocks.block[pair][a][b] -= ha * state.gradient[i][b] + ga * h[i][b];
      }
    }
  }
}

/// As element_tangent.
template <class M>
KOKKOS_INLINE_FUNCTION double enhanced_tangent(const EnhancedReference& reference,
                                               const M& material, const double (&u)[3][8],
                                               double* k) {
  EnhancedState<double> state;
  const bool upright = state.set(M::finite_strain, reference, u);
  const double smallest = M::finite_strain ? state.deformation.jacobian() : 1.0;
  if (!upright)
    return smallest;
  Mat3 tau;
  double c[6][6];
  material.tangent(state.deformation, tau, c);
  for (auto& row : c)
    for (double& value : row)
      value *= reference.volume;
  for (auto& row : tau.m)
    for (double& value : row)
      value *= reference.volume;
  TangentBlocks<8> blocks;
  blocks.clear();
  blocks.add_material(state.gradient, c);
  if (M::finite_strain)
    blocks.add_geometric(state.gradient, tau);
  add_hourglass_tangent<M::finite_strain>(reference, state, blocks);
  blocks.write(k);
  return smallest;
}

/// As element_averages; the mean of the hourglass stresses is zero. An element that is turned over
/// has zeros.
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
  const Mat3 tau = material.stress(state.deformation);
  const double J = M::finite_strain ? state.deformation.jacobian() : 1.0;
  for (int v = 0; v < voigt_size; ++v)
    stress[v] = tau[voigt_row[v]][voigt_column[v]] / J;
  energy = reference.volume * material.energy(state.deformation);
  Vec3 stresses[hourglasses];
  state.stress(reference, stresses);
  for (int s = 0; s < hourglasses; ++s)
    energy += 0.5 * dot(state.strain[s], stresses[s]);
}

} // namespace abut::solid
