// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/dual_weights.hpp"

#include "spaces/nodal_arrays.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

constexpr int max = max_corners;
constexpr double independent = 1e-8; ///< least pivot over the largest entry

/// Inverse of the symmetric positive definite n x n matrix m by Cholesky's method.
bool invert(int n, const double (&m)[max][max], double (&inverse)[max][max]) {
  double l[max][max] = {}, largest = 0.0;
  for (int i = 0; i < n; ++i)
    largest = std::max(largest, m[i][i]);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double s = m[i][j];
      for (int k = 0; k < j; ++k)
        s -= l[i][k] * l[j][k];
      if (i == j && !(s > independent * largest))
        return false;
      l[i][j] = i == j ? std::sqrt(s) : s / l[j][j];
    }
  for (int c = 0; c < n; ++c) {
    double x[max];
    for (int i = 0; i < n; ++i) {
      x[i] = i == c ? 1.0 : 0.0;
      for (int k = 0; k < i; ++k)
        x[i] -= l[i][k] * x[k];
      x[i] /= l[i][i];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int k = i + 1; k < n; ++k)
        x[i] -= l[k][i] * x[k];
      x[i] /= l[i][i];
      inverse[i][c] = x[i];
    }
  }
  return true;
}

} // namespace

bool dual_coefficients(int corners, int points, const double* N, const double* w, double* C) {
  double m[max][max] = {}, lumped[max] = {}, inverse[max][max];
  for (int q = 0; q < points; ++q)
    for (int a = 0; a < corners; ++a) {
      lumped[a] += w[q] * N[q * corners + a];
      for (int b = 0; b < corners; ++b)
        m[a][b] += w[q] * N[q * corners + a] * N[q * corners + b];
    }
  const bool fine = invert(corners, m, inverse);
  for (int a = 0; a < corners; ++a)
    for (int b = 0; b < corners; ++b)
      C[a * corners + b] = fine ? lumped[a] * inverse[a][b] : a == b ? 1.0 : 0.0;
  return fine;
}

} // namespace abut::contact
