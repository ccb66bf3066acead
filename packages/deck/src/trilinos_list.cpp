// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/parse.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLParameterListWriter.hpp>
#include <limits>

namespace abut::deck {

namespace {

enum class Type { whole, large, number, boolean, text };

Type type_of(const Value& scalar) {
  long long n = 0;
  double x = 0.0;
  if (scalar.quoted)
    return Type::text;
  if (scalar.text == "true" || scalar.text == "false")
    return Type::boolean;
  const bool like_integer = scalar.text.find_first_of(".eE") == std::string::npos;
  if (like_integer && parse_number(scalar.text, n))
    return n == static_cast<int>(n) ? Type::whole : Type::large;
  return parse_number(scalar.text, x) ? Type::number : Type::text;
}

/// Teuchos writes names and values into XML as they are.
std::string escaped(const std::string& text) {
  std::string s;
  for (const char c : text) {
    if (c == '&')
      s += "&amp;";
    else if (c == '<')
      s += "&lt;";
    else if (c == '>')
      s += "&gt;";
    else if (c == '"')
      s += "&quot;";
    else
      s += c;
  }
  return s;
}

void convert(const Value& scalar, std::string& out) {
  out = escaped(scalar.text);
}
void convert(const Value& scalar, double& out) {
  parse_number(scalar.text, out);
}
void convert(const Value& scalar, long long& out) {
  parse_number(scalar.text, out);
}
void convert(const Value& scalar, bool& out) {
  out = scalar.text == "true";
}
void convert(const Value& scalar, int& out) {
  long long n = 0;
  parse_number(scalar.text, n);
  out = static_cast<int>(n);
}

[[noreturn]] void fail(const Value::Entry& entry, const std::string& message) {
  throw InputError(entry.where.text() + ": " + entry.key + ": " + message);
}

/// XML attributes, which the values become, cannot hold these.
void refuse_control_characters(const Value::Entry& entry, const std::string& text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20)
      fail(entry, "expected one line of text without control characters");
}

template <class T> void set_scalar(Teuchos::ParameterList& list, const Value::Entry& entry) {
  T x{};
  convert(entry.value, x);
  list.set(escaped(entry.key), x);
}

template <class T> void set_array(Teuchos::ParameterList& list, const Value::Entry& entry) {
  Teuchos::Array<T> array;
  for (const Value& item : entry.value.items) {
    T x{};
    convert(item, x);
    array.push_back(x);
  }
  list.set(escaped(entry.key), array);
}

void set_list(Teuchos::ParameterList& list, const Value::Entry& entry) {
  if (entry.value.items.empty())
    fail(entry, "an empty list has no type");
  Type type = Type::whole;
  for (const Value& item : entry.value.items) {
    if (item.kind != Value::Kind::scalar)
      fail(entry, "expected a list of numbers or texts, an item is " + item.description());
    const Type t = type_of(item);
    // Items of mixed kinds: numbers become double, anything else text.
    refuse_control_characters(entry, item.text);
    type = std::max(type, t == Type::boolean ? Type::text : t);
  }
  for (const Value& item : entry.value.items)
    if (type == Type::text && item.text.find_first_of(",{}") != std::string::npos)
      fail(entry, "an item of an Array must not hold ',', '{' or '}': '" + item.text + "'");
  switch (type) {
  case Type::whole:
    return set_array<int>(list, entry);
  case Type::large:
    return set_array<long long>(list, entry);
  case Type::number:
    return set_array<double>(list, entry);
  default:
    return set_array<std::string>(list, entry);
  }
}

void set_map(Teuchos::ParameterList& list, const Value& map) {
  for (const Value::Entry& entry : map.entries) {
    refuse_control_characters(entry, entry.key + entry.value.text);
    switch (entry.value.kind) {
    case Value::Kind::nothing:
      fail(entry, "expected a value, got nothing");
    case Value::Kind::map:
      set_map(list.sublist(escaped(entry.key)), entry.value);
      continue;
    case Value::Kind::list:
      set_list(list, entry);
      continue;
    case Value::Kind::scalar:
      break;
    }
    switch (type_of(entry.value)) {
    case Type::whole:
      set_scalar<int>(list, entry);
      break;
    case Type::large:
      set_scalar<long long>(list, entry);
      break;
    case Type::number:
      set_scalar<double>(list, entry);
      break;
    case Type::boolean:
      set_scalar<bool>(list, entry);
      break;
    case Type::text:
      set_scalar<std::string>(list, entry);
      break;
    }
  }
}

} // namespace

std::string to_parameter_list_xml(const Value& map, const std::string& name) {
  Teuchos::ParameterList list(name);
  set_map(list, map);
  return Teuchos::XMLParameterListWriter().toXML(list).toString();
}

} // namespace abut::deck
