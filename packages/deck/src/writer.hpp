// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/deck.hpp"
#include "print.hpp"
#include "rule.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace abut::deck {

/// The visitor that prints options as YAML, one key a line. What is empty is left out.
class Writer {
public:
  Writer(std::string& out, int depth)
      : out_(out), indent_(static_cast<std::size_t>(2 * depth), ' ') {}

  template <class T> void required(const char* key, const T& x, const char*, const Rule& = {}) {
    line(key, printed(x));
  }
  template <class T> void optional(const char* key, const T& x, const char*, const Rule& = {}) {
    line(key, printed(x));
  }
  void optional(const char* key, const std::string& s, const char*) {
    if (!s.empty())
      line(key, printed(s));
  }
  void optional(const char* key, const std::vector<std::string>& list, const char*) {
    if (!list.empty())
      line(key, printed(list));
  }
  template <class T>
  void optional(const char* key, const std::optional<T>& x, const char*, const Rule& = {}) {
    if (x)
      line(key, printed(*x));
  }
  template <class T>
  void number_or(const char* key, const std::optional<T>& x, const char* word, const char*,
                 const Rule&) {
    line(key, x ? printed(*x) : word);
  }

  template <class E>
  void choice(const char* key, const E& x, std::initializer_list<Choice<E>> choices, const char*) {
    for (const Choice<E>& c : choices)
      if (c.value == x)
        line(key, c.word);
  }
  template <class E>
  void required_choice(const char* key, const E& x, std::initializer_list<Choice<E>> choices,
                       const char* doc) {
    choice(key, x, choices, doc);
  }
  void words(const char* key, const std::vector<std::string>& chosen,
             std::initializer_list<const char*>, const char*) {
    if (!chosen.empty())
      line(key, printed(chosen));
  }

  template <class F> void group(const char* key, const char*, F describe_fields) {
    map(key, [&](Writer& child) { describe_fields(child); });
  }
  template <class F>
  void optional_group(const char* key, bool present, const char* doc, F describe_fields) {
    if (present)
      group(key, doc, describe_fields);
  }
  template <class F> void required_group(const char* key, const char* doc, F describe_fields) {
    group(key, doc, describe_fields);
  }
  template <class T>
  void named_map(const char* key, std::vector<T>& list, const char*, bool = false) {
    if (list.empty())
      return;
    map(key, [&](Writer& names) {
      for (T& item : list)
        names.map(printed(item.name), [&](Writer& child) { describe(child, item); });
    });
  }
  void curve_map(const char* key, const std::vector<Curve>& curves, const char*);
  void generator(const char* key, const MeshOptions& mesh, const char*);
  void trilinos_list(const char* key, const std::string& xml, const char*);

  template <class F> void alternative(const char*, bool selected, F describe_fields) {
    if (selected)
      describe_fields();
  }
  template <class F> void when(bool holds, const char*, F describe_fields) {
    if (holds)
      describe_fields();
  }
  void at_least_one(std::initializer_list<const char*>) {}
  void check(const char*, bool, const std::string&) const {}

private:
  void line(const std::string& key, const std::string& value) {
    out_ += indent_ + key + ": " + value + "\n";
  }
  template <class F> void map(const std::string& key, F fill) {
    std::string inner;
    Writer child(inner, static_cast<int>(indent_.size()) / 2 + 1);
    fill(child);
    out_ += indent_ + key + (inner.empty() ? ": {}\n" : ":\n" + inner);
  }
  void value(const std::string& key, const Value& value);

  std::string& out_;
  std::string indent_;
};

} // namespace abut::deck
