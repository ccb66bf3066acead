// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/febio/model.hpp"
#include "abut/febio/report.hpp"
#include "tree.hpp"

#include <array>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace abut::febio {

class Element;

/// An XML document that knows which of its elements and attributes have been asked for. What nobody
/// asked for ends up refused, so that nothing is dropped in silence.
class Document {
public:
  /// The tree must outlive the document.
  explicit Document(const Tree& tree);

  Element root();

  int line(pugi::xml_node node) const { return tree_.line(node); }

  /// The fate of every element; bulk data (nodes, elements, faces, points) is counted as part of
  /// what holds it.
  Report report() const;

private:
  friend class Element;
  struct Mark {
    bool taken = false, bulk = false, settled = false;
    Fate fate = Fate::used;
    std::string note;
    std::vector<std::string> attributes, children; ///< asked for
  };
  Mark& mark(pugi::xml_node node) { return marks_[node.hash_value()]; }
  void collect(pugi::xml_node node, const std::string& path, Report& report) const;
  void add_unknown(pugi::xml_node node, const Mark& parent, const std::string& path,
                   Report& report) const;
  void add_attributes(pugi::xml_node node, const Mark& mark, const std::string& path,
                      Report& report) const;

  std::string not_supported(const std::string& what, const char* word,
                            const std::vector<std::string>& known) const;
  bool is_settled(pugi::xml_node node) const {
    const auto mark = marks_.find(node.hash_value());
    return mark != marks_.end() && mark->second.settled;
  }

  const Tree& tree_;
  std::unordered_map<std::size_t, Mark> marks_;
};

/// One element of the document. Asking for a child or an attribute marks it as used.
class Element {
public:
  Element(Document& document, pugi::xml_node node);

  std::string name() const { return node_.name(); }
  int line() const { return document_->line(node_); }
  /// "FILE:LINE: <name>: message"
  [[noreturn]] void fail(const std::string& message) const;

  /// The child of this name; an empty optional when there is none. A second one is refused.
  std::optional<Element> child(const char* name);
  Element required_child(const char* name);
  std::vector<Element> children(const char* name);
  /// All children, whatever their names.
  std::vector<Element> children();
  /// All children, which are bulk data.
  std::vector<Element> bulk();

  std::optional<std::string> attribute(const char* name);
  std::string required_attribute(const char* name);
  std::string attribute_or(const char* name, const std::string& otherwise);

  /// The child, if there is one, and all below it cannot change the answer.
  void ignore(const char* name, const std::string& why = "");
  void ignore(std::initializer_list<const char*> names, const std::string& why = "");
  /// All children that nobody asked for.
  void ignore_rest(const std::string& why);
  /// This element and all below it cannot change the answer.
  void set_ignored(const std::string& why);
  /// This element is not supported; all else goes on, so that the report is complete.
  void refuse(const std::string& why);
  void note(const std::string& text);

  std::string text() const; ///< without white space at its ends
  double number() const;
  Global integer() const;
  bool flag(); ///< 0 or 1, as FEBio reads it
  std::vector<double> numbers(std::size_t count) const;
  std::vector<Global> integers() const; ///< separated by commas or spaces
  /// The number with its load curve, from attribute lc.
  Value value();
  int curve(); ///< id of a load controller, 0: none

  /// Children by name: their number, flag, text, or `otherwise`.
  double number_or(const char* name, double otherwise);
  int whole_or(const char* name, int otherwise);
  bool flag_or(const char* name, bool otherwise);
  std::string text_or(const char* name, const std::string& otherwise);
  Value value_or(const char* name, double otherwise);
  /// Refuses the child unless it has this value.
  void expect(const char* name, double only, const std::string& why);

private:
  Document* document_;
  pugi::xml_node node_;
};

} // namespace abut::febio
