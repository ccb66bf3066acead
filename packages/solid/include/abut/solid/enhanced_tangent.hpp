// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/enhanced.hpp"
#include "abut/solid/tangent_blocks.hpp"

/// Tangent of the enhanced hex8; the formulas are those of enhanced.hpp.
namespace abut::solid {

/// Second derivatives of an element's energy by the rate of deformation of the mean and by c.
struct EnhancedModuli {
  double law[6][6];                   ///< int c dV
  double mixed[6][hourglass_numbers]; ///< [stress][c]
  double hourglass[hourglass_numbers][hourglass_numbers];

  KOKKOS_INLINE_FUNCTION void add(double volume, const double (&c)[6][6]) {
    for (int v = 0; v < voigt_size; ++v)
      for (int w = 0; w < voigt_size; ++w)
        law[v][w] += volume * c[v][w];
  }
  KOKKOS_INLINE_FUNCTION void add_point(double volume, const StretchTangent& point,
                                        const double (&by_amplitude)[6][hourglass_numbers]) {
    double rows[voigt_size][hourglass_numbers];
    const auto& t = by_amplitude;
    for (int v = 0; v < voigt_size; ++v) {
      double strain[voigt_size], stress[voigt_size];
      for (int w = 0; w < voigt_size; ++w) {
        strain[w] = volume * point.strain[v][w];
        stress[w] = volume * point.mixed[v][w];
      }
#pragma omp simd
      for (int m = 0; m < hourglass_numbers; ++m) {
        rows[v][m] = strain[0] * t[0][m] + strain[1] * t[1][m] + strain[2] * t[2][m] +
                     strain[3] * t[3][m] + strain[4] * t[4][m] + strain[5] * t[5][m];
        mixed[v][m] += stress[0] * t[0][m] + stress[1] * t[1][m] + stress[2] * t[2][m] +
                       stress[3] * t[3][m] + stress[4] * t[4][m] + stress[5] * t[5][m];
      }
    }
    for (int m = 0; m < hourglass_numbers; ++m) {
      const double t0 = t[0][m], t1 = t[1][m], t2 = t[2][m], t3 = t[3][m], t4 = t[4][m],
                   t5 = t[5][m];
#pragma omp simd
      for (int n = 0; n < hourglass_numbers; ++n)
        hourglass[m][n] += t0 * rows[0][n] + t1 * rows[1][n] + t2 * rows[2][n] + t3 * rows[3][n] +
                           t4 * rows[4][n] + t5 * rows[5][n];
    }
  }
  /// From amplitudes in the deformed frame, c = F^-1 w, to w.
  KOKKOS_INLINE_FUNCTION void push_forward(const Mat3& back) {
    double half[hourglass_numbers][hourglass_numbers];
    for (int m = 0; m < hourglass_numbers; ++m)
      for (int s = 0; s < hourglass_numbers; s += 3)
        for (int i = 0; i < 3; ++i)
          half[m][s + i] = hourglass[m][s] * back[0][i] + hourglass[m][s + 1] * back[1][i] +
                           hourglass[m][s + 2] * back[2][i];
    for (int s = 0; s < hourglass_numbers; s += 3)
      for (int i = 0; i < 3; ++i)
        for (int n = 0; n < hourglass_numbers; ++n)
          hourglass[s + i][n] =
              half[s][n] * back[0][i] + half[s + 1][n] * back[1][i] + half[s + 2][n] * back[2][i];
    for (auto& row : mixed)
      for (int s = 0; s < hourglass_numbers; s += 3) {
        const double c[3] = {row[s], row[s + 1], row[s + 2]};
        for (int i = 0; i < 3; ++i)
          row[s + i] = c[0] * back[0][i] + c[1] * back[1][i] + c[2] * back[2][i];
      }
  }
};

/// Adds [B; s]^T moduli [B; s].
KOKKOS_INLINE_FUNCTION void add_enhanced(const EnhancedState<double>& state,
                                         const EnhancedModuli& moduli, TangentBlocks<8>& blocks) {
  // Voigt rows that hold gradient component x, y, z of a displacement component i.
  constexpr int voigt[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  const auto& g = state.gradient;
  const auto& s = state.shape;
  for (int j = 0; j < 3; ++j) { // columns: stresses and hourglass forces by component j of nodes
    double stress[voigt_size][8], force[hourglass_numbers][8];
    for (int v = 0; v < voigt_size; ++v) {
      const double *law = moduli.law[v], *mixed = moduli.mixed[v];
#pragma omp simd
      for (int b = 0; b < 8; ++b)
        stress[v][b] = law[voigt[j][0]] * g[0][b] + law[voigt[j][1]] * g[1][b] +
                       law[voigt[j][2]] * g[2][b] + mixed[j] * s[0][b] + mixed[3 + j] * s[1][b] +
                       mixed[6 + j] * s[2][b] + mixed[9 + j] * s[3][b];
    }
    for (int m = 0; m < hourglass_numbers; ++m) {
      const double* k = moduli.hourglass[m];
      const double c0 = moduli.mixed[voigt[j][0]][m], c1 = moduli.mixed[voigt[j][1]][m],
                   c2 = moduli.mixed[voigt[j][2]][m];
#pragma omp simd
      for (int b = 0; b < 8; ++b)
        force[m][b] = c0 * g[0][b] + c1 * g[1][b] + c2 * g[2][b] + k[j] * s[0][b] +
                      k[3 + j] * s[1][b] + k[6 + j] * s[2][b] + k[9 + j] * s[3][b];
    }
    for (int pair = 0; pair < 6; ++pair) {
      if (voigt_column[pair] != j)
        continue;
      const int i = voigt_row[pair];
      for (int a = 0; a < 8; ++a)
#pragma omp simd
        for (int b = 0; b < 8; ++b)
          blocks.block[pair][a][b] +=
              g[0][a] * stress[voigt[i][0]][b] + g[1][a] * stress[voigt[i][1]][b] +
              g[2][a] * stress[voigt[i][2]][b] + s[0][a] * force[i][b] + s[1][a] * force[3 + i][b] +
              s[2][a] * force[6 + i][b] + s[3][a] * force[9 + i][b];
    }
  }
}

/// Takes off h (x) g + g (x) h: what nodes turn and stretch the frame of c.
KOKKOS_INLINE_FUNCTION void add_frame_of_hourglass(const EnhancedState<double>& state,
                                                   const double (&h)[3][8],
                                                   TangentBlocks<8>& blocks) {
  for (int pair = 0; pair < 6; ++pair) {
    const int i = voigt_row[pair], j = voigt_column[pair];
    for (int a = 0; a < 8; ++a) {
      const double ha = h[j][a], ga = state.gradient[j][a];
#pragma omp simd
      for (int b = 0; b < 8; ++b)
        blocks.block[pair][a][b] -= ha * state.gradient[i][b] + ga * h[i][b];
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
  const double smallest = M::finite_strain ? value_of(state.deformation.jacobian()) : 1.0;
  if (!upright)
    return smallest;
  EnhancedStress<double> stress;
  EnhancedModuli moduli = {};
  Mat3 tau;
  double c[6][6];
  stress.clear();
  material.tangent(state.deformation, tau, c);
  stress.add(mean_share(reference), tau);
  moduli.add(mean_share(reference), c);
  EnhancedStretch<double> stretch;
  StretchTangent point(state.mean);
  for (int p = 0; p < EnhancedReference::points; ++p) {
    if (!stretch.set(M::finite_strain, state.strain(reference.strain[p])))
      return stretch.least;
    material.tangent(state.stretched(M::finite_strain, stretch), tau, c);
    if (!M::finite_strain)
      tau = Mat3::zero(); // nothing of it enters
    const StretchStress<double> by_strain(state.mean, state.back, stretch, tau);
    stress.add(reference.share[p], tau);
    stress.add_hourglass(reference.share[p], by_strain.derivative, reference.strain[p]);
    point.set(state.back, stretch, by_strain, tau, c);
    moduli.add(reference.share[p], c);
    moduli.add_point(reference.share[p], point, reference.strain[p]);
  }
  moduli.push_forward(state.back);
  TangentBlocks<8> blocks;
  blocks.clear();
  add_enhanced(state, moduli, blocks);
  if (M::finite_strain) {
    double h[3][8];
    stress.nodal(state, h);
    add_frame_of_hourglass(state, h, blocks);
    blocks.add_geometric(state.gradient, stress.tau);
  }
  blocks.write(k);
  return smallest;
}

} // namespace abut::solid
