// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <deque>
#include <vector>

namespace abut::contact {

/// Anderson's acceleration of an iteration x <- g(x), values spread over the ranks: the next value
/// is that combination of the last g whose residuals g - x cancel best, sum_j theta_j g_j with
/// sum_j theta_j = 1 that makes |sum_j theta_j (g_j - x_j)| least. (D. G. Anderson, J. ACM 12,
/// 1965)
class Anderson {
public:
  static constexpr std::size_t most = 5; ///< earlier pairs that are kept

  explicit Anderson(const Comm& comm) : comm_(comm) {}

  /// The value to go on from. weight: of each value in the norm, 0 for copies of another rank's.
  /// It starts afresh, with g itself, when `changed` on any rank (what g depends on is another
  /// function now), when the residual has doubled or the combination lies far beyond g: where
  /// the residual does not change there is no solution to head for. Collective.
  std::vector<double> next(const std::vector<double>& x, const std::vector<double>& g,
                           const std::vector<double>& weight, bool changed);
  void clear() { pairs_.clear(); }
  /// Pairs that the last value was made of beside the newest.
  std::size_t depth() const { return depth_; }

private:
  struct Pair {
    std::vector<double> g, residual;
  };

  Comm comm_;
  std::deque<Pair> pairs_; ///< newest first
  std::size_t depth_ = 0;
};

} // namespace abut::contact
