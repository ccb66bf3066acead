// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cctype>

namespace abut::abaqus {

namespace {

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Of a name, what a message has room for.
std::string shown(const std::string& name) {
  constexpr std::size_t longest = 80;
  return name.substr(0, longest);
}

template <class Map> std::string nearest(const std::string& key, const Map& map) {
  std::vector<std::string> names;
  for (const auto& entry : map)
    names.push_back(entry.second.name);
  return nearest_word_hint(key, names.data(), names.size());
}

} // namespace

std::string name_of(const Card& card, const std::string& value) {
  constexpr std::size_t longest = 80;
  std::string name;
  std::copy_if(value.begin(), value.end(), std::back_inserter(name),
               [](char c) { return c != '"'; });
  if (name.size() > longest)
    card.fail("expected a name of at most 80 letters");
  if (key_of(name).empty())
    card.fail("expected a name");
  return name;
}

std::vector<int> Lookup::nodes(const Card& card, const DataLine& line, const std::string& field,
                               const Scope& scope) const {
  return members(card, line, field, scope, true);
}

std::vector<int> Lookup::elements(const Card& card, const DataLine& line, const std::string& field,
                                  const Scope& scope) const {
  return members(card, line, field, scope, false);
}

std::vector<int> Lookup::members(const Card& card, const DataLine& line, const std::string& field,
                                 const Scope& scope, bool of_nodes) const {
  const char* const what = of_nodes ? "node" : "element";
  const auto numbered = [&](const Scope& s, const std::string& number) {
    const auto& map = of_nodes ? s.nodes : s.elements;
    const auto found = map.find(card.whole(line, number, "a number"));
    if (found == map.end())
      card.fail(line.place, std::string("there is no ") + what + " " + number +
                                (s.spelled.empty() ? "" : " in instance " + s.spelled));
    return std::vector<int>{found->second};
  };
  const std::string key = key_of(field);
  if (is_number(key))
    return numbered(scope, key);
  const auto& sets = of_nodes ? model_.node_sets : model_.element_sets;
  for (const std::string& name : {scope.prefix + key, key})
    if (const auto found = sets.find(name); found != sets.end())
      return found->second.members;
  const std::size_t dot = key.find('.');
  for (const Scope* s : scopes_)
    if (dot != std::string::npos && s->prefix == key.substr(0, dot + 1) &&
        is_number(key.substr(dot + 1)))
      return numbered(*s, key.substr(dot + 1));
  card.fail(line.place, std::string("there is no ") + what + " set '" + shown(field) + "'; " +
                            nearest(shown(field), sets));
}

int Lookup::node(const Card& card, const std::string& field, const Scope& scope) const {
  const std::vector<int> list = nodes(card, {card.place(), {}}, field, scope);
  if (list.size() != 1)
    card.fail("expected a single node, got the set '" + field + "' of " +
              std::to_string(list.size()));
  return list[0];
}

const Scope& Lookup::instance(const Card& card, const std::string& name) const {
  std::vector<std::string> names;
  for (const Scope* s : scopes_) {
    if (s->prefix == key_of(name) + ".")
      return *s;
    if (!s->spelled.empty())
      names.push_back(s->spelled.substr(0, s->spelled.size() - 1));
  }
  card.fail("there is no instance '" + name + "'; " +
            nearest_word_hint(name, names.data(), names.size()));
}

std::string Lookup::surface_key(const Card& card, const Place& at, const std::string& name,
                                const Scope& scope) const {
  for (const std::string& key : {scope.prefix + key_of(name), key_of(name)})
    if (model_.surfaces.count(key))
      return key;
  card.fail(at,
            "there is no surface '" + shown(name) + "'; " + nearest(shown(name), model_.surfaces));
}

const Surface& Lookup::surface(const Card& card, const Place& at, const std::string& name,
                               const Scope& scope) const {
  return model_.surfaces.at(surface_key(card, at, name, scope));
}

} // namespace abut::abaqus
