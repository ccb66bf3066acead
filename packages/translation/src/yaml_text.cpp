// SPDX-License-Identifier: BSD-3-Clause
#include "abut/translation/yaml_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace abut::translation {

std::string number_text(double x) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, x == 0.0 ? 0.0 : x);
  return {text, end.ptr};
}

double rounded(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return std::strtod(text, nullptr);
}

std::string quoted(const std::string& name) {
  static const std::set<std::string> words = {"y",   "n",    "yes",   "no",  "on",
                                              "off", "true", "false", "null"};
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '.' || c == '-';
  };
  if (!name.empty() && std::all_of(name.begin(), name.end(), is_plain) &&
      std::isalpha(static_cast<unsigned char>(name[0])) && !words.count(lower))
    return name;
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\')
      out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + '"';
}

std::string list_text(const std::vector<std::string>& items) {
  std::string s;
  for (const std::string& item : items)
    s += (s.empty() ? "" : ", ") + item;
  return "[" + s + "]";
}

std::string vector_text(const std::array<double, 3>& v) {
  return list_text({number_text(v[0]), number_text(v[1]), number_text(v[2])});
}

std::string FlowMap::text() const {
  std::string s;
  for (const auto& [key, value] : items_)
    s += (s.empty() ? "" : ", ") + key + ": " + value;
  return "{" + s + "}";
}

std::string FlowMap::lines(const std::string& indent) const {
  std::string s;
  for (const auto& [key, value] : items_)
    s += indent + key + ": " + value + "\n";
  return s;
}

void add_window(FlowMap& map, const Window& window) {
  if (window.from > 0.0)
    map.add("from", window.from);
  if (window.until)
    map.add("until", *window.until);
}

std::string DeckNames::make(const std::string& name, const std::string& otherwise) {
  std::string base;
  for (const char c : name.empty() ? otherwise : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) && !(c & 0x80);
    if (plain)
      base += c;
    else if (!base.empty() && base.back() != '_')
      base += '_';
  }
  constexpr std::size_t longest = 190; // decks take 200, and a number may follow
  base.resize(std::min(base.size(), longest));
  while (!base.empty() && base.back() == '_')
    base.pop_back();
  if (base.empty() || std::isdigit(static_cast<unsigned char>(base[0])))
    base = otherwise + (base.empty() ? "" : "_" + base);
  std::string unique = base;
  for (int i = 2; !taken_.insert(unique).second; ++i)
    unique = base + "_" + std::to_string(i);
  return unique;
}

} // namespace abut::translation
