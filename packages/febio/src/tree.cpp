// SPDX-License-Identifier: BSD-3-Clause
#include "tree.hpp"

#include "abut/core/error.hpp"
#include "abut/translation/utf8.hpp"

#include <algorithm>
#include <cstring>

namespace abut::febio {

Tree::Tree(const std::string& text, std::string file) : file_(std::move(file)) {
  const std::string utf8 = translation::utf8(text);
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < utf8.size(); ++i)
    if (utf8[i] == '\n')
      line_starts_.push_back(i + 1);
  const pugi::xml_parse_result result =
      xml_.load_buffer(utf8.data(), utf8.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(),
                                        static_cast<std::size_t>(result.offset));
    throw InputError(file_ + ":" + std::to_string(after - line_starts_.begin()) +
                     ": not a complete XML file: " + result.description());
  }
}

std::ptrdiff_t Tree::offset(pugi::xml_node node) const {
  const auto known = origins_.find(node.hash_value());
  return known == origins_.end() ? node.offset_debug() : known->second.offset;
}

int Tree::line(pugi::xml_node node) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(),
                                      static_cast<std::size_t>(offset(node)));
  return static_cast<int>(after - line_starts_.begin());
}

std::string Tree::name_in_file(pugi::xml_node node) const {
  const auto known = origins_.find(node.hash_value());
  return known == origins_.end() ? node.name() : known->second.name;
}

void Tree::fail(pugi::xml_node node, const std::string& message) const {
  throw InputError(file_ + ":" + std::to_string(line(node)) + ": <" + name_in_file(node) +
                   ">: " + message);
}

void Tree::rename(pugi::xml_node node, const char* name) {
  if (std::strcmp(node.name(), name) == 0)
    return;
  origins_.emplace(node.hash_value(), Origin{offset(node), name_in_file(node)});
  node.set_name(name);
}

pugi::xml_node Tree::append(pugi::xml_node parent, const char* name, pugi::xml_node from) {
  const pugi::xml_node node = parent.append_child(name);
  origins_[node.hash_value()] = {offset(from), name};
  return node;
}

pugi::xml_node Tree::insert_before(pugi::xml_node place, const char* name) {
  const pugi::xml_node node = place.parent().insert_child_before(name, place);
  stand_for(node, place);
  return node;
}

void Tree::stand_for(pugi::xml_node node, pugi::xml_node from) {
  origins_[node.hash_value()] = {offset(from), name_in_file(from)};
}

void Tree::append_text(pugi::xml_node parent, const char* name, const std::string& text,
                       pugi::xml_node from) {
  append(parent, name, from).text().set(text.c_str());
}

pugi::xml_node Tree::child(pugi::xml_node parent, const char* name, pugi::xml_node from) {
  const pugi::xml_node found = parent.child(name);
  return found ? found : append(parent, name, from);
}

void Tree::settle(pugi::xml_node node, Fate fate, const std::string& why) {
  verdicts_[node.hash_value()] = {fate, why};
}

std::vector<pugi::xml_node> child_elements(pugi::xml_node parent, const char* name) {
  std::vector<pugi::xml_node> result;
  for (const pugi::xml_node node : parent.children())
    if (node.type() == pugi::node_element && (!name || std::strcmp(node.name(), name) == 0))
      result.push_back(node);
  return result;
}

std::optional<std::string> take_attribute(pugi::xml_node node, const char* name) {
  const pugi::xml_attribute a = node.attribute(name);
  if (!a)
    return {};
  std::string value = trimmed(a.value());
  node.remove_attribute(a);
  return value;
}

std::string text_of(pugi::xml_node node) {
  std::string s;
  for (const pugi::xml_node child : node.children())
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
      s += child.value();
  return trimmed(s);
}

std::string trimmed(const std::string& s) {
  const char* const white = " \t\r\n";
  const std::size_t first = s.find_first_not_of(white);
  if (first == std::string::npos)
    return "";
  return s.substr(first, s.find_last_not_of(white) - first + 1);
}

std::vector<std::string> words_of(const std::string& text, const char* separators) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::string word = trimmed(text.substr(at, end - at));
    if (!word.empty())
      words.push_back(word);
    at = end + 1;
  }
  return words;
}

} // namespace abut::febio
