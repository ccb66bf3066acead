// SPDX-License-Identifier: BSD-3-Clause
#include "scene.hpp"

#include "abut/deck/deck.hpp"
#include "abut/deck/schema.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

using namespace abut::deck;

namespace {

/// Key paths of the schema: a name of the user's choice is NAME.
std::set<std::string> documented() {
  std::set<std::string> paths;
  const std::function<void(const Field&, const std::string&)> walk = [&](const Field& map,
                                                                         const std::string& path) {
    for (const Field& field : map.fields) {
      std::string own = path + field.key;
      paths.insert(own);
      const bool named =
          field.kind == Field::Kind::named_map || field.kind == Field::Kind::curve_map;
      if (named)
        paths.insert(own += ".NAME");
      walk(field, own + ".");
    }
  };
  walk(schema(), "");
  return paths;
}

const Field& find(const Field& map, const std::string& key) {
  const auto found = std::find_if(map.fields.begin(), map.fields.end(),
                                  [&](const Field& field) { return field.key == key; });
  EXPECT_NE(found, map.fields.end()) << key;
  return *found;
}

} // namespace

TEST(Schema, ListsEveryKeyThatADeckMayUse) {
  const std::set<std::string> paths = documented();
  const std::set<std::string> sections{"surfaces", "materials", "bodies",  "displacements",
                                       "loads",    "curves",    "contact", "verify"};
  const Deck deck = parse_deck(yaml_scene, "ball.yaml");
  ASSERT_GT(deck.locations.size(), 60u);
  for (const auto& [path, where] : deck.locations) {
    std::string general = path;
    const std::size_t dot = path.find('.');
    if (dot != std::string::npos && sections.count(path.substr(0, dot)))
      general =
          path.substr(0, dot) + ".NAME" +
          (path.find('.', dot + 1) == std::string::npos ? ""
                                                        : path.substr(path.find('.', dot + 1)));
    EXPECT_TRUE(paths.count(general)) << path << " at " << where.text();
  }
}

TEST(Schema, TakesDefaultsAndRangesFromTheDeclaration) {
  const Field top = schema();
  const Field& contact = find(top, "contact");
  EXPECT_EQ(find(contact, "penalty_factor").initial, "automatic");
  EXPECT_EQ(find(contact, "penalty_factor").range, "> 0");
  EXPECT_EQ(find(contact, "penalty").unit, "pressure/length");
  EXPECT_TRUE(find(contact, "primary").required);
  EXPECT_EQ(find(contact, "enforcement").initial, "penalty");
  EXPECT_EQ(find(contact, "enforcement").choices.size(), 2u);
  EXPECT_EQ(find(find(top, "materials"), "poisson").range, "> -1 and < 0.5");
  const Field& loads = find(top, "loads");
  EXPECT_EQ(find(loads, "side_set").with, (std::vector<std::string>{"traction", "pressure"}));
  EXPECT_EQ(loads.one_of.size(), 4u);
}

TEST(Schema, TextAndMarkdownNameEveryKey) {
  const std::string text = schema_text();
  const std::string markdown = schema_markdown();
  for (const std::string& path : documented()) {
    const std::string key = path.substr(path.rfind('.') + 1);
    EXPECT_NE(text.find(key), std::string::npos) << path;
    EXPECT_NE(markdown.find(key), std::string::npos) << path;
  }
}

TEST(Schema, DeckReferenceIsUpToDate) {
  const std::string file = std::string(ABUT_SOURCE_DIR) + "/docs/user/deck-reference.md";
  std::ifstream stream(file);
  const std::string found{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_TRUE(found == schema_markdown()) << "write it anew: abut schema --markdown > " << file;
}

TEST(Schema, JsonIsASchemaWithTheSameKeys) {
  const auto json = nlohmann::json::parse(schema_json());
  EXPECT_EQ(json["required"], (nlohmann::json{"mesh", "bodies"}));
  const auto& contact = json["properties"]["contact"]["additionalProperties"];
  EXPECT_EQ(contact["additionalProperties"], false);
  EXPECT_EQ(contact["properties"]["tie_distance"]["exclusiveMinimum"], 0.0);
  EXPECT_EQ(contact["properties"]["tie_distance"]["default"], 0.1);
  EXPECT_EQ(contact["properties"]["enforcement"]["enum"][1], "augmented_lagrangian");
  const auto& poisson =
      json["properties"]["materials"]["additionalProperties"]["properties"]["poisson"];
  EXPECT_EQ(poisson["exclusiveMinimum"], -1.0);
  EXPECT_EQ(poisson["exclusiveMaximum"], 0.5);
  const auto& loads = json["properties"]["loads"]["additionalProperties"];
  EXPECT_EQ(loads["oneOf"][0]["required"], (nlohmann::json{"traction", "side_set"}));
}
