// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/block_matrix.hpp"
#include "aggregates.hpp"
#include "distribution.hpp"

#include <vector>

namespace abut::multigrid {

/// Translations among M modes: the first ones.
constexpr int translations(int modes) {
  return modes == 1 ? 1 : modes == 3 ? 2 : 3;
}

/// Energies of translations: entry i, j is the sum over d of b_i A_ij^dd b_j, with the share b_i
/// of row i in the translation along d. On the places of `a`. modes: (rows with ghosts, N, M).
///
/// The sum over all directions of an elastic stiffness is the stiffness of heat conduction, with
/// lambda + 4 mu (in the plane lambda + 3 mu) as conductivity: it knows how well rows are coupled,
/// and with which sign, whatever the direction of the element.
template <int N, int M>
BlockMatrix<float, 1, 1> translation_energies(const BlockMatrix<float, N, N>& a,
                                              const std::vector<double>& modes) {
  const auto share = [&](Local i, int d) {
    return modes[(static_cast<std::size_t>(i) * N + std::size_t(d)) * M + std::size_t(d)];
  };
  BlockMatrix<float, 1, 1> energies{a.rows, a.offset, a.column,
                                    View<float>("multigrid: energies", a.column.size())};
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      double sum = 0.0;
      for (int d = 0; d < translations(M); ++d)
        sum += share(i, d) * a.block(k)[d * N + d] * share(a.column(k), d);
      energies.value(k) = static_cast<float>(sum);
    }
  return energies;
}

/// The evolution measure of Olson, Schroder, Tuminaro, A new perspective on strength measures in
/// algebraic multigrid, Numer. Linear Algebra Appl. 17 (2010), section 3: a unit heat in row i
/// spreads for four steps of W = I - D^-1 S, D the sums of sizes in the rows of S; what has
/// reached j is compared with what remains, e_ij = |1 - z_i / z_j|. A coupling is strong where
/// e_ij is at most `drop_tolerance` times the least of row i, or e_ji of row j. Nothing that
/// reaches j, or less than nothing, is an infinite e_ij: a row that S knows nothing of (the
/// rotation of a rigid body) holds all its couplings strong. Steps are restricted to the places
/// of S.
/// energies: S, its columns `rows`. Returns a flag for each of its entries. Collective.
std::vector<char> evolution_strength(const BlockMatrix<float, 1, 1>& energies,
                                     const Distribution& rows, double drop_tolerance);

/// Whether a block holds anything.
template <int N> bool couples(const float* block) {
  for (int v = 0; v < N * N; ++v)
    if (block[v] != 0.0F)
      return true;
  return false;
}

/// For each block whether it couples its rows strongly. modes: (rows with ghosts, N, M).
/// Collective.
template <int N, int M>
std::vector<char> strong_couplings(const BlockMatrix<float, N, N>& a,
                                   const std::vector<double>& modes, const Distribution& rows,
                                   double drop_tolerance) {
  auto strong = evolution_strength(translation_energies<N, M>(a, modes), rows, drop_tolerance);
  for (Local k = 0; k < a.blocks(); ++k)
    if (!couples<N>(a.block(k)))
      strong[std::size_t(k)] = 0;
  return strong;
}

/// Strong couplings between owned rows. A row that is coupled with any other lists itself.
template <int N>
StrengthGraph strength_graph(const BlockMatrix<float, N, N>& a, const std::vector<char>& strong) {
  StrengthGraph graph;
  for (Local i = 0; i < a.rows; ++i) {
    bool coupled = false;
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      const Local j = a.column(k);
      if (j == i || !strong[std::size_t(k)])
        continue;
      coupled = true;
      if (j < a.rows)
        graph.neighbour.push_back(j);
    }
    if (coupled)
      graph.neighbour.push_back(i);
    graph.offset.push_back(static_cast<Local>(graph.neighbour.size()));
  }
  return graph;
}

} // namespace abut::multigrid
