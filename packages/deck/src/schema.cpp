// SPDX-License-Identifier: BSD-3-Clause
#include "abut/deck/schema.hpp"

#include "describe.hpp"
#include "documenter.hpp"

#include <cctype>
#include <nlohmann/json.hpp>

namespace abut::deck {

namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& words) {
  std::string s;
  for (const std::string& word : words)
    s += (s.empty() ? "" : ", ") + word;
  return s;
}

std::string type_text(const Field& field) {
  std::string s = field.type;
  if (!field.range.empty())
    s += " " + field.range;
  if (!field.unit.empty() && field.unit != "1")
    s += " [" + field.unit + "]";
  if (!field.word.empty())
    s += " or " + field.word;
  return s;
}

/// required, default, the alternatives a key belongs to.
std::string status_text(const Field& field) {
  std::string s;
  if (!field.initial.empty())
    s = "default " + field.initial;
  if (field.required)
    s = "required";
  const bool selects = field.with.size() == 1 && field.with[0] == field.key;
  if (!field.with.empty() && !selects)
    s += (s.empty() ? "with " : " with ") + joined(field.with);
  if (selects)
    s = "alternative";
  return s;
}

std::string notes(const Field& map) {
  std::string s;
  if (!map.one_of.empty())
    s += "Exactly one of: " + joined(map.one_of) + ".";
  if (!map.at_least_one.empty())
    s += (s.empty() ? "" : " ") + ("At least one of: " + joined(map.at_least_one) + ".");
  return s;
}

std::string sentence(std::string s, const std::string& status) {
  s[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s[0])));
  return s + (status.empty() ? "." : " (" + status + ").");
}

bool has_doc(const Field& field) {
  for (const auto& [word, doc] : field.choices)
    if (!doc.empty())
      return true;
  return false;
}

std::string words(const Field& field) {
  std::vector<std::string> list;
  for (const auto& choice : field.choices)
    list.push_back(choice.first);
  return joined(list);
}

void write_text(const Field& map, std::size_t depth, std::string& out) {
  const std::string indent(2 * depth, ' ');
  for (const Field& field : map.fields) {
    std::string head = indent + field.key + ":";
    if (head.size() < 28)
      head.resize(28, ' ');
    const std::string status = status_text(field);
    out += head + " " + type_text(field) + (status.empty() ? "" : "; " + status) + "\n";
    const std::string inner = indent + "    # ";
    out += inner + field.doc + "\n";
    if (!field.choices.empty() && !has_doc(field))
      out += inner + "one of: " + words(field) + "\n";
    if (has_doc(field))
      for (const auto& [word, doc] : field.choices)
        out += inner + "- " + word + (doc.empty() ? "" : ": " + doc) + "\n";
    if (!notes(field).empty())
      out += inner + notes(field) + "\n";
    if (field.kind == Field::Kind::curve_map)
      out += indent + "  NAME: [[t, value], ...]\n";
    if (field.kind == Field::Kind::free_map)
      out += indent + "  ...: free keys\n";
    if (field.kind == Field::Kind::named_map)
      out += indent + "  NAME:\n";
    write_text(field, depth + (field.kind == Field::Kind::named_map ? 2 : 1), out);
  }
}

std::string cell(std::string s) {
  for (std::size_t at = 0; (at = s.find('|', at)) != std::string::npos; at += 2)
    s.insert(at, "\\");
  return s;
}

void write_markdown(const Field& map, const std::string& path, std::string& out) {
  bool values = false;
  for (const Field& field : map.fields)
    values = values || field.kind == Field::Kind::value;
  if (!notes(map).empty())
    out += notes(map) + "\n\n";
  if (values)
    out += "| key | value | | meaning |\n|---|---|---|---|\n";
  for (const Field& field : map.fields) {
    if (field.kind != Field::Kind::value)
      continue;
    std::string meaning = field.doc;
    if (has_doc(field)) {
      for (const auto& [word, doc] : field.choices)
        meaning += "<br>`" + word + "`" + (doc.empty() ? "" : ": " + doc);
    } else if (!field.choices.empty()) {
      meaning += "; one of " + words(field);
    }
    out += "| `" + field.key + "` | " + cell(type_text(field)) + " | " + cell(status_text(field)) +
           " | " + cell(meaning) + " |\n";
  }
  if (values)
    out += "\n";
  for (const Field& field : map.fields) {
    if (field.kind == Field::Kind::value)
      continue;
    std::string name = path.empty() ? field.key : path + "." + field.key;
    if (field.kind == Field::Kind::named_map)
      name += ".NAME";
    out += "## " + name + "\n\n" + sentence(field.doc, status_text(field)) + "\n\n";
    if (field.kind == Field::Kind::curve_map)
      out += "`NAME: [[t, value], [t, value], ...]`, two points or more, t growing.\n\n";
    write_markdown(field, name, out);
  }
}

Json json_map(const Field& map);

