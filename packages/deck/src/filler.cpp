// SPDX-License-Identifier: BSD-3-Clause
#include "filler.hpp"

#include "abut/deck/parse.hpp"
#include "expression.hpp"

#include <algorithm>
#include <limits>

namespace abut::deck {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string s;
  for (const std::string& word : words)
    s += (s.empty() ? "" : separator) + word;
  return s;
}

std::string expected_number(const char* noun, const Rule& rule, const Value& got) {
  std::string s = std::string("expected ") + noun;
  if (!rule.text().empty())
    s += " " + rule.text();
  if (*rule.word)
    s += std::string(" or '") + rule.word + "'";
  s += ", got " + got.description();
  if (*rule.reason)
    s += std::string(" (") + rule.reason + ")";
  return s;
}

} // namespace

Filler::Filler(const Value& map, const Location& where, const std::string& path,
               std::map<std::string, Location>& locations)
    : map_(map), where_(where), path_(path), locations_(locations) {
  for (const Value::Entry& entry : map.entries)
    locations_[path_of(entry.key)] = entry.where;
}

void Filler::fail(const Location& where, const std::string& path, const std::string& message) {
  throw InputError(where.text() + ": " + (path.empty() ? "" : path + ": ") + message);
}

const Value* Filler::take(const char* key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end())
    known_.push_back(key);
  const Value::Entry* entry = map_.find(key);
  return entry ? &entry->value : nullptr;
}

void Filler::missing(const char* key, const char* doc) {
  missing_.push_back(std::string("missing key '") + key + "' (" + doc + ")");
}

Location Filler::place(const char* key) const {
  const Value::Entry* entry = map_.find(key);
  return entry ? entry->where : where_;
}

std::string Filler::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

std::string Filler::named(const Value::Entry& entry, const std::string& path) {
  if (entry.key.empty())
    fail(entry.where, path, "a name must not be empty");
  locations_[path + "." + entry.key] = entry.where;
  return entry.key;
}

const Value& Filler::as_map(const Value& value, const std::string& path,
                            const char* expected) const {
  // A key with nothing after it is a map whose entries are all left out.
  if (value.kind != Value::Kind::map && value.kind != Value::Kind::nothing)
    fail(value.where, path, std::string("expected ") + expected + ", got " + value.description());
  return value;
}

std::size_t Filler::word_index(const Value& value, const std::string& path,
                               const std::vector<std::string>& words) const {
  if (value.kind != Value::Kind::scalar)
    fail(value.where, path,
         "expected one word, got " + value.description() + "; valid: " + joined(words, ", "));
  const auto found = std::find(words.begin(), words.end(), value.text);
  if (found == words.end())
    fail(value.where, path,
         "unknown value " + value.description() + "; " +
             nearest_word_hint(value.text, words.data(), words.size()));
  return static_cast<std::size_t>(found - words.begin());
}

void Filler::words(const char* key, std::vector<std::string>& chosen,
                   std::initializer_list<const char*> valid, const char*) {
  const Value* value = take(key);
  if (!value)
    return;
  const std::vector<std::string> all(valid.begin(), valid.end());
  if (value->kind != Value::Kind::list || value->items.empty())
    fail(value->where, path_of(key),
         "expected a list of " + joined(all, ", ") + ", got " + value->description());
  for (const Value& item : value->items)
    chosen.push_back(all[word_index(item, path_of(key), all)]);
}

void Filler::curve_map(const char* key, std::vector<Curve>& curves, const char*) {
  const Value* value = take(key);
  if (!value)
    return;
  const std::string path = path_of(key);
  for (const Value::Entry& entry : as_map(*value, path, "a map of names").entries) {
    Curve& curve = curves.emplace_back();
    curve.name = named(entry, path);
    const std::string curve_path = path + "." + curve.name;
    if (entry.value.kind != Value::Kind::list || entry.value.items.size() < 2)
      fail(entry.value.where, curve_path,
           "expected a list of two or more points [t, value], got " + entry.value.description());
    for (const Value& item : entry.value.items) {
      if (item.kind != Value::Kind::list || item.items.size() != 2)
        fail(item.where, curve_path, "expected a point [t, value], got " + item.description());
      std::array<double, 2> point{};
      for (std::size_t i = 0; i < 2; ++i)
        read(item.items[i], curve_path, point[i], Rule{});
      if (!curve.points.empty() && point[0] <= curve.points.back()[0])
        fail(item.where, curve_path,
             "t must grow from point to point, got " + number_text(point[0]) + " after " +
                 number_text(curve.points.back()[0]));
      curve.points.push_back(point);
    }
  }
}

void Filler::generator(const char* key, MeshOptions& mesh, const char*) {
  const Value* value = take(key);
  if (!value)
    return;
  const std::string path = path_of(key);
  const Value& map = as_map(*value, path, "a map");
  for (const Value::Entry& entry : map.entries) {
    const std::string entry_path = path + "." + entry.key;
    locations_[entry_path] = entry.where;
    const bool list = entry.value.kind == Value::Kind::list;
    std::vector<std::string> parts;
    for (const Value& item : list ? entry.value.items : std::vector<Value>{entry.value}) {
      if (item.kind != Value::Kind::scalar)
        fail(item.where, entry_path,
             "expected a number, a text or a list of them, got " + item.description());
      parts.push_back(item.text);
    }
    if (entry.key == "kind")
      mesh.kind = joined(parts, ",");
    else
      mesh.parameters.push_back({entry.key, joined(parts, ","), entry.where});
  }
  if (mesh.kind.empty())
    fail(place(key), path, "missing key 'kind' (the generator)");
}

