// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace abut::scene {

/// Eigenvalues (into the diagonal of a) and eigenvectors (columns) of a symmetric n x n matrix, by
/// Jacobi rotations. Directions that the matrix does not couple stay as they are, also where their
/// eigenvalues are the same: LAPACK's routines mix them.
std::vector<double> symmetric_eigen(std::vector<double>& a, std::size_t n);

} // namespace abut::scene
