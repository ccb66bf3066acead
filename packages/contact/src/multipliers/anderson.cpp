// SPDX-License-Identifier: BSD-3-Clause
#include "multipliers/anderson.hpp"

#include <array>
#include <cmath>

namespace abut::contact {

namespace {

constexpr double doubled = 2.0;
constexpr double longest = 10.0;     ///< change over that of the plain iteration
constexpr double independent = 1e-6; ///< least sine^2 of a difference against the newer ones

using Matrix = std::array<std::array<double, Anderson::most>, Anderson::most>;
using Column = std::array<double, Anderson::most>;

/// Solves the leading equations of a symmetric positive semidefinite matrix for as many unknowns as
/// are independent; the rest stays zero. Returns how many.
std::size_t solve_leading(const Matrix& a, const Column& b, std::size_t size, Column& x) {
  Matrix l{};
  std::size_t n = 0;
  for (; n < size; ++n) {
    for (std::size_t j = 0; j <= n; ++j) {
      double s = a[n][j];
      for (std::size_t k = 0; k < j; ++k)
        s -= l[n][k] * l[j][k];
      if (j < n)
        l[n][j] = s / l[j][j];
      else if (s > independent * a[n][n])
        l[n][n] = std::sqrt(s);
    }
    if (l[n][n] == 0.0)
      break;
  }
  x = b;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      x[i] -= l[i][k] * x[k];
    x[i] /= l[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k)
      x[i] -= l[k][i] * x[k];
    x[i] /= l[i][i];
  }
  return n;
}

} // namespace

std::vector<double> Anderson::next(const std::vector<double>& x, const std::vector<double>& g,
                                   const std::vector<double>& weight, bool changed) {
  Pair now{g, g};
  for (std::size_t i = 0; i < x.size(); ++i)
    now.residual[i] -= x[i];
  // Products of the residual and its differences to earlier ones: (0,0), (0,j), (i,j).
  const std::size_t n = pairs_.size();
  std::vector<double> sums((n + 1) * (n + 1) + 2, 0.0);
  std::vector<double> column(n + 1);
  double& before = sums[(n + 1) * (n + 1)];
  sums.back() = changed ? 1.0 : 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    column[0] = now.residual[i];
    for (std::size_t j = 0; j < n; ++j)
      column[j + 1] = now.residual[i] - pairs_[j].residual[i];
    for (std::size_t a = 0; a <= n; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        sums[a * (n + 1) + b] += weight[i] * column[a] * column[b];
    if (n > 0)
      before += weight[i] * pairs_[0].residual[i] * pairs_[0].residual[i];
  }
  comm_.sum(sums.data(), int(sums.size()));
  depth_ = 0;
  if (sums.back() > 0.0 || (n > 0 && sums[0] > doubled * doubled * before)) {
    pairs_.clear();
    pairs_.push_front(std::move(now));
    return g;
  }
  Matrix gram{};
  Column right{}, share{};
  for (std::size_t a = 0; a < n; ++a) {
    right[a] = sums[(a + 1) * (n + 1)];
    for (std::size_t b = 0; b <= a; ++b)
      gram[a][b] = gram[b][a] = sums[(a + 1) * (n + 1) + b + 1];
  }
  depth_ = solve_leading(gram, right, n, share);
  std::vector<double> result = g;
  for (std::size_t j = 0; j < depth_; ++j)
    for (std::size_t i = 0; i < g.size(); ++i)
      result[i] -= share[j] * (g[i] - pairs_[j].g[i]);
  double change = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    change += weight[i] * (result[i] - x[i]) * (result[i] - x[i]);
  if (comm_.sum(change) > longest * longest * sums[0]) {
    depth_ = 0;
    pairs_.clear();
    result = g;
  }
  pairs_.push_front(std::move(now));
  if (pairs_.size() > most)
    pairs_.pop_back();
  return result;
}

} // namespace abut::contact
