// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/io/result_writer.hpp"
#include "abut/meshgen/generators.hpp"

#include <exodusII.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace abut;

namespace {

mesh::MeshData whole_mesh() {
  meshgen::BlockPairOptions o;
  o.lower_divisions = {3, 4, 5};
  o.upper_divisions = {3, 3, 4};
  mesh::MeshData m = meshgen::block_pair(o);
  for (Global n = 0; n < m.num_nodes(); ++n)
    m.node_id.push_back(100 + 3 * n);
  Global element = 0;
  for (mesh::BlockData& b : m.blocks)
    for (std::size_t e = 0; e < b.nodes.size() / 8; ++e)
      b.element_id.push_back(50 + 2 * element++);
  return m;
}

const io::ResultNames names{{"displacement_x", "displacement_y", "displacement_z", "input_number"},
                            {"centre_z_plus_time", "element_number"},
                            {"force", "newton_iterations"}};

/// Fields that are known from coordinates, number and time: check_exodus.py has the same formulas.
io::ResultStep step_at(double time, const mesh::Mesh& m) {
  io::ResultStep s{time, {{}, {}, {}, {}}, {{}, {}}, {}};
  for (Local n = 0; n < m.num_owned; ++n) {
    const double* x = &m.x[3 * n];
    s.nodal[0].push_back(time * x[0]);
    s.nodal[1].push_back(2.0 * x[1]);
    s.nodal[2].push_back(time + x[2]);
    s.nodal[3].push_back(static_cast<double>(m.node_input[n]));
  }
  for (const mesh::Block& b : m.blocks)
    for (Local e = 0; e < b.size(); ++e) {
      double z = 0.0;
      for (int i = 0; i < 8; ++i)
        z += m.x[3 * b.nodes[8 * e + i] + 2] / 8.0;
      s.element[0].push_back(z + time);
      s.element[1].push_back(static_cast<double>(b.element[e]));
    }
  // Only the root's values count.
  s.global = m.comm.is_root() ? std::vector<double>{10.0 * time, 4.0} : std::vector<double>{};
  return s;
}

struct Scene {
  Comm comm{MPI_COMM_WORLD};
  mesh::Mesh mesh = mesh::distribute(comm.is_root() ? whole_mesh() : mesh::MeshData{}, comm);
  std::string suffix = std::to_string(comm.size());
};

int steps_in(const std::string& path) {
  int word = 8, file_word = 0;
  float version = 0;
  const int id = ex_open(path.c_str(), EX_READ, &word, &file_word, &version);
  if (id < 0)
    return -1;
  const auto steps = static_cast<int>(ex_inquire_int(id, EX_INQ_TIME));
  ex_close(id);
  return steps;
}

void write_all(const Scene& s, io::ResultWriter& writer, bool here) {
  int count = 0;
  for (double time : {0.5, 1.25, 2.0}) {
    writer.write_step(step_at(time, s.mesh));
    ++count;
    // Readable while the writer still has it open.
    if (here) {
      EXPECT_EQ(steps_in(writer.path()), count);
    }
  }
  EXPECT_EQ(writer.steps(), 3);
}

TEST(ResultWriter, OneFileKeepsTheInput) {
  const Scene s;
  {
    io::ResultWriter writer("results" + s.suffix, s.mesh, names, io::Files::automatic);
    EXPECT_EQ(writer.path(), "results" + s.suffix + ".exo");
    write_all(s, writer, s.comm.is_root());
  }
  if (!s.comm.is_root())
    return;
  const mesh::MeshData in = whole_mesh(), out = io::read_exodus("results" + s.suffix + ".exo");
  EXPECT_EQ(out.x, in.x);
  EXPECT_EQ(out.node_id, in.node_id);
  ASSERT_EQ(out.blocks.size(), in.blocks.size());
  for (std::size_t b = 0; b < in.blocks.size(); ++b) {
    EXPECT_EQ(out.blocks[b].name, in.blocks[b].name);
    EXPECT_EQ(out.blocks[b].nodes, in.blocks[b].nodes);
    EXPECT_EQ(out.blocks[b].element_id, in.blocks[b].element_id);
  }
  std::map<std::string, std::vector<Global>> own; // no two things of one name
  for (const auto& [name, nodes] : in.node_sets)
    own[in.side_sets.count(name) > 0 ? name + "_nodes" : name] = nodes;
  EXPECT_NE(own, in.node_sets);
  EXPECT_EQ(out.node_sets, own);
  for (const auto& [name, sides] : in.side_sets)
    EXPECT_EQ(out.side_sets.at(name).size(), sides.size()) << name;
}

TEST(ResultWriter, FilesPerRankHoldTheParts) {
  const Scene s;
  std::string file = "parts" + s.suffix + ".exo"; // one rank writes one file
  if (s.comm.size() > 1)
    file += "." + s.suffix + "." + std::to_string(s.comm.rank());
  {
    io::ResultWriter writer("parts" + s.suffix, s.mesh, names, io::Files::per_rank);
    EXPECT_EQ(writer.path(), file);
    write_all(s, writer, true);
  }
  const mesh::MeshData out = io::read_exodus(file);
  EXPECT_EQ(out.x, s.mesh.x);
  EXPECT_EQ(out.node_id, s.mesh.node_id);
  ASSERT_EQ(out.blocks.size(), 2U); // also those without elements here
  EXPECT_EQ(out.node_sets.size(), s.mesh.node_sets.size());
}

TEST(ResultWriter, FoldersThatCannotBeWrittenFailOnAllRanks) {
  const Scene s;
  for (io::Files files : {io::Files::one, io::Files::per_rank}) {
    try {
      io::ResultWriter writer("no/such/folder/results", s.mesh, names, files);
      ADD_FAILURE() << "no error";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr("no/such/folder/results.exo"));
      EXPECT_THAT(e.what(), ::testing::HasSubstr("No such file or directory"));
    }
  }
}

TEST(ResultWriter, WrongSizesAreDefectsOnAllRanks) {
  const Scene s;
  io::ResultWriter writer("sizes" + s.suffix, s.mesh, names, io::Files::one);
  io::ResultStep step = step_at(1.0, s.mesh);
  if (s.comm.rank() == s.comm.size() - 1)
    step.nodal[2].push_back(0.0);
  EXPECT_THROW(writer.write_step(step), Defect);
  writer.write_step(step_at(1.0, s.mesh));
  EXPECT_THROW(writer.write_step(step_at(1.0, s.mesh)), Defect); // time must grow
}

TEST(ResultWriter, MeshAlone) {
  const Scene s;
  { io::ResultWriter writer("plain" + s.suffix, s.mesh, {}, io::Files::one); }
  if (s.comm.is_root()) {
    EXPECT_EQ(steps_in("plain" + s.suffix + ".exo"), 0);
    EXPECT_EQ(io::read_exodus("plain" + s.suffix + ".exo").x, whole_mesh().x);
  }
}

} // namespace
