// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/window.hpp"

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Pieces of YAML as a person would write them.
namespace abut::translation {

/// The shortest text that reads back as the same number.
std::string number_text(double x);
/// x to so many digits.
double rounded(double x, int digits);
/// In quotes where YAML needs them.
std::string quoted(const std::string& name);
/// [a, b, c]
std::string list_text(const std::vector<std::string>& items);
std::string vector_text(const std::array<double, 3>& v);

/// Keys of one map on one line: {a: 1, b: two}.
class FlowMap {
public:
  void add(const std::string& key, const std::string& text) { items_.emplace_back(key, text); }
  void add(const std::string& key, double x) { add(key, number_text(x)); }
  std::string text() const;
  /// The same with a line for each key.
  std::string lines(const std::string& indent) const;

private:
  std::vector<std::pair<std::string, std::string>> items_;
};

/// Keys 'from' and 'until' where something does not hold in the whole run.
void add_window(FlowMap& map, const Window& window);

/// Names of a deck's section made from another program's: letters, digits and _ alone, each once.
class DeckNames {
public:
  /// `name` may be empty: then `otherwise` is taken.
  std::string make(const std::string& name, const std::string& otherwise);

private:
  std::set<std::string> taken_;
};

} // namespace abut::translation
