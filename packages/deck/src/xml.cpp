// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/parse.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TwoDArray.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>
#include <type_traits>

namespace abut::deck {

namespace {

[[noreturn]] void fail(const Location& where, const std::string& message) {
  throw InputError(where.text() + ": " + message);
}

/// Where each named element stands. Teuchos keeps no line numbers, so the text is read twice.
struct Element {
  std::string tag, name, type, value;
  Location where;
  std::vector<Element> children;

  const Element* find(const std::string& key) const {
    for (const Element& child : children)
      if (child.name == key)
        return &child;
    return nullptr;
  }
};

std::string decoded(std::string s) {
  const std::pair<const char*, char> entities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  for (const auto& [code, character] : entities)
    for (std::size_t at = 0; (at = s.find(code, at)) != std::string::npos; ++at)
      s.replace(at, std::string(code).size(), 1, character);
  return s;
}

/// Reads the tags of an XML text: their nesting, names and lines.
class TagScanner {
public:
  TagScanner(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  Element scan() {
    Element document;
    while (skip_to_tag()) {
      if (text_.compare(at_, 2, "</") == 0)
        fail(here(), "closing tag without an opening one");
      document.children.push_back(element(0));
    }
    if (document.children.size() != 1 || document.children[0].tag != "ParameterList")
      fail({file_, 1, 1}, "not valid XML: expected one <ParameterList> around everything");
    return std::move(document.children[0]);
  }

private:
  Location here() const {
    const auto start = text_.begin();
    const auto lines = std::count(start, start + static_cast<std::ptrdiff_t>(at_), '\n');
    return {file_, static_cast<int>(lines) + 1, 1};
  }

  void skip_past(const char* end) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string::npos)
      fail(here(), std::string("not valid XML: no '") + end + "' ends what begins here");
    at_ = found + std::string(end).size();
  }

  /// To the next opening or closing tag, past comments and declarations; false at the end.
  bool skip_to_tag() {
    while ((at_ = std::min(text_.find('<', at_), text_.size())) < text_.size()) {
      if (text_.compare(at_, 4, "<!--") == 0)
        skip_past("-->");
      else if (text_.compare(at_, 2, "<?") == 0)
        skip_past("?>");
      else if (text_.compare(at_, 2, "<!") == 0)
        skip_past(">");
      else
        return true;
    }
    return false;
  }

  std::string word() {
    const std::size_t first = at_;
    const std::string stops = "=<>/\"'";
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_])) &&
           stops.find(text_[at_]) == std::string::npos)
      ++at_;
    return text_.substr(first, at_ - first);
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
      ++at_;
  }

  /// Attributes up to the tag's end. Returns whether the element has content ('>' and not '/>').
  bool attributes(Element& element) {
    for (;;) {
      skip_blanks();
      if (text_.compare(at_, 2, "/>") == 0)
        return at_ += 2, false;
      if (text_.compare(at_, 1, ">") == 0)
        return at_ += 1, true;
      const std::string key = word();
      skip_blanks();
      if (key.empty() || at_ + 1 >= text_.size() || text_[at_] != '=')
        fail(element.where,
             "not valid XML: in the tag <" + element.tag + ">: expected name=\"...\"");
      ++at_;
      skip_blanks();
      const char quote = at_ < text_.size() ? text_[at_] : ' ';
      const std::size_t end = text_.find(quote, at_ + 1);
      if ((quote != '"' && quote != '\'') || end == std::string::npos)
        fail(element.where, "not valid XML: the value of '" + key + "' needs quotes around it");
      const std::string text = decoded(text_.substr(at_ + 1, end - at_ - 1));
      if (key == "name")
        element.name = text;
      if (key == "type")
        element.type = text;
      if (key == "value")
        element.value = text;
      at_ = end + 1;
    }
  }

  Element element(int depth) {
    Element e;
    e.where = here();
    if (depth > 50)
      fail(e.where, "nested too deeply");
    ++at_;
    e.tag = word();
    if (!attributes(e))
      return e;
    for (;;) {
      if (!skip_to_tag())
        fail(e.where, "not valid XML: <" + e.tag + "> is never closed");
      if (text_.compare(at_, 2, "</") == 0)
        break;
      Element child = element(depth + 1);
      if (const Element* first = child.name.empty() ? nullptr : e.find(child.name))
        fail(child.where, "key '" + child.name + "' is given twice, first in line " +
                              std::to_string(first->where.line));
      e.children.push_back(std::move(child));
    }
    const Location closing = here();
    at_ += 2;
    const std::string tag = word();
    if (tag != e.tag)
      fail(closing, "not valid XML: </" + tag + "> closes <" + e.tag + "> of line " +
                        std::to_string(e.where.line));
    skip_past(">");
    return e;
  }

  const std::string& text_;
  std::string file_;
  std::size_t at_ = 0;
};

bool readable(const std::string& type, const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  const std::string word = first == std::string::npos ? "" : text.substr(first, last - first + 1);
  double x = 0.0;
  long long n = 0;
  if (type == "double")
    return parse_number(word, x);
  if (type == "bool")
    return word == "true" || word == "false";
  if (type == "int")
    return parse_number(word, n) && n == static_cast<int>(n);
  if (type == "long long")
    return parse_number(word, n);
  return true; // string
}

