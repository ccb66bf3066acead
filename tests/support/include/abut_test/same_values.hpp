// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/views.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace abut_test {

/// Of two evaluations of one state: bit for bit on one thread; where several add up cells in any
/// order, to rounding of the largest value.
inline ::testing::AssertionResult same_values(const std::vector<double>& a,
                                              const std::vector<double>& b) {
  constexpr double rounding = 1e-14;
  if (a.size() != b.size())
    return ::testing::AssertionFailure() << a.size() << " and " << b.size() << " values";
  double largest = 0.0;
  for (double x : a)
    largest = std::max(largest, std::fabs(x));
  const double allowed = abut::Execution().concurrency() == 1 ? 0.0 : rounding * largest;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::fabs(a[i] - b[i]) <= allowed))
      return ::testing::AssertionFailure() << "value " << i << ": " << a[i] << " and " << b[i];
  return ::testing::AssertionSuccess();
}

} // namespace abut_test
