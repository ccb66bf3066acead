// SPDX-License-Identifier: BSD-3-Clause
#include "element.hpp"

#include "abut/core/error.hpp"
#include "abut/translation/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace abut::febio {

namespace {

using translation::is_sane;

bool parse_double(const std::string& s, double& x) {
  char* end = nullptr;
  x = std::strtod(s.c_str(), &end);
  return !s.empty() && end == s.c_str() + s.size() && is_sane(x) &&
         s.find_first_of("xX") == std::string::npos;
}

bool parse_integer(const std::string& s, Global& n) {
  char* end = nullptr;
  errno = 0;
  n = std::strtoll(s.c_str(), &end, 10);
  return !s.empty() && end == s.c_str() + s.size() && errno == 0;
}

/// What FEBio reads as 0, whichever of the two it is.
bool is_truth_word(const std::string& s) {
  for (const char* word : {"True", "true", "TRUE", "False", "false", "FALSE"})
    if (s == word)
      return true;
  return false;
}

/// Parts between commas, or between white space where there are no commas.
std::vector<std::string> split(const std::string& s) {
  const char* separators = s.find(',') == std::string::npos ? " \t\r\n" : ",";
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= s.size();) {
    const std::size_t end = std::min(s.find_first_of(separators, at), s.size());
    const std::string part = trimmed(s.substr(at, end - at));
    if (!part.empty() || separators[0] == ',')
      parts.push_back(part);
    at = end + 1;
  }
  return parts;
}

} // namespace

Document::Document(const Tree& tree) : tree_(tree) {
  for (const auto& [node, verdict] : tree.verdicts()) {
    Mark& mark = marks_[node];
    mark.taken = mark.settled = true;
    mark.fate = verdict.fate;
    mark.note = verdict.why;
  }
}

Element Document::root() {
  return {*this, tree_.root()};
}

Report Document::report() const {
  Report report;
  const pugi::xml_node root = tree_.root();
  const auto mark = marks_.find(root.hash_value());
  add_attributes(root, mark->second, root.name(), report);
  for (const pugi::xml_node child : root.children())
    if (child.type() == pugi::node_element)
      collect(child, tree_.name_in_file(child), report);
  return report;
}

void Document::add_unknown(pugi::xml_node node, const Mark& parent, const std::string& path,
                           Report& report) const {
  const auto& known = parent.children;
  const bool twice = std::find(known.begin(), known.end(), node.name()) != known.end();
  report.add({line(node), path, Fate::refused,
              twice ? "given twice" : not_supported("", node.name(), known)});
}

void Document::add_attributes(pugi::xml_node node, const Mark& mark, const std::string& path,
                              Report& report) const {
  for (const pugi::xml_attribute a : node.attributes())
    if (std::find(mark.attributes.begin(), mark.attributes.end(), a.name()) ==
        mark.attributes.end())
      report.add({line(node), path, Fate::refused,
                  not_supported(std::string("attribute '") + a.name() + "' is ", a.name(),
                                mark.attributes)});
}

/// The words that are valid are those of specification 4.0: no help in an older file.
std::string Document::not_supported(const std::string& what, const char* word,
                                    const std::vector<std::string>& known) const {
  const std::string text = what + "not supported here";
  return tree_.is_translated() ? text
                               : text + "; " + nearest_word_hint(word, known.data(), known.size());
}

void Document::collect(pugi::xml_node node, const std::string& path, Report& report) const {
  const auto found = marks_.find(node.hash_value());
  if (found == marks_.end() || !found->second.taken) {
    const auto parent = marks_.find(node.parent().hash_value());
    add_unknown(node, parent == marks_.end() ? Mark{} : parent->second, path, report);
    return;
  }
  const Mark& mark = found->second;
  if (mark.fate == Fate::used)
    add_attributes(node, mark, path, report);
  if (mark.bulk)
    return;
  const char* name = node.attribute("name").value();
  report.add(
      {line(node), path + (*name ? " '" + std::string(name) + "'" : ""), mark.fate, mark.note});
  if (mark.fate != Fate::used)
    return;
  for (const pugi::xml_node child : node.children())
    if (child.type() == pugi::node_element)
      collect(child, path + "/" + tree_.name_in_file(child), report);
}

Element::Element(Document& document, pugi::xml_node node) : document_(&document), node_(node) {
  document.mark(node).taken = true;
}

void Element::fail(const std::string& message) const {
  document_->tree_.fail(node_, message);
}

std::optional<Element> Element::child(const char* name) {
  document_->mark(node_).children.push_back(name);
  for (const pugi::xml_node node : node_.children(name))
    if (!document_->is_settled(node))
      return Element(*document_, node);
  return {};
}

Element Element::required_child(const char* name) {
  auto found = child(name);
  if (!found)
    fail(std::string("expected an element <") + name + "> in it");
  return *found;
}

std::vector<Element> Element::children(const char* name) {
  document_->mark(node_).children.push_back(name);
  std::vector<Element> result;
  for (const pugi::xml_node node : node_.children(name))
    if (!document_->is_settled(node))
      result.emplace_back(*document_, node);
  return result;
}

