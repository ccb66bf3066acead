// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/value.hpp"

#include <limits>
#include <string>

namespace abut::deck {

/// Range and unit of a number.
struct Rule {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double low = -infinity;
  double high = infinity;
  bool open = false; ///< the ends themselves are excluded
  const char* unit = "";
  const char* reason = ""; ///< why, for the message
  const char* word = "";   ///< that stands for no number

  bool accepts(double x) const { return open ? low < x && x < high : low <= x && x <= high; }
  /// "> 0", ">= 1", "> -1 and < 0.5"; empty when everything goes.
  std::string text() const {
    const std::string equal = open ? " " : "= ";
    std::string s;
    if (low > -infinity)
      s = ">" + equal + number_text(low);
    if (high < infinity)
      s += (s.empty() ? "<" : " and <") + equal + number_text(high);
    return s;
  }
};

inline Rule unit(const char* unit) {
  Rule rule;
  rule.unit = unit;
  return rule;
}
inline Rule positive(const char* unit = "") {
  return {0.0, Rule::infinity, true, unit, ""};
}
inline Rule at_least(double low, const char* unit = "") {
  return {low, Rule::infinity, false, unit, ""};
}

/// A word of the deck for a value of an enumeration.
template <class E> struct Choice {
  const char* word;
  E value;
  const char* doc = "";
};

} // namespace abut::deck
