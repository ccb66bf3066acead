// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"
#include "rule.hpp"

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut::deck {

/// The visitor that fills options from one map of the deck and checks what it finds. What is
/// missing or unknown is told by finish(), so that a misspelt required key is called unknown, not
/// missing.
class Filler {
public:
  Filler(const Value& map, const Location& where, const std::string& path,
         std::map<std::string, Location>& locations);

  template <class T> void required(const char* key, T& x, const char* doc, const Rule& rule = {}) {
    const Value* value = take(key);
    if (!value)
      return missing(key, doc);
    read(*value, path_of(key), x, rule);
    if constexpr (std::is_same_v<T, std::string>)
      check(key, !x.empty(), "expected a text, got an empty one");
  }

  template <class T> void optional(const char* key, T& x, const char*, const Rule& rule = {}) {
    if (const Value* value = take(key))
      read(*value, path_of(key), x, rule);
  }
  template <class T>
  void optional(const char* key, std::optional<T>& x, const char*, const Rule& rule = {}) {
    if (const Value* value = take(key))
      read(*value, path_of(key), x.emplace(), rule);
  }

  /// A number, or `word` for none. The number 0, where it is out of range, is told of the word.
  template <class T>
  void number_or(const char* key, std::optional<T>& x, const char* word, const char*,
                 const Rule& rule) {
    const Value* value = take(key);
    if (!value)
      return;
    x.reset();
    if (!is_word(*value, word)) {
      refuse_zero(*value, path_of(key), key, word, rule);
      Rule or_word = rule;
      or_word.word = word;
      read(*value, path_of(key), x.emplace(), or_word);
    }
  }

  template <class E>
  void choice(const char* key, E& x, std::initializer_list<Choice<E>> choices, const char*) {
    const Value* value = take(key);
    if (!value)
      return;
    std::vector<std::string> words;
    for (const Choice<E>& c : choices)
      words.push_back(c.word);
    x = (choices.begin() + word_index(*value, path_of(key), words))->value;
  }
  template <class E>
  void required_choice(const char* key, E& x, std::initializer_list<Choice<E>> choices,
                       const char* doc) {
    if (!map_.find(key))
      missing(key, doc);
    choice(key, x, choices, doc);
  }

  void words(const char* key, std::vector<std::string>& chosen,
             std::initializer_list<const char*> valid, const char*);

  template <class F> void group(const char* key, const char*, F describe_fields) {
    const Value* value = take(key);
    if (!value)
      return;
    Filler child(as_map(*value, path_of(key), "a map"), place(key), path_of(key), locations_);
    describe_fields(child);
    child.finish();
  }

  /// A group whose presence means something by itself.
  template <class F>
  void optional_group(const char* key, bool& present, const char* doc, F describe_fields) {
    present = map_.find(key) != nullptr;
    group(key, doc, describe_fields);
  }

  template <class F> void required_group(const char* key, const char* doc, F describe_fields) {
    if (!map_.find(key))
      missing(key, doc);
    group(key, doc, describe_fields);
  }

  template <class T>
  void named_map(const char* key, std::vector<T>& list, const char* doc, bool needed = false) {
    const Value* value = take(key);
    if (!value && needed)
      missing(key, doc);
    if (!value)
      return;
    const std::string path = path_of(key);
    for (const Value::Entry& entry : as_map(*value, path, "a map of names").entries) {
      T& item = list.emplace_back();
      item.name = named(entry, path);
      const std::string item_path = path + "." + entry.key;
      Filler child(as_map(entry.value, item_path, "a map"), entry.where, item_path, locations_);
      describe(child, item);
      child.finish();
    }
    if (needed && list.empty())
      fail(place(key), path, "expected at least one, got nothing");
  }

  void curve_map(const char* key, std::vector<Curve>& curves, const char*);
  void generator(const char* key, MeshOptions& mesh, const char*);
  void trilinos_list(const char* key, std::string& xml, const char*);

  /// Fields of which exactly one set is given, chosen by the presence of `key`.
  template <class F> void alternative(const char* key, bool, F describe_fields) {
    one_of_.push_back(key);
    if (!map_.find(key))
      return;
    chosen_.push_back(key);
    describe_fields();
  }
  /// Fields that exist only when `holds`; `values` says when in words.
  template <class F> void when(bool holds, const char*, F describe_fields) {
    if (holds)
      describe_fields();
  }
  void at_least_one(std::initializer_list<const char*> keys);

  /// A condition beyond type and range.
  void check(const char* key, bool holds, const std::string& message) const {
    if (!holds)
      fail(place(key), path_of(key), message);
  }

  /// Reports the first key that is unknown, missing or contradicts another.
  void finish() const;

private:
  [[noreturn]] static void fail(const Location& where, const std::string& path,
                                const std::string& message);
  const Value* take(const char* key);
  void missing(const char* key, const char* doc);
  Location place(const char* key) const;
  std::string path_of(const std::string& key) const;
  std::string named(const Value::Entry& entry, const std::string& path);
  const Value& as_map(const Value& value, const std::string& path, const char* expected) const;
  static bool is_word(const Value& value, const char* word) {
    return value.kind == Value::Kind::scalar && value.text == word;
  }
  static void refuse_zero(const Value& value, const std::string& path, const std::string& key,
                          const std::string& word, const Rule& rule);
  std::size_t word_index(const Value& value, const std::string& path,
                         const std::vector<std::string>& words) const;

  void read(const Value&, const std::string& path, double&, const Rule&) const;
  void read(const Value&, const std::string& path, long long&, const Rule&) const;
  void read(const Value&, const std::string& path, int&, const Rule&) const;
  void read(const Value&, const std::string& path, bool&, const Rule&) const;
  void read(const Value&, const std::string& path, std::string&, const Rule&) const;
  void read(const Value&, const std::string& path, std::array<double, 3>&, const Rule&) const;
  void read(const Value&, const std::string& path, std::vector<std::string>&, const Rule&) const;
  void read(const Value&, const std::string& path, std::vector<double>&, const Rule&) const;
  void read(const Value&, const std::string& path, Amount&, const Rule&) const;
  void read(const Value&, const std::string& path, std::array<Amount, 3>&, const Rule&) const;

  const Value& map_;
  Location where_;
  std::string path_;
  std::map<std::string, Location>& locations_;
  std::vector<std::string> known_;
  std::vector<std::string> missing_; ///< messages
  std::vector<std::string> one_of_, chosen_;
};

} // namespace abut::deck
