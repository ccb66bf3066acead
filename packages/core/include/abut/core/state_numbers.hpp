// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace abut {

/// Puts what it is called with into a list of numbers, or takes it from there again, so that one
/// list of members serves both ways. Numbers, flags, enumerations (whole numbers up to 2^53 are
/// exact), arrays and lists of them are known; any other type says what it holds by a function
/// beside it,
///
///   template <class V> void list_state(V& v, Type& x) { v(x.first, x.second); }
class StateNumbers {
public:
  StateNumbers() = default; ///< puts
  explicit StateNumbers(std::vector<double> numbers) : takes_(true), numbers_(std::move(numbers)) {}

  template <class... T> void operator()(T&... members) { (one(members), ...); }

  const std::vector<double>& numbers() const { return numbers_; }
  /// Whether exactly what is there has been taken.
  bool complete() const { return next_ == numbers_.size(); }

private:
  template <class T> void one(T& x) {
    if constexpr (std::is_enum_v<T> || std::is_arithmetic_v<T>)
      number(x);
    else if constexpr (std::is_array_v<T>)
      for (auto& item : x)
        one(item);
    else
      list_state(*this, x);
  }
  template <class T, std::size_t N> void one(std::array<T, N>& list) {
    for (T& item : list)
      one(item);
  }
  template <class T> void one(std::vector<T>& list) {
    std::size_t size = list.size();
    number(size);
    list.resize(takes_ && size > numbers_.size() ? 0 : size);
    for (T& item : list)
      one(item);
  }
  template <class T> void number(T& x) {
    if (!takes_)
      numbers_.push_back(static_cast<double>(x));
    else if (next_ < numbers_.size())
      x = static_cast<T>(numbers_[next_]);
    ++next_;
  }

  bool takes_ = false;
  std::size_t next_ = 0;
  std::vector<double> numbers_;
};

template <class V, class T, int D> void list_state(V& v, Vec<T, D>& x) {
  v(x.v);
}
template <class V, class T, int D> void list_state(V& v, Mat<T, D>& x) {
  v(x.m);
}

} // namespace abut
