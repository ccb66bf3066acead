// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/value.hpp"
#include "abut/solid/options.hpp"

#include <array>
#include <string>
#include <vector>

namespace abut::deck {

/// Values as a deck writes them.
std::string printed(const std::string& s); ///< in double quotes
inline std::string printed(bool x) {
  return x ? "true" : "false";
}
inline std::string printed(int n) {
  return std::to_string(n);
}
inline std::string printed(long long n) {
  return std::to_string(n);
}
inline std::string printed(double x) {
  return number_text(x);
}

inline std::string printed(const Amount& x) {
  return x.expression.empty() ? printed(x.number) : printed(x.expression);
}

template <class T, std::size_t n> std::string printed(const std::array<T, n>& x);

template <class List> std::string printed_list(const List& list) {
  std::string s;
  for (const auto& x : list)
    s += (s.empty() ? "[" : ", ") + printed(x);
  return s + "]";
}
template <class T, std::size_t n> std::string printed(const std::array<T, n>& x) {
  return printed_list(x);
}
inline std::string printed(const std::vector<double>& x) {
  return printed_list(x);
}
inline std::string printed(const std::vector<std::string>& x) {
  return printed_list(x);
}

} // namespace abut::deck
