// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/parse.hpp"

#include <algorithm>
#include <sstream>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace abut::deck {

namespace {

// Aliases can refer to their own parent or double at every level; a deck needs neither.
constexpr int deepest = 50;
constexpr int most_values = 1000000;

/// Where the documents of a text begin. yaml-cpp's own LoadAll never ends at a bracket too many.
class Documents : public YAML::EventHandler {
public:
  explicit Documents(const std::string& text) {
    std::istringstream in(text);
    YAML::Parser parser(in);
    while (starts.size() < 2 && parser.HandleNextDocument(*this))
      continue;
  }

  std::vector<YAML::Mark> starts; ///< of the first two

private:
  using Style = YAML::EmitterStyle::value;
  void OnDocumentStart(const YAML::Mark& mark) override { starts.push_back(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, Style) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, Style) override {}
  void OnMapEnd() override {}
};

class YamlReader {
public:
  explicit YamlReader(const std::string& file) : file_(file) {}

  Value read(const YAML::Node& node, const Location& parent, int depth) {
    // The mark of nothing is that of whatever comes next.
    const bool nothing = !node.IsDefined() || node.IsNull();
    const Location where = nothing ? parent : location(node.Mark(), parent);
    if (depth > deepest)
      fail(where, "nested too deeply");
    if (++count_ > most_values)
      fail(where, "too many values");
    Value value;
    value.where = where;
    switch (node.Type()) {
    case YAML::NodeType::Undefined:
    case YAML::NodeType::Null:
      break;
    case YAML::NodeType::Scalar:
      value.kind = Value::Kind::scalar;
      value.text = node.Scalar();
      value.quoted = node.Tag() == "!";
      break;
    case YAML::NodeType::Sequence:
      value.kind = Value::Kind::list;
      for (const auto& item : node)
        value.items.push_back(read(item, where, depth + 1));
      break;
    case YAML::NodeType::Map:
      read_map(node, value, depth);
      break;
    }
    return value;
  }

  [[noreturn]] static void fail(const Location& where, const std::string& message) {
    throw InputError(where.text() + ": " + message);
  }

private:
  Location location(const YAML::Mark& mark, const Location& parent) const {
    return mark.is_null() ? parent : Location{file_, mark.line + 1, mark.column + 1};
  }

  void read_map(const YAML::Node& node, Value& map, int depth) {
    map.kind = Value::Kind::map;
    std::vector<Value> merged;
    for (const auto& pair : node) {
      const Location where = location(pair.first.Mark(), map.where);
      if (!pair.first.IsScalar())
        fail(where, "a key must be a word, not a list, a map or nothing");
      const std::string key = pair.first.Scalar();
      Value value = read(pair.second, where, depth + 1);
      if (key == "<<") {
        merged.push_back(std::move(value));
        continue;
      }
      if (const Value::Entry* first = map.find(key))
        fail(where, "key '" + key + "' is given twice, first in line " +
                        std::to_string(first->where.line));
      map.entries.push_back({key, where, std::move(value)});
    }
    for (const Value& value : merged)
      merge(value, map);
  }

  /// Adds the entries of `value`, a map or a list of maps, that the map does not have itself.
  void merge(const Value& value, Value& map) {
    if (value.kind == Value::Kind::list) {
      for (const Value& item : value.items)
        merge(item, map);
      return;
    }
    if (value.kind != Value::Kind::map)
      fail(value.where, "'<<' expects a map, got " + value.description());
    for (const Value::Entry& entry : value.entries)
      if (!map.find(entry.key))
        map.entries.push_back(entry);
  }

  std::string file_;
  int count_ = 0;
};

} // namespace

Value parse_yaml(const std::string& text, const std::string& file) {
  try {
    const Documents documents(text);
    const Location start{file, 1, 1};
    if (documents.starts.empty())
      YamlReader::fail(start, "the deck is empty");
    if (documents.starts.size() > 1) {
      const YAML::Mark& second = documents.starts[1];
      YamlReader::fail({file, second.line + 1, second.column + 1},
                       "a second YAML document begins here ('---', or a bracket too many before "
                       "it), expected one");
    }
    Value top = YamlReader(file).read(YAML::Load(text), start, 0);
    if (top.kind == Value::Kind::nothing)
      YamlReader::fail(start, "the deck is empty");
    if (top.kind != Value::Kind::map)
      YamlReader::fail(top.where,
                       "the top level must be a map (key: value), got " + top.description());
    return top;
  } catch (const YAML::Exception& e) {
    const int line = e.mark.is_null() ? 1 : e.mark.line + 1;
    throw InputError(Location{file, line, 1}.text() + ": not valid YAML: " + e.msg);
  }
}

} // namespace abut::deck