void Filler::trilinos_list(const char* key, std::string& xml, const char*) {
  const Value* value = take(key);
  if (value)
    xml = to_parameter_list_xml(as_map(*value, path_of(key), "a map"), key);
}

void Filler::at_least_one(std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (map_.find(key))
      return;
  missing_.push_back("expected at least one of the keys " +
                     joined({keys.begin(), keys.end()}, ", "));
}

void Filler::refuse_zero(const Value& value, const std::string& path, const std::string& key,
                         const std::string& word, const Rule& rule) {
  double number = 0.0;
  if (value.kind == Value::Kind::scalar && !value.quoted && parse_number(value.text, number) &&
      number == 0.0 && !rule.accepts(0.0))
    fail(value.where, path,
         "0 no longer means " + word + ": write '" + key + ": " + word + "' or leave the key out");
}

void Filler::finish() const {
  std::vector<std::string> valid = known_;
  for (const std::string& key : one_of_)
    if (std::find(valid.begin(), valid.end(), key) == valid.end() && chosen_.empty())
      valid.push_back(key);
  for (const Value::Entry& entry : map_.entries)
    if (std::find(valid.begin(), valid.end(), entry.key) == valid.end())
      fail(entry.where, path_of(entry.key),
           "unknown key; " + nearest_word_hint(entry.key, valid.data(), valid.size()));
  if (chosen_.size() > 1)
    fail(place(chosen_[1].c_str()), path_of(chosen_[1]),
         "only one of the keys " + joined(one_of_, ", ") + " is allowed, '" + chosen_[0] +
             "' is given too");
  if (!one_of_.empty() && chosen_.empty())
    fail(where_, path_, "expected one of the keys " + joined(one_of_, ", "));
  if (!missing_.empty())
    fail(where_, path_, missing_[0]);
}

void Filler::read(const Value& value, const std::string& path, double& x, const Rule& rule) const {
  if (value.kind != Value::Kind::scalar || value.quoted || !parse_number(value.text, x) ||
      !rule.accepts(x))
    fail(value.where, path, expected_number("a number", rule, value));
}

void Filler::read(const Value& value, const std::string& path, long long& n,
                  const Rule& rule) const {
  if (value.kind != Value::Kind::scalar || value.quoted || !parse_number(value.text, n) ||
      !rule.accepts(static_cast<double>(n)))
    fail(value.where, path, expected_number("a whole number", rule, value));
}

void Filler::read(const Value& value, const std::string& path, int& n, const Rule& rule) const {
  long long wide = 0;
  read(value, path, wide, rule);
  n = static_cast<int>(wide);
  if (n != wide)
    fail(value.where, path,
         "expected a whole number up to " + std::to_string(std::numeric_limits<int>::max()) +
             ", got " + value.description());
}

void Filler::read(const Value& value, const std::string& path, bool& x, const Rule&) const {
  const bool word = value.kind == Value::Kind::scalar && !value.quoted;
  const auto is = [&](std::initializer_list<const char*> words) {
    return word && std::find(words.begin(), words.end(), value.text) != words.end();
  };
  x = is({"true", "yes", "on"});
  if (!x && !is({"false", "no", "off"}))
    fail(value.where, path, "expected true or false, got " + value.description());
}

void Filler::read(const Value& value, const std::string& path, std::string& s, const Rule&) const {
  if (value.kind != Value::Kind::scalar)
    fail(value.where, path, "expected a text, got " + value.description());
  s = value.text;
}

void Filler::read(const Value& value, const std::string& path, std::array<double, 3>& x,
                  const Rule& rule) const {
  if (value.kind != Value::Kind::list || value.items.size() != 3)
    fail(value.where, path, "expected a list of 3 numbers, got " + value.description());
  for (std::size_t i = 0; i < 3; ++i)
    read(value.items[i], path, x[i], rule);
}

void Filler::read(const Value& value, const std::string& path, std::vector<std::string>& list,
                  const Rule& rule) const {
  if (value.kind != Value::Kind::list || value.items.empty())
    fail(value.where, path, "expected a list of one or more texts, got " + value.description());
  for (const Value& item : value.items)
    read(item, path, list.emplace_back(), rule);
}

void Filler::read(const Value& value, const std::string& path, std::vector<double>& list,
                  const Rule& rule) const {
  if (value.kind != Value::Kind::list || value.items.empty())
    fail(value.where, path, "expected a list of one or more numbers, got " + value.description());
  for (const Value& item : value.items)
    read(item, path, list.emplace_back(), rule);
}

void Filler::read(const Value& value, const std::string& path, Amount& amount,
                  const Rule& rule) const {
  double number = 0.0;
  if (value.kind != Value::Kind::scalar || parse_number(value.text, number)) {
    // A number in quotes is refused: should its curve multiply it or not?
    read(value, path, amount.number, rule);
    return;
  }
  amount = {value.text, compile_expression(value.text, value.where.text() + ": " + path)};
}

void Filler::read(const Value& value, const std::string& path, std::array<Amount, 3>& x,
                  const Rule& rule) const {
  if (value.kind != Value::Kind::list || value.items.size() != 3)
    fail(value.where, path,
         "expected a list of 3 numbers or expressions, got " + value.description());
  for (std::size_t i = 0; i < 3; ++i)
    read(value.items[i], path, x[i], rule);
}

} // namespace abut::deck
