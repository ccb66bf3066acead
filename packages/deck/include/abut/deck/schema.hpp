// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace abut::deck {

/// One key of a deck, as documentation: collected from the declaration that also validates.
struct Field {
  enum class Kind {
    value,     ///< a scalar or a list of scalars
    group,     ///< a map with the keys `fields`
    named_map, ///< a map from free names to maps with the keys `fields`
    curve_map, ///< a map from free names to lists of [t, value]
    free_map,  ///< a map whose keys are checked elsewhere
  };
  Kind kind = Kind::value;
  std::string key;
  std::string type;    ///< number, whole number, number or expression, text, ...
  std::string initial; ///< default as text, empty: none
  std::string range;   ///< "> 0", empty: any
  std::string word;    ///< that stands in place of a number, empty: none
  std::string unit;
  std::string doc;
  bool required = false;
  std::vector<std::pair<std::string, std::string>> choices; ///< word, meaning
  std::vector<std::string> with;         ///< alternatives that this key belongs to; empty: all
  std::vector<std::string> one_of;       ///< of a map: exactly one of these keys
  std::vector<std::string> at_least_one; ///< of a map: one or more of these keys
  std::vector<Field> fields;
};

/// The whole deck; the top has no key.
Field schema();

std::string schema_text();     ///< for a terminal
std::string schema_markdown(); ///< docs/user/deck-reference.md
std::string schema_json();     ///< JSON Schema (draft 7) for editors

} // namespace abut::deck
