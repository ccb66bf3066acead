// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/meshgen/generate.hpp"
#include "mesh_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut::mesh;
using namespace abut::meshgen;
using ::testing::HasSubstr;

namespace {

std::string message_of(const std::string& kind, const std::map<std::string, std::string>& options) {
  try {
    generate(kind, options);
  } catch (const abut::InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Generate, EveryKindWorksWithoutOptions) {
  ASSERT_EQ(generator_kinds().size(), 11U);
  for (const std::string& kind : generator_kinds()) {
    const MeshData m = generate(kind, {});
    EXPECT_GT(m.num_elements(), 0) << kind;
    EXPECT_GT(min_scaled_jacobian(m), 0.3) << kind;
    EXPECT_GT(generator_keys(kind).size(), 5U) << kind;
  }
}

TEST(Generate, ReadsListsNumbersAndWords) {
  const MeshData m = generate("box", {{"size", "[2, 3, 4]"},
                                      {"divisions", "2"},
                                      {"origin", "-1,0 1.5"},
                                      {"element", "tet10"},
                                      {"name", "body"}});
  EXPECT_EQ(m.num_elements(), 48);
  EXPECT_EQ(m.blocks[0].name, "body");
  EXPECT_EQ(m.x[0], -1.0);
  EXPECT_NEAR(abut_test::volume(m), 24.0, 1e-12);
  EXPECT_EQ(generate("sphere_plane", {{"plate", "off"}, {"facets", "4"}}).blocks.size(), 1U);
}

TEST(Generate, NamesWhatIsWrong) {
  EXPECT_THAT(message_of("bloks", {}), HasSubstr("did you mean 'blocks'"));
  EXPECT_THAT(message_of("box", {{"divsions", "2"}}), HasSubstr("did you mean 'divisions'"));
  EXPECT_THAT(message_of("box", {{"divisions", "2.5"}}),
              HasSubstr("'divisions': expected a whole"));
  EXPECT_THAT(message_of("box", {{"size", "1,2"}}), HasSubstr("expected three numbers"));
  EXPECT_THAT(message_of("box", {{"size", "1,2,x"}}), HasSubstr("got 'x'"));
  EXPECT_THAT(message_of("box", {{"element", "hex9"}}), HasSubstr("did you mean 'hex8'"));
  EXPECT_THAT(message_of("box", {{"size", "-1"}}), HasSubstr("positive size"));
  EXPECT_THAT(message_of("sphere_plane", {{"plate", "perhaps"}}), HasSubstr("true or false"));
  EXPECT_THAT(message_of("rings", {{"inner_radius", "2"}}), HasSubstr("positive size"));
}

// Not a shortage of memory, or hours.
TEST(Generate, RefusesMeshesThatAreFarTooLarge) {
  for (const char* divisions : {"2147483647", "1000,1000,1000"})
    EXPECT_THAT(message_of("box", {{"divisions", divisions}}), HasSubstr("make it coarser"));
  EXPECT_THAT(message_of("paraboloid", {{"size", "1e300"}, {"growth", "1"}}),
              HasSubstr("more than 10000 cells in one direction"));
  EXPECT_THAT(message_of("quarter_cylinder", {{"facets", "5000"}}), HasSubstr("make it coarser"));
  EXPECT_THAT(
      message_of("punch", {{"shape", "disc"}, {"facets", "18000"}, {"punch_divisions", "2"}}),
      HasSubstr("make it coarser"));
}

} // namespace
