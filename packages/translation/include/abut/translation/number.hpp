// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace abut::translation {

/// Numbers so large or small are taken for mistakes: their products would not be finite.
inline bool is_sane(double x) {
  constexpr double largest = 1e100;
  return std::abs(x) <= largest && (x == 0.0 || std::abs(x) >= 1.0 / largest);
}

} // namespace abut::translation