/// "> -1 and < 0.5" is kept in words too; JSON needs the two ends.
void json_range(const std::string& range, Json& type) {
  std::size_t at = 0;
  while ((at = range.find_first_of("<>", at)) != std::string::npos) {
    const bool low = range[at] == '>';
    const bool closed = at + 1 < range.size() && range[at + 1] == '=';
    const std::size_t first = range.find(' ', at) + 1;
    double limit = 0.0;
    parse_number(range.substr(first, range.find(' ', first) - first), limit);
    type[std::string(closed ? "" : "exclusive") +
         (low ? (closed ? "minimum" : "Minimum") : (closed ? "maximum" : "Maximum"))] = limit;
    at = first;
  }
}

Json json_scalar(const std::string& type) {
  if (type == "number")
    return {{"type", "number"}};
  if (type == "whole number")
    return {{"type", "integer"}};
  if (type == "true or false")
    return {{"type", "boolean"}};
  if (type == "text" || type == "word")
    return {{"type", {"string", "number"}}};
  if (type == "number or expression")
    return {{"type", {"number", "string"}}};
  if (type == "3 numbers" || type == "3 numbers or expressions") {
    const Json item =
        type == "3 numbers" ? json_scalar("number") : json_scalar("number or expression");
    return {{"type", "array"}, {"items", item}, {"minItems", 3}, {"maxItems", 3}};
  }
  if (type == "list of numbers")
    return {{"type", "array"}, {"items", json_scalar("number")}, {"minItems", 1}};
  return {{"type", "array"}, {"items", {{"type", {"string", "number"}}}}, {"minItems", 1}};
}

Json json_field(const Field& field) {
  Json json;
  switch (field.kind) {
  case Field::Kind::value:
    json = json_scalar(field.type);
    json_range(field.range, json);
    if (!field.word.empty())
      json = {{"anyOf", Json::array({json, {{"const", field.word}}})}};
    break;
  case Field::Kind::group:
    json = json_map(field);
    json["type"] = {"object", "null"};
    break;
  case Field::Kind::named_map:
    json = {{"type", {"object", "null"}}, {"additionalProperties", json_map(field)}};
    break;
  case Field::Kind::curve_map: {
    const Json number = {{"type", "number"}};
    const Json point = {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
    const Json curve = {{"type", "array"}, {"items", point}, {"minItems", 2}};
    json = {{"type", {"object", "null"}}, {"additionalProperties", curve}};
    break;
  }
  case Field::Kind::free_map:
    json = json_map(field);
    json["additionalProperties"] = true;
    break;
  }
  if (!field.choices.empty()) {
    Json words = Json::array();
    for (const auto& choice : field.choices)
      words.push_back(choice.first);
    if (field.type == "word")
      json = Json::object();
    (field.type == "word" ? json : json["items"])["enum"] = words;
  }
  if (!field.initial.empty())
    json["default"] = field.type == "word" || field.initial == field.word
                          ? Json(field.initial)
                          : Json::parse(field.initial);
  const bool has_unit = !field.unit.empty() && field.unit != "1";
  json["description"] = field.doc + (has_unit ? " [" + field.unit + "]" : "");
  return json;
}

Json json_map(const Field& map) {
  Json json = {{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array();
  for (const Field& field : map.fields) {
    json["properties"][field.key] = json_field(field);
    if (field.required && field.with.empty())
      required.push_back(field.key);
  }
  if (!required.empty())
    json["required"] = required;
  for (const std::string& alternative : map.one_of) {
    Json keys = Json::array({alternative});
    for (const Field& field : map.fields)
      for (const std::string& with : field.with)
        if (with == alternative && field.required && field.key != alternative)
          keys.push_back(field.key);
    json["oneOf"].push_back({{"required", keys}});
  }
  for (const std::string& key : map.at_least_one)
    json["anyOf"].push_back({{"required", Json::array({key})}});
  return json;
}

} // namespace

Field schema() {
  Field top;
  Documenter documenter(top);
  Deck deck;
  describe(documenter, deck);
  top.kind = Field::Kind::group;
  return top;
}

std::string schema_text() {
  std::string out = "# Keys of an abut deck: type [unit]; required or default; meaning.\n"
                    "# NAME stands for a name of your choice. Any consistent units will do.\n"
                    "# An expression is a formula in quotes in x, y, z (reference position), t "
                    "(load parameter), pi.\n";
  write_text(schema(), 0, out);
  return out;
}

std::string schema_markdown() {
  std::string out =
      "# Deck reference\n\n"
      "Written by `abut schema --markdown` from the declaration that also checks "
      "decks.\nNAME stands for a name of your choice; any consistent units will do. "
      "The same keys hold in YAML and in\nXML (Teuchos `ParameterList`: maps are "
      "sublists, lists are `Array(...)`, lists of lists `TwoDArray(...)`).\n\n"
      "An expression is a formula in quotes, `\"0.01*sin(pi*x)*t\"`, in x, y, z (reference "
      "position),\nt (load parameter), pi and functions (sin, exp, sqrt, abs, max, "
      "...; `a < b ? c : d` chooses). A curve\nmultiplies a number always, an "
      "expression only where one is given.\n\n";
  write_markdown(schema(), "", out);
  while (out.size() > 1 && out[out.size() - 2] == '\n')
    out.pop_back();
  return out;
}

std::string schema_json() {
  const Field top = schema();
  Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "abut deck"}};
  json.update(json_map(top));
  return json.dump(2) + "\n";
}

} // namespace abut::deck
