// SPDX-License-Identifier: BSD-3-Clause
#include "writer.hpp"

#include "abut/deck/parse.hpp"
#include "describe.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace abut::deck {

namespace {

/// Scalars and lists in YAML's one-line form.
std::string flow(const Value& value) {
  if (value.kind == Value::Kind::scalar)
    return value.quoted ? printed(value.text) : value.text;
  std::string s;
  for (const Value& item : value.items)
    s += (s.empty() ? "[" : ", ") + flow(item);
  return s.empty() ? "[]" : s + "]";
}

} // namespace

std::string printed(const std::string& s) {
  // A JSON string is a double-quoted YAML scalar; a byte that is not UTF-8 becomes a marker.
  return nlohmann::json(s).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void Writer::curve_map(const char* key, const std::vector<Curve>& curves, const char*) {
  if (curves.empty())
    return;
  map(key, [&](Writer& names) {
    for (const Curve& curve : curves)
      names.line(printed(curve.name), printed_list(curve.points));
  });
}

void Writer::generator(const char* key, const MeshOptions& mesh, const char*) {
  map(key, [&](Writer& child) {
    child.line("kind", printed(mesh.kind));
    for (const MeshOptions::Parameter& p : mesh.parameters)
      child.line(printed(p.key), printed(p.text));
  });
}

void Writer::value(const std::string& key, const Value& value) {
  if (value.kind != Value::Kind::map)
    return line(printed(key), flow(value));
  map(printed(key), [&](Writer& child) {
    for (const Value::Entry& entry : value.entries)
      child.value(entry.key, entry.value);
  });
}

void Writer::trilinos_list(const char* key, const std::string& xml, const char*) {
  if (!xml.empty())
    value(key, parse_xml(xml, key));
}

std::string to_yaml(const Deck& deck) {
  std::string out;
  Writer writer(out, 0);
  Deck copy = deck; // the visitors take what Filler may change
  describe(writer, copy);
  return out;
}

std::string model_yaml(const Deck& deck) {
  Deck model;
  static_cast<scene::Options&>(model) = deck;
  model.time = {};
  if (std::any_of(deck.contact.begin(), deck.contact.end(), [](const contact::ContactOptions& c) {
        return c.initial_overlap == contact::InitialOverlap::resolve ||
               (c.interference && c.interference_curve.empty());
      }))
    model.time.end = deck.time.end; // it is pushed out, or has grown, then
  return to_yaml(model);
}

} // namespace abut::deck
