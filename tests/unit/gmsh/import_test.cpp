// SPDX-License-Identifier: BSD-3-Clause
// Texts of a few lines; whole files in all flavours: tests/verification/gmsh_import_test.py.
#include "abut/core/error.hpp"
#include "abut/gmsh/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut;
using ::testing::ElementsAre;

namespace {

const std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
/// Volume 1 is in groups 7 and 8, surface 2 in group 9 the wrong way round.
const std::string entities = "$Entities\n0 0 1 1\n"
                             "2 0 0 0 1 1 1 1 -9 0\n"
                             "1 0 0 0 1 1 1 2 7 8 1 2\n"
                             "$EndEntities\n";
const std::string nodes = "$Nodes\n2 5 10 14\n"
                          "2 2 1 3\n10\n11\n12\n0 0 0 .5 .5\n1 0 0 .5 .5\n0 1 0 .5 .5\n"
                          "3 1 0 2\n13\n14\n0 0 1\n9 9 9\n"
                          "$EndNodes\n";
const std::string elements = "$Elements\n2 2 1 2\n"
                             "2 2 2 1\n30 10 12 11\n"
                             "3 1 4 1\n40 10 11 12 13\n"
                             "$EndElements\n";

std::string error_of(const std::string& text) {
  try {
    gmsh::import(text, "a.msh", "a");
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

std::string with(std::string text, const std::string& old, const std::string& changed) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), changed);
}

TEST(Gmsh, GroupsOfEntitiesNameBlocksAndSets) {
  const std::string names =
      "$PhysicalNames\n2\n3 7 \"a \"\"solid\"\n2 9 \"floor\"\n$EndPhysicalNames\n";
  const gmsh::Scene s = gmsh::import(format + names + entities + nodes + elements, "a.msh", "a");
  ASSERT_EQ(s.mesh.blocks.size(), 1u);
  EXPECT_EQ(s.mesh.blocks[0].name, "a \"\"solid");
  EXPECT_THAT(s.mesh.blocks[0].nodes, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(s.mesh.blocks[0].element_id, ElementsAre(40));
  EXPECT_THAT(s.mesh.node_id, ElementsAre(10, 11, 12, 13));
  EXPECT_THAT(s.mesh.node_sets.at("floor"), ElementsAre(0, 1, 2));
  ASSERT_EQ(s.mesh.side_sets.at("floor").size(), 1u);
  EXPECT_EQ(s.mesh.side_sets.at("floor")[0].side, 3);
  EXPECT_EQ(s.report.count(translation::Fate::used), 2);
  EXPECT_EQ(
      s.report.text("a.msh"),
      "a.msh: 2 constructs used, 2 ignored because harmless, 0 refused\n"
      "used  line 34  volume group 'a \"\"solid': block 'a \"\"solid' of 1 TETRA4\n"
      "used  line 32  surface group 'floor': side set and node set 'floor' of 1 faces\n"
      "ignored  line 34  volume group 'volume_8': 1 elements that are in the block of another "
      "group already\n"
      "ignored  line 14  $Nodes: 1 nodes that belong to no volume\n");
}

TEST(Gmsh, WithoutEntitiesNothingIsInAGroup) {
  const gmsh::Scene s = gmsh::import(format + nodes + elements, "a.msh", "a");
  EXPECT_EQ(s.mesh.blocks[0].name, "volume_1");
  EXPECT_EQ(s.mesh.side_sets.count("surface_2"), 1u);
}

TEST(Gmsh, TheDeckToStartFromNamesWhatThereIs) {
  const gmsh::Scene s = gmsh::import(format + nodes + elements, "a.msh", "a");
  EXPECT_NE(s.deck.find("mesh: {file: a.exo}"), std::string::npos) << s.deck;
  EXPECT_NE(s.deck.find("#   surface_2: 1 faces"), std::string::npos) << s.deck;
  EXPECT_NE(s.deck.find("volume_1: {blocks: [volume_1], material: some_material}"),
            std::string::npos)
      << s.deck;
}

TEST(Gmsh, ErrorsNameTheLine) {
  const std::string whole = format + entities + nodes + elements;
  EXPECT_EQ(error_of(whole), "no error");
  EXPECT_EQ(error_of(with(whole, "40 10 11", "40 10 x1")),
            "a.msh:29: $Elements: expected a node number, got 'x1'");
  EXPECT_EQ(error_of(with(whole, "40 10 11", "40 10 99")),
            "a.msh:29: $Elements: element 40 has node 99, which is not among the nodes");
  EXPECT_EQ(error_of(with(whole, "3 1 4 1", "3 1 5 1")),
            "a.msh:30: $Elements: expected a node number, got '$EndElements'");
  EXPECT_EQ(error_of(with(whole, "1 0 0 .5 .5", "1e200 0 0 .5 .5")),
            "a.msh:16: $Nodes: expected a coordinate, got one beyond all measure");
  EXPECT_EQ(error_of(with(whole, "$EndNodes", "$EndNode")),
            "a.msh:23: $Nodes: expected $EndNodes, got '$EndNode'");
  EXPECT_EQ(
      error_of(with(whole, "2 7 8", "200000 7 8")),
      "a.msh:7: $Entities: expected a number of groups, got 200000, for which the file is too "
      "short");
  EXPECT_EQ(error_of(format + nodes + nodes + elements),
            "a.msh:19: $Nodes: there is a second section of this name");
  EXPECT_EQ(error_of("$MeshFormat\n4.1 2 8\n"),
            "a.msh:2: $MeshFormat: expected 0 (ASCII) or 1 (binary), got '2'");
  EXPECT_EQ(error_of(whole + "$PartitionedEntities\n"),
            "a.msh:31: $PartitionedEntities: the mesh is cut into parts; save it whole, without "
            "partitions");
}

TEST(Gmsh, ErrorsOfBinaryFilesNameTheByte) {
  const std::string start = "$MeshFormat\n4.1 1 8\n";
  EXPECT_EQ(error_of(start + std::string("\1\0\0", 3)),
            "a.msh: byte 20: $MeshFormat: the file ends here");
  EXPECT_EQ(error_of(start + std::string("\2\0\0\0", 4)),
            "a.msh: byte 24: $MeshFormat: expected the number 1 in 4 bytes, which tells of the "
            "order of bytes");
}

TEST(Gmsh, KnowsItsFilesByTheirBeginning) {
  EXPECT_TRUE(gmsh::is_msh("\n $MeshFormat\n"));
  EXPECT_TRUE(gmsh::is_msh("$Comments\n"));
  EXPECT_FALSE(gmsh::is_msh("<?xml"));
  EXPECT_FALSE(gmsh::is_msh(""));
}

} // namespace
