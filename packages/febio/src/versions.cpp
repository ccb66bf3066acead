// SPDX-License-Identifier: BSD-3-Clause
#include "versions.hpp"

#include <algorithm>
#include <cstring>

namespace abut::febio {

namespace {

/// FEBio can take a section from another file, which abut does not read.
void require_whole(const Tree& tree) {
  for (const pugi::xml_node section : child_elements(tree.root())) {
    const bool elsewhere = section.attribute("from") || std::strcmp(section.name(), "Include") == 0;
    if (elsewhere)
      tree.fail(section, "its content is in another file" +
                             (section.attribute("from")
                                  ? " '" + std::string(section.attribute("from").value()) + "'"
                                  : std::string()) +
                             ": put it in here");
  }
}

} // namespace

void to_specification_4(Tree& tree) {
  const pugi::xml_node root = tree.root();
  if (std::strcmp(root.name(), "febio_spec") != 0)
    tree.fail(root, "expected the root element <febio_spec>");
  const std::string version = trimmed(root.attribute("version").value());
  if (version.empty())
    tree.fail(root, "expected an attribute 'version'");
  const std::string versions[] = {"2.0", "2.5", "3.0", "4.0"};
  const auto known = std::find(std::begin(versions), std::end(versions), version);
  if (known == std::end(versions))
    tree.fail(root, "version '" + version + "': expected a file of version 2.0, 2.5, 3.0 or 4.0");
  require_whole(tree);
  if (version == "4.0")
    return;
  tree.begin_translation();
  using Step = void (*)(Tree&);
  constexpr Step steps[] = {from_2_0, from_2_5, from_3_0};
  for (auto i = known - std::begin(versions); i < 3; ++i)
    steps[i](tree);
}

std::vector<pugi::xml_node> phases(const Tree& tree) {
  std::vector<pugi::xml_node> result = {tree.root()};
  for (const pugi::xml_node step : child_elements(tree.root(), "Step")) {
    const auto inner = child_elements(step, "step"); // since 3.0
    if (inner.empty())
      result.push_back(step);
    result.insert(result.end(), inner.begin(), inner.end());
  }
  return result;
}

FreeNames::FreeNames(pugi::xml_node parent, const char* kind) {
  for (const pugi::xml_node node : child_elements(parent, kind))
    taken_.insert(trimmed(node.attribute("name").value()));
}

std::string FreeNames::make(const std::string& base) {
  std::string name = base;
  for (int& k = last_[base]; !taken_.insert(name).second;)
    name = base + "_" + std::to_string(++k + 1);
  return name;
}

bool is_of_shells(const std::string& dof) {
  for (const char* word : {"u", "v", "w", "sx", "sy", "sz"})
    if (dof == word)
      return true;
  return false;
}

std::vector<std::string> dofs_of(const std::string& text) {
  std::vector<std::string> result;
  for (const std::string& word : words_of(text, ", \t\r\n")) {
    const bool letters = word.find_first_not_of("xyzuvw") == std::string::npos;
    const bool of_shells =
        word.size() > 2 && word[0] == 's' && word.find_first_not_of("xyz", 1) == std::string::npos;
    if (letters)
      for (const char c : word)
        result.emplace_back(1, c);
    else if (of_shells)
      for (const char c : word.substr(1))
        result.push_back(std::string("s") + c);
    else
      result.push_back(word);
  }
  return result;
}

void merge_scale_and_value(Tree& tree, pugi::xml_node node) {
  const pugi::xml_node scale = node.child("scale"), value = node.child("value");
  if (!value)
    return;
  if (value.attribute("node_data"))
    return tree.settle(value, Fate::refused,
                       "data of each node: abut has one value for all nodes of a set");
  if (!scale)
    return tree.rename(value, "scale");
  const bool plain = !value.first_attribute();
  const std::string factor = text_of(value);
  if (plain && factor == "1")
    node.remove_child(value);
  else if (plain && text_of(scale) == "1") {
    scale.text().set(factor.c_str());
    node.remove_child(value);
  } else
    tree.settle(value, Fate::refused,
                "both <scale> and <value> are other than 1: give their product as <scale>");
}

} // namespace abut::febio
