// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/meshgen/generators.hpp"

#include <exodusII.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

using namespace abut;
using ::testing::HasSubstr;

namespace {

void expect_same(const mesh::MeshData& a, const mesh::MeshData& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.dim, b.dim);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.node_id, b.node_id);
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].id, b.blocks[i].id);
    EXPECT_EQ(a.blocks[i].name, b.blocks[i].name);
    EXPECT_EQ(a.blocks[i].type, b.blocks[i].type);
    EXPECT_EQ(a.blocks[i].nodes, b.blocks[i].nodes);
    EXPECT_EQ(a.blocks[i].element_id, b.blocks[i].element_id);
  }
  EXPECT_EQ(a.node_sets, b.node_sets);
  ASSERT_EQ(a.side_sets.size(), b.side_sets.size());
  for (const auto& [name, sides] : a.side_sets) {
    const auto& other = b.side_sets.at(name);
    ASSERT_EQ(sides.size(), other.size()) << name;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      EXPECT_EQ(sides[i].block, other[i].block);
      EXPECT_EQ(sides[i].element, other[i].element);
      EXPECT_EQ(sides[i].side, other[i].side);
    }
  }
}

std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

std::string read_message(const std::string& path) {
  return message_of([&] { io::read_exodus(path); });
}

class EveryCell : public ::testing::TestWithParam<fem::CellType> {};

TEST_P(EveryCell, ComesBackAsWritten) {
  meshgen::RingsOptions o;
  o.element = GetParam();
  mesh::MeshData m = meshgen::rings(o);
  m.node_sets["a name that is longer than the thirty-two characters of old files"] = {3, 1};
  m.node_sets["empty"] = {};
  m.side_sets["none"] = {};
  io::write_mesh("cell.exo", m);
  expect_same(io::read_exodus("cell.exo"), m);

  for (Global n = 0; n < m.num_nodes(); ++n)
    m.node_id.push_back(2 * n + 7);
  Global id = 100;
  for (auto& b : m.blocks)
    for (std::size_t e = 0; e < b.nodes.size() / fem::info(b.type).nodes; ++e)
      b.element_id.push_back(id += 2);
  for (auto& b : m.blocks)
    b.id *= 10;
  io::write_mesh("cell.exo", m);
  expect_same(io::read_exodus("cell.exo"), m);
}

INSTANTIATE_TEST_SUITE_P(Cells, EveryCell,
                         ::testing::Values(fem::CellType::hex8, fem::CellType::hex20,
                                           fem::CellType::hex27, fem::CellType::tet4,
                                           fem::CellType::tet10, fem::CellType::wedge6),
                         [](const auto& p) { return fem::info(p.param).name; });

/// A file made call by call: one block of one cell with the given nodes, without names.
void make_file(const std::string& path, const char* type, std::vector<std::int64_t> nodes,
               int mode) {
  int word = 8, file_word = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER | EX_ALL_INT64_API | mode, &word, &file_word);
  ASSERT_GE(id, 0);
  ex_put_init(id, "by hand", 3, 8, 1, 1, 1, 1);
  const std::vector<double> x{0, 1, 1, 0, 0, 1, 1, 0}, y{0, 0, 1, 1, 0, 0, 1, 1},
      z{0, 0, 0, 0, 1, 1, 1, 1};
  ex_put_coord(id, x.data(), y.data(), z.data());
  ex_put_block(id, EX_ELEM_BLOCK, 12, type, 1, static_cast<std::int64_t>(nodes.size()), 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 12, nodes.data(), nullptr, nullptr);
  const std::int64_t set_nodes[2] = {1, 8}, element = 1, side = 6;
  ex_put_set_param(id, EX_NODE_SET, 5, 2, 0);
  ex_put_set(id, EX_NODE_SET, 5, set_nodes, nullptr);
  ex_put_set_param(id, EX_SIDE_SET, 9, 1, 0);
  ex_put_set(id, EX_SIDE_SET, 9, &element, &side);
  ex_close(id);
}

const std::vector<std::int64_t> good{1, 2, 3, 4, 5, 6, 7, 8};

TEST(ReadExodus, NamesWhatHasNoNameInAnyIntegerWidth) {
  for (int mode : {0, EX_NETCDF4, EX_NETCDF4 | EX_ALL_INT64_DB}) {
    make_file("unnamed.exo", "hex", good, mode);
    const mesh::MeshData m = io::read_exodus("unnamed.exo");
    EXPECT_EQ(m.title, "by hand");
    EXPECT_EQ(m.blocks.at(0).name, "block_12");
    EXPECT_EQ(m.blocks[0].type, fem::CellType::hex8);
    EXPECT_EQ(m.node_sets.at("nodeset_5"), (std::vector<Global>{0, 7}));
    EXPECT_EQ(m.side_sets.at("sideset_9").at(0).side, 5);
    EXPECT_TRUE(m.node_id.empty());
    io::write_mesh("again.exo", m);
    expect_same(io::read_exodus("again.exo"), m);
  }
}

TEST(ReadExodus, NamesWhatIsWrong) {
  make_file("wrong.exo", "PYRAMID", {1, 2, 3, 4, 5}, 0);
  EXPECT_THAT(read_message("wrong.exo"), HasSubstr("block 'block_12' (id 12) has elements of type "
                                                   "PYRAMID with 5 nodes"));
  make_file("wrong.exo", "HEX", {1, 2, 3, 4, 5, 6, 7, 9}, 0);
  EXPECT_THAT(read_message("wrong.exo"),
              HasSubstr("element 1 of block 'block_12' has node 9, but nodes go from 1 to 8"));
  make_file("wrong.exo", "HEX", {1, 2, 3, 4, 5, 6, 7, 7}, 0);
  EXPECT_THAT(read_message("wrong.exo"), HasSubstr("has node 7 twice"));
}

TEST(ReadExodus, MissingForeignAndDamagedFiles) {
  EXPECT_THAT(read_message("missing.exo"),
              HasSubstr("'missing.exo': cannot be read: No such file"));
  std::ofstream("text.exo") << "solid nothing of the kind\n";
  EXPECT_THAT(read_message("text.exo"), HasSubstr("'text.exo': not a readable Exodus II file"));
  std::ofstream("empty.exo").flush();
  EXPECT_THAT(read_message("empty.exo"), HasSubstr("not a readable Exodus II file"));

  meshgen::BoxOptions o;
  o.divisions = {6, 6, 6};
  io::write_mesh("whole.exo", meshgen::box(o));
  const auto size = std::filesystem::file_size("whole.exo");
  for (auto left : {size / 100, size / 3, size / 2, size * 9 / 10, size - 4}) {
    std::filesystem::copy_file("whole.exo", "cut.exo",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file("cut.exo", left);
    EXPECT_THAT(read_message("cut.exo"),
                ::testing::AnyOf(HasSubstr("'cut.exo': not a readable Exodus II file"),
                                 HasSubstr("the file may be truncated")))
        << left << " of " << size;
  }
  EXPECT_THAT(message_of([&] { io::write_mesh("no/such/folder/m.exo", meshgen::box(o)); }),
              HasSubstr("'no/such/folder/m.exo' cannot be written: No such file or directory"));
}

TEST(ReadExodus, PrintsNothing) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  read_message("missing.exo");
  std::ofstream("text.exo") << "no mesh\n";
  read_message("text.exo");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

} // namespace
