// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <functional>
#include <string>
#include <utility>

namespace abut {

/// What varies with the load parameter t, and maybe in space: a number, which a curve multiplies
/// (the load parameter itself where none is given), or an expression, which a curve multiplies only
/// where one is given.
struct Amount {
  using Function = std::function<double(const Vec3& position, double t)>;

  double number = 0.0;
  std::string expression; ///< as written; empty for a number
  Function function;      ///< of the reference position; set with an expression

  Amount(double n = 0.0) : number(n) {}
  Amount(std::string text, Function f) : expression(std::move(text)), function(std::move(f)) {}

  /// Value at a reference position; curve may be empty. Throws what the function throws: InputError
  /// where the expression is not finite.
  double at(const Vec3& position, double t, const std::function<double(double)>& curve) const {
    if (function)
      return function(position, t) * (curve ? curve(t) : 1.0);
    return number * (curve ? curve(t) : t);
  }
  friend bool operator==(const Amount& a, const Amount& b) {
    return a.number == b.number && a.expression == b.expression;
  }
};

} // namespace abut
