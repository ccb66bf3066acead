// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/febio/report.hpp"

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace abut::febio {

/// The XML of a file. A translation may change it, and what it changes keeps the line and the name
/// that it has in the file.
class Tree {
public:
  /// Throws InputError "FILE:LINE: ..." when the text is not XML. Text that is not UTF-8 is taken
  /// as Latin 1.
  Tree(const std::string& text, std::string file);

  pugi::xml_node root() const { return xml_.document_element(); }
  const std::string& file() const { return file_; }
  int line(pugi::xml_node node) const;
  std::string name_in_file(pugi::xml_node node) const;
  /// "FILE:LINE: <name>: message"
  [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const;

  /// What becomes of a node before anybody reads it: readers do not see it.
  struct Verdict {
    Fate fate = Fate::refused;
    std::string why;
  };
  const std::unordered_map<std::size_t, Verdict>& verdicts() const { return verdicts_; }
  bool is_translated() const { return translated_; }

  /// Changes; a new node takes the place in the file of `from`, or of the one that it stands
  /// before.
  void begin_translation() { translated_ = true; }
  void rename(pugi::xml_node node, const char* name);
  pugi::xml_node append(pugi::xml_node parent, const char* name, pugi::xml_node from);
  pugi::xml_node insert_before(pugi::xml_node place, const char* name);
  void append_text(pugi::xml_node parent, const char* name, const std::string& text,
                   pugi::xml_node from);
  /// The child of this name, which is made where there is none.
  pugi::xml_node child(pugi::xml_node parent, const char* name, pugi::xml_node from);
  /// Messages take the place and the name of `from` for a node.
  void stand_for(pugi::xml_node node, pugi::xml_node from);
  void settle(pugi::xml_node node, Fate fate, const std::string& why);

private:
  struct Origin {
    std::ptrdiff_t offset;
    std::string name;
  };
  std::ptrdiff_t offset(pugi::xml_node node) const;

  std::string file_;
  std::vector<std::size_t> line_starts_;
  pugi::xml_document xml_;
  bool translated_ = false;
  std::unordered_map<std::size_t, Origin> origins_; ///< of what is not as it was
  std::unordered_map<std::size_t, Verdict> verdicts_;
};

/// Child elements, as they are now; all, or those of one name.
std::vector<pugi::xml_node> child_elements(pugi::xml_node parent, const char* name = nullptr);
/// The value of an attribute, which is taken away; nothing where there is none.
std::optional<std::string> take_attribute(pugi::xml_node node, const char* name);
/// The text of a node without white space at its ends.
std::string text_of(pugi::xml_node node);
std::string trimmed(const std::string& text);
/// Parts between these characters, trimmed, without empty ones.
std::vector<std::string> words_of(const std::string& text, const char* separators);

} // namespace abut::febio