std::vector<Element> Element::children() {
  std::vector<Element> result;
  for (const pugi::xml_node node : node_.children())
    if (node.type() == pugi::node_element && !document_->is_settled(node))
      result.emplace_back(*document_, node);
  return result;
}

std::vector<Element> Element::bulk() {
  std::vector<Element> result = children();
  for (Element& e : result)
    document_->mark(e.node_).bulk = true;
  return result;
}

std::optional<std::string> Element::attribute(const char* name) {
  document_->mark(node_).attributes.push_back(name);
  const pugi::xml_attribute a = node_.attribute(name);
  if (!a)
    return {};
  const std::string value = trimmed(a.value());
  constexpr std::size_t longest = 240; // a name in Exodus files, with room for what is added to it
  if (value.size() > longest)
    fail(std::string("attribute '") + name + "' is longer than " + std::to_string(longest) +
         " bytes");
  return value;
}

std::string Element::required_attribute(const char* name) {
  const auto found = attribute(name);
  if (!found || found->empty())
    fail(std::string("expected an attribute '") + name + "'");
  return *found;
}

std::string Element::attribute_or(const char* name, const std::string& otherwise) {
  return attribute(name).value_or(otherwise);
}

void Element::ignore(const char* name, const std::string& why) {
  for (Element& e : children(name))
    e.set_ignored(why);
}

void Element::ignore(std::initializer_list<const char*> names, const std::string& why) {
  for (const char* name : names)
    ignore(name, why);
}

void Element::ignore_rest(const std::string& why) {
  const auto asked = document_->mark(node_).children;
  for (Element& e : children())
    if (std::find(asked.begin(), asked.end(), e.name()) == asked.end())
      e.set_ignored(why);
}

void Element::set_ignored(const std::string& why) {
  Document::Mark& mark = document_->mark(node_);
  mark.fate = Fate::ignored;
  mark.note = why;
}

void Element::refuse(const std::string& why) {
  Document::Mark& mark = document_->mark(node_);
  if (mark.fate == Fate::refused)
    return;
  mark.fate = Fate::refused;
  mark.note = why;
}

void Element::note(const std::string& text) {
  std::string& note = document_->mark(node_).note;
  note += (note.empty() ? "" : "; ") + text;
}

std::string Element::text() const {
  return text_of(node_);
}

double Element::number() const {
  double x = 0.0;
  if (!parse_double(text(), x))
    fail((is_sane(x) ? "expected a number, got '"
                     : "expected a number from 1e-100 to 1e100, got '") +
         text() + "'");
  return x;
}

Global Element::integer() const {
  Global n = 0;
  if (!parse_integer(text(), n))
    fail("expected a whole number, got '" + text() + "'");
  return n;
}

bool Element::flag() {
  const std::string s = text();
  if (is_truth_word(s)) {
    note("'" + s + "' is no number: FEBio reads 0");
    return false;
  }
  if (s != "0" && s != "1")
    fail("expected 0 or 1, got '" + s + "'");
  return s == "1";
}

std::vector<double> Element::numbers(std::size_t count) const {
  std::vector<double> result;
  for (const std::string& part : split(text())) {
    double x = 0.0;
    if (!parse_double(part, x))
      fail("expected " + std::to_string(count) + " numbers, got '" + text() + "'");
    result.push_back(x);
  }
  if (result.size() != count)
    fail("expected " + std::to_string(count) + " numbers, got " + std::to_string(result.size()));
  return result;
}

std::vector<Global> Element::integers() const {
  std::vector<Global> result;
  for (const std::string& part : split(text())) {
    Global n = 0;
    if (!parse_integer(part, n))
      fail("expected whole numbers, got '" + part + "'");
    result.push_back(n);
  }
  return result;
}

Value Element::value() {
  Value v;
  v.number = number();
  v.line = line();
  v.curve = curve();
  return v;
}

int Element::curve() {
  const auto lc = attribute("lc");
  if (!lc)
    return 0;
  Global id = 0;
  if (!parse_integer(*lc, id) || id < 1)
    fail("expected the id of a load controller in lc, got '" + *lc + "'");
  return static_cast<int>(id);
}

double Element::number_or(const char* name, double otherwise) {
  const auto found = child(name);
  return found ? found->number() : otherwise;
}

int Element::whole_or(const char* name, int otherwise) {
  const auto found = child(name);
  if (!found)
    return otherwise;
  const Global n = found->integer();
  if (n < -1000000000 || n > 1000000000)
    found->fail("expected a whole number up to a billion, got '" + found->text() + "'");
  return static_cast<int>(n);
}

bool Element::flag_or(const char* name, bool otherwise) {
  auto found = child(name);
  return found ? found->flag() : otherwise;
}

std::string Element::text_or(const char* name, const std::string& otherwise) {
  const auto found = child(name);
  return found ? found->text() : otherwise;
}

Value Element::value_or(const char* name, double otherwise) {
  auto found = child(name);
  if (found)
    return found->value();
  Value v;
  v.number = otherwise;
  v.line = line();
  return v;
}

void Element::expect(const char* name, double only, const std::string& why) {
  auto found = child(name);
  if (found && (is_truth_word(found->text()) ? found->flag() : found->number()) != only)
    found->refuse(why);
}

} // namespace abut::febio
