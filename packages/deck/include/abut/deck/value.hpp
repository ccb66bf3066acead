// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace abut::deck {

/// A place in a text file; lines and columns count from 1.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;

  std::string text() const; ///< "FILE:LINE", or "FILE" when the line is not known
};

/// What a deck's text says, before it means anything: a tree of scalars, lists and maps, each with
/// its place in the file. YAML and XML end in the same tree.
struct Value {
  enum class Kind { nothing, scalar, list, map };
  struct Entry;

  Kind kind = Kind::nothing;
  Location where;
  std::string text;           ///< of a scalar
  bool quoted = false;        ///< a scalar that is text even where it reads like a number
  std::vector<Value> items;   ///< of a list
  std::vector<Entry> entries; ///< of a map, in file order

  const Entry* find(const std::string& key) const; ///< nullptr when absent
  std::string description() const;                 ///< for messages: 'abc', a list, a map, nothing
};

struct Value::Entry {
  std::string key;
  Location where; ///< of the key
  Value value;
};

/// Numbers as decks write them. Return false when `text` is not wholly a finite number of the kind;
/// a whole number may be written 1e5.
bool parse_number(const std::string& text, double& x);
bool parse_number(const std::string& text, long long& n);

/// Shortest text that reads back as x.
std::string number_text(double x);

} // namespace abut::deck