/// Teuchos reads 'abc' as the int 0 without a word, so each value is held against its type first.
void check_values(const Element& element) {
  for (const Element& child : element.children)
    check_values(child);
  if (element.tag != "Parameter")
    return;
  const std::string types[] = {"int",
                               "double",
                               "bool",
                               "string",
                               "long long",
                               "Array(int)",
                               "Array(double)",
                               "Array(string)",
                               "Array(long long)",
                               "TwoDArray(int)",
                               "TwoDArray(double)"};
  if (std::find(std::begin(types), std::end(types), element.type) == std::end(types))
    fail(element.where, element.name + ": unknown type '" + element.type + "'; " +
                            nearest_word_hint(element.type, types, std::size(types)));
  const std::size_t open = element.type.find('(');
  std::string type = element.type;
  std::vector<std::string> texts{element.value};
  if (open != std::string::npos) {
    type = type.substr(open + 1, type.size() - open - 2);
    const std::size_t begin = element.value.find('{');
    const std::size_t end = element.value.rfind('}');
    if (begin == std::string::npos || end == std::string::npos || end < begin)
      fail(element.where, element.name + ": expected " + element.type + " as {a, b, ...}, got '" +
                              element.value + "'");
    std::istringstream items(element.value.substr(begin + 1, end - begin - 1));
    texts.clear();
    for (std::string item; std::getline(items, item, ',');)
      texts.push_back(item);
  }
  for (const std::string& text : texts)
    if (!readable(type, text))
      fail(element.where, element.name + ": expected type " + type + ", got '" + text + "'");
}

template <class T> std::string scalar_text(const T& x) {
  if constexpr (std::is_same_v<T, std::string>) {
    return x;
  } else if constexpr (std::is_same_v<T, bool>) {
    return x ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    const std::string text = number_text(x);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  } else {
    return std::to_string(x);
  }
}

template <class T> Value scalar(const T& x, const Location& where) {
  Value value;
  value.kind = Value::Kind::scalar;
  value.where = where;
  value.text = scalar_text(x);
  value.quoted = std::is_same_v<T, std::string>;
  return value;
}

Value list(const Location& where) {
  Value value;
  value.kind = Value::Kind::list;
  value.where = where;
  return value;
}

using Teuchos::any_cast;

/// Each returns false when the parameter is of another type.
template <class T> bool read_scalar(const Teuchos::ParameterEntry& entry, Value& value) {
  if (!entry.isType<T>())
    return false;
  value = scalar(any_cast<T>(entry.getAny(false)), value.where);
  return true;
}
template <class T> bool read_array(const Teuchos::ParameterEntry& entry, Value& value) {
  if (!entry.isType<Teuchos::Array<T>>())
    return false;
  value = list(value.where);
  for (const T& x : any_cast<Teuchos::Array<T>>(entry.getAny(false)))
    value.items.push_back(scalar(x, value.where));
  return true;
}
template <class T> bool read_table(const Teuchos::ParameterEntry& entry, Value& value) {
  if (!entry.isType<Teuchos::TwoDArray<T>>())
    return false;
  const auto& table = any_cast<Teuchos::TwoDArray<T>>(entry.getAny(false));
  value = list(value.where);
  for (int i = 0; i < static_cast<int>(table.getNumRows()); ++i) {
    Value row = list(value.where);
    for (int j = 0; j < static_cast<int>(table.getNumCols()); ++j)
      row.items.push_back(scalar(T(table(i, j)), value.where));
    value.items.push_back(std::move(row));
  }
  return true;
}

Value map_value(const Teuchos::ParameterList& parameters, const Element& element) {
  Value map;
  map.kind = Value::Kind::map;
  map.where = element.where;
  for (const auto& parameter : parameters) {
    const std::string& key = parameter.first;
    const Teuchos::ParameterEntry& entry = parameter.second;
    const Element* child = element.find(key);
    const Location where = child ? child->where : element.where;
    Value value;
    value.where = where;
    if (entry.isList())
      value = map_value(Teuchos::getValue<Teuchos::ParameterList>(entry), child ? *child : element);
    else if (!(read_scalar<int>(entry, value) || read_scalar<double>(entry, value) ||
               read_scalar<bool>(entry, value) || read_scalar<std::string>(entry, value) ||
               read_scalar<long long>(entry, value) || read_array<int>(entry, value) ||
               read_array<double>(entry, value) || read_array<std::string>(entry, value) ||
               read_array<long long>(entry, value) || read_table<int>(entry, value) ||
               read_table<double>(entry, value)))
      ABUT_REQUIRE(false, "'" + key + "' has a type that check_values lets through");
    map.entries.push_back({key, where, std::move(value)});
  }
  return map;
}

/// The part of a Teuchos message that tells the user something: it begins with lines of its own.
std::string essence(const std::string& message) {
  std::string rest = message;
  const std::size_t condition = rest.find("Throw test that evaluated to true:");
  if (condition != std::string::npos) {
    const std::size_t end = rest.find('\n', condition);
    if (end != std::string::npos)
      rest.erase(0, end);
  }
  for (char& c : rest)
    if (c == '\n')
      c = ' ';
  rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
  const std::size_t last = rest.find_last_not_of(' ');
  return last == std::string::npos ? message : rest.substr(0, last + 1);
}

} // namespace

Value parse_xml(const std::string& text, const std::string& file) {
  const Element top = TagScanner(text, file).scan();
  check_values(top);
  Teuchos::RCP<Teuchos::ParameterList> parameters;
  try {
    parameters = Teuchos::getParametersFromXmlString(text);
  } catch (const std::exception& e) {
    fail(top.where, "not a valid ParameterList: " + essence(e.what()));
  }
  return map_value(*parameters, top);
}

Value parse(const std::string& text, const std::string& file) {
  const auto ends_with = [&](const std::string& end) {
    return file.size() >= end.size() &&
           file.compare(file.size() - end.size(), end.size(), end) == 0;
  };
  if (ends_with(".yaml") || ends_with(".yml"))
    return parse_yaml(text, file);
  if (ends_with(".xml"))
    return parse_xml(text, file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool xml = first != std::string::npos && text[first] == '<';
  return xml ? parse_xml(text, file) : parse_yaml(text, file);
}

} // namespace abut::deck
