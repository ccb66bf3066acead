// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/gmsh/model.hpp"

#include <cstddef>
#include <string>

namespace abut::gmsh {

/// Reads the text of an MSH file from its beginning to its end: words, or numbers as they lie in
/// memory. All throw InputError at the place where they stand; model: for the names of places.
class Cursor {
public:
  Cursor(const std::string& text, const Model& model) : text_(text), model_(model) {}

  void section(const std::string& name) { section_ = name; } ///< for messages
  void set_binary(bool binary) { binary_ = binary; }         ///< how numbers are read from here on
  void set_swapped(bool swapped) { swapped_ = swapped; }     ///< of the other byte order

  /// Place of what is read next.
  std::size_t at() {
    if (!binary_)
      skip_space();
    return place();
  }
  [[noreturn]] void fail(const std::string& message) const { fail(message, place()); }
  [[noreturn]] void fail(const std::string& message, std::size_t at) const;

  /// A word of the file as it may be shown: of plain characters, short, and in quotes.
  static std::string plain(const std::string& word);
  static std::string shown(const std::string& word) { return "'" + plain(word) + "'"; }

  /// Whether nothing but white space is left.
  bool at_end();
  /// The next word of text, as in an ASCII file.
  std::string word();
  /// What is left of the line, and beyond its end.
  std::string rest_of_line();
  /// To the line feed after the present line, behind which bytes begin.
  void skip_line() { rest_of_line(); }
  /// Behind the word `end`, which must begin a line.
  void skip_to(const std::string& end);

  /// `what` is asked for: "a node number". An int is 4 bytes in a binary file, a size is 8.
  int integer(const char* what);
  Global size(const char* what);
  double real(const char* what);
  /// How many items follow, each of at least so many bytes or words: no more than there is text.
  Global count(const char* what, std::size_t bytes_each, bool is_int = false);

private:
  std::size_t place() const { return model_.binary ? position_ : line_; }
  void skip_space();
  void take(void* value, std::size_t bytes);
  Global whole(const char* what);

  const std::string& text_;
  const Model& model_;
  std::string section_;
  std::size_t position_ = 0, line_ = 1;
  bool binary_ = false, swapped_ = false;
};

} // namespace abut::gmsh
