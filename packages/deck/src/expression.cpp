// SPDX-License-Identifier: BSD-3-Clause
#include "expression.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/value.hpp"

#include <cmath>
#include <memory>
#include <muParser.h>
#include <vector>

namespace abut::deck {

namespace {

constexpr double pi = 3.14159265358979323846;

class Formula {
public:
  Formula(const std::string& text, const std::string& where) : text_(text), where_(where) {
    parser_.ClearConst();
    parser_.DefineConst("pi", pi);
    parser_.DefineVar("x", &x_[0]);
    parser_.DefineVar("y", &x_[1]);
    parser_.DefineVar("z", &x_[2]);
    parser_.DefineVar("t", &t_);
    require_no_assignment();
    try {
      parser_.SetExpr(text);
      parser_.Eval();
      if (parser_.GetNumResults() != 1)
        fail("expected one value, got " + std::to_string(parser_.GetNumResults()) +
             " separated by commas");
    } catch (const mu::ParserError& e) {
      fail(explain(e));
    }
  }
  Formula(const Formula&) = delete;

  double operator()(const Vec3& position, double t) {
    for (int i = 0; i < 3; ++i)
      x_[i] = position[i];
    t_ = t;
    double value = 0.0;
    try {
      value = parser_.Eval();
    } catch (const mu::ParserError& e) {
      fail(e.GetMsg());
    }
    if (!std::isfinite(value))
      fail("not finite at x = " + number_text(x_[0]) + ", y = " + number_text(x_[1]) +
           ", z = " + number_text(x_[2]) + ", t = " + number_text(t));
    return value;
  }

private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(where_ + ": expression '" + text_ + "': " + message);
  }

  /// muParser would let "x = 1" change the position itself.
  void require_no_assignment() const {
    for (std::size_t i = text_.find('='); i != std::string::npos; i = text_.find('=', i + 1)) {
      if (i + 1 < text_.size() && text_[i + 1] == '=')
        ++i;
      else if (i == 0 || std::string("<>!").find(text_[i - 1]) == std::string::npos)
        fail("'=' assigns, comparison is '=='");
    }
  }

  std::string explain(const mu::ParserError& e) const {
    if (e.GetCode() != mu::ecUNASSIGNABLE_TOKEN)
      return e.GetMsg() + " (a formula in x, y, z, t, pi and functions such as sin)";
    std::vector<std::string> known{"x", "y", "z", "t", "pi"};
    for (const auto& entry : parser_.GetFunDef())
      known.push_back(entry.first);
    return "unknown name '" + e.GetToken() + "'; " +
           nearest_word_hint(e.GetToken(), known.data(), known.size());
  }

  std::string text_, where_;
  mu::Parser parser_;
  double x_[3] = {0.0, 0.0, 0.0}, t_ = 0.0;
};

} // namespace

Amount::Function compile_expression(const std::string& text, const std::string& where) {
  const auto formula = std::make_shared<Formula>(text, where);
  return [formula](const Vec3& position, double t) { return (*formula)(position, t); };
}

} // namespace abut::deck
