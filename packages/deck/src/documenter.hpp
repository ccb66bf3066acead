// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "abut/deck/schema.hpp"
#include "print.hpp"
#include "rule.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace abut::deck {

/// The visitor that collects every key of one map, whatever the alternatives.
class Documenter {
public:
  explicit Documenter(Field& map) : map_(map) {}

  template <class T>
  void required(const char* key, const T&, const char* doc, const Rule& rule = {}) {
    add_value(key, type_of(static_cast<const T*>(nullptr)), doc, rule).required = true;
  }
  template <class T>
  void optional(const char* key, const T& x, const char* doc, const Rule& rule = {}) {
    Field& field = add_value(key, type_of(static_cast<const T*>(nullptr)), doc, rule);
    if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<std::string>>) {
      if (!x.empty())
        field.initial = printed(x);
    } else {
      field.initial = printed(x);
    }
  }
  template <class T>
  void optional(const char* key, const std::optional<T>&, const char* doc, const Rule& rule = {}) {
    add_value(key, type_of(static_cast<const T*>(nullptr)), doc, rule);
  }
  template <class T>
  void number_or(const char* key, const std::optional<T>& x, const char* word, const char* doc,
                 const Rule& rule) {
    optional(key, x, doc, rule);
    map_.fields.back().word = word;
    map_.fields.back().initial = x ? printed(*x) : word;
  }

  template <class E>
  void choice(const char* key, const E& x, std::initializer_list<Choice<E>> choices,
              const char* doc) {
    Field& field = add_value(key, "word", doc, {});
    for (const Choice<E>& c : choices) {
      field.choices.emplace_back(c.word, c.doc ? c.doc : "");
      if (c.value == x)
        field.initial = c.word;
    }
  }
  template <class E>
  void required_choice(const char* key, const E& x, std::initializer_list<Choice<E>> choices,
                       const char* doc) {
    choice(key, x, choices, doc);
    map_.fields.back().required = true;
    map_.fields.back().initial.clear();
  }
  void words(const char* key, const std::vector<std::string>&,
             std::initializer_list<const char*> valid, const char* doc) {
    Field& field = add_value(key, "list of words", doc, {});
    for (const char* word : valid)
      field.choices.emplace_back(word, "");
  }

  template <class F> void group(const char* key, const char* doc, F describe_fields) {
    Documenter child(add(Field::Kind::group, key, "map", doc));
    describe_fields(child);
  }
  template <class F>
  void optional_group(const char* key, bool, const char* doc, F describe_fields) {
    group(key, doc, describe_fields);
  }
  template <class F> void required_group(const char* key, const char* doc, F describe_fields) {
    group(key, doc, describe_fields);
    map_.fields.back().required = true;
  }
  template <class T>
  void named_map(const char* key, const std::vector<T>&, const char* doc, bool needed = false) {
    Field& field = add(Field::Kind::named_map, key, "map of names", doc);
    field.required = needed;
    Documenter child(field);
    T item;
    describe(child, item);
  }
  void curve_map(const char* key, const std::vector<Curve>&, const char* doc) {
    add(Field::Kind::curve_map, key, "map of names", doc);
  }
  void generator(const char* key, const MeshOptions&, const char* doc) {
    Documenter child(add(Field::Kind::free_map, key, "map", doc));
    child.required("kind", std::string(), "the generator");
  }
  void trilinos_list(const char* key, const std::string&, const char* doc) {
    add(Field::Kind::free_map, key, "map", doc);
  }

  template <class F> void alternative(const char* key, bool, F describe_fields) {
    map_.one_of.push_back(key);
    alternative_ = key;
    describe_fields();
    alternative_.clear();
  }
  template <class F> void when(bool, const char* values, F describe_fields) {
    alternative_ = values;
    describe_fields();
    alternative_.clear();
  }
  void at_least_one(std::initializer_list<const char*> keys) {
    map_.at_least_one.assign(keys.begin(), keys.end());
  }
  void check(const char*, bool, const std::string&) const {}

private:
  static const char* type_of(const double*) { return "number"; }
  static const char* type_of(const int*) { return "whole number"; }
  static const char* type_of(const long long*) { return "whole number"; }
  static const char* type_of(const bool*) { return "true or false"; }
  static const char* type_of(const std::string*) { return "text"; }
  static const char* type_of(const std::array<double, 3>*) { return "3 numbers"; }
  static const char* type_of(const std::vector<std::string>*) { return "list of texts"; }
  static const char* type_of(const std::vector<double>*) { return "list of numbers"; }
  static const char* type_of(const Amount*) { return "number or expression"; }
  static const char* type_of(const std::array<Amount, 3>*) { return "3 numbers or expressions"; }

  Field& add(Field::Kind kind, const char* key, const char* type, const char* doc) {
    const auto same = std::find_if(map_.fields.begin(), map_.fields.end(),
                                   [&](const Field& field) { return field.key == key; });
    Field& field = same == map_.fields.end() ? map_.fields.emplace_back() : *same;
    field.kind = kind;
    field.key = key;
    field.type = type;
    field.doc = doc;
    if (!alternative_.empty())
      field.with.push_back(alternative_);
    return field;
  }
  Field& add_value(const char* key, const char* type, const char* doc, const Rule& rule) {
    Field& field = add(Field::Kind::value, key, type, doc);
    field.range = rule.text();
    field.unit = rule.unit;
    return field;
  }

  Field& map_;
  std::string alternative_;
};

} // namespace abut::deck
