// SPDX-License-Identifier: BSD-3-Clause
#include "abut/deck/value.hpp"

#include <charconv>
#include <cmath>

namespace abut::deck {

std::string Location::text() const {
  return line > 0 ? file + ":" + std::to_string(line) : file;
}

const Value::Entry* Value::find(const std::string& key) const {
  for (const Entry& entry : entries)
    if (entry.key == key)
      return &entry;
  return nullptr;
}

std::string Value::description() const {
  switch (kind) {
  case Kind::nothing:
    return "nothing";
  case Kind::list:
    return items.size() == 1 ? "a list of 1 item"
                             : "a list of " + std::to_string(items.size()) + " items";
  case Kind::map:
    return "a map";
  case Kind::scalar:
    break;
  }
  constexpr std::size_t longest = 60;
  const std::string shown = text.size() > longest ? text.substr(0, longest) + "..." : text;
  double x = 0.0;
  return (quoted && parse_number(text, x) ? "the text '" : "'") + shown + "'";
}

bool parse_number(const std::string& text, double& x) {
  const char* first = text.data();
  const char* last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    ++first;
  const auto result = std::from_chars(first, last, x);
  return result.ec == std::errc() && result.ptr == last && std::isfinite(x);
}

bool parse_number(const std::string& text, long long& n) {
  const char* first = text.data();
  const char* last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    ++first;
  const auto result = std::from_chars(first, last, n);
  if (result.ec == std::errc() && result.ptr == last)
    return true;
  double x = 0.0;
  constexpr double exact = 9007199254740992.0; // 2^53: beyond it doubles skip whole numbers
  if (!parse_number(text, x) || x != std::floor(x) || std::abs(x) > exact)
    return false;
  n = static_cast<long long>(x);
  return true;
}

std::string number_text(double x) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, x);
  return std::string(buffer, result.ptr);
}

} // namespace abut::deck
