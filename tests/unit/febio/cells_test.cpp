// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include "abut/fem/cell_shape.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio::test;

namespace {

/// A file of one element with FEBio's node order, whose nodes lie at the given places.
std::string one_element(const std::string& type, const std::vector<std::array<double, 3>>& nodes) {
  std::ostringstream out;
  out << "<febio_spec version=\"4.0\"><Module type=\"solid\"/><Control/>"
         "<Material><material id=\"1\" name=\"m\" type=\"neo-Hookean\"><E>1</E><v>0</v></material>"
         "</Material><Mesh><Nodes>";
  for (std::size_t n = 0; n < nodes.size(); ++n)
    out << "<node id=\"" << n + 1 << "\">" << nodes[n][0] << "," << nodes[n][1] << ","
        << nodes[n][2] << "</node>";
  out << "</Nodes><Elements type=\"" << type << "\" name=\"e\"><elem id=\"1\">";
  for (std::size_t n = 0; n < nodes.size(); ++n)
    out << (n ? "," : "") << n + 1;
  out << "</elem></Elements></Mesh><MeshDomains><SolidDomain name=\"e\" mat=\"m\"/></MeshDomains>"
         "</febio_spec>";
  return out.str();
}

/// Each node of the imported cell must lie where abut's reference cell has it.
template <fem::CellType C>
void expect_order(const std::string& type, const std::vector<std::array<double, 3>>& nodes) {
  const mesh::MeshData mesh = febio::import(one_element(type, nodes), "m.feb", "m").mesh;
  ASSERT_EQ(mesh.blocks[0].type, C);
  ASSERT_EQ(mesh.blocks[0].nodes.size(), nodes.size());
  for (int a = 0; a < fem::CellShape<C>::nodes; ++a) {
    double xi[3];
    fem::CellShape<C>::node(a, xi);
    const std::size_t node = static_cast<std::size_t>(mesh.blocks[0].nodes[std::size_t(a)]);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_DOUBLE_EQ(mesh.x[3 * node + i], xi[i]) << type << " node " << a;
  }
}

// FEBio User Manual, elements: corners, edges of the bottom, of the top, vertical ones; faces.
const std::vector<std::array<double, 3>> brick = {
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
    {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
    {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}, {0, -1, 0},
    {1, 0, 0},    {0, 1, 0},   {-1, 0, 0},  {0, 0, -1},  {0, 0, 1},   {0, 0, 0}};

TEST(Cells, NodesStandInAbutsOrder) {
  using fem::CellType;
  expect_order<CellType::hex8>("hex8", {brick.begin(), brick.begin() + 8});
  expect_order<CellType::hex20>("hex20", {brick.begin(), brick.begin() + 20});
  expect_order<CellType::hex27>("hex27", brick);
  const std::vector<std::array<double, 3>> tet = {
      {0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
      {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  expect_order<CellType::tet4>("tet4", {tet.begin(), tet.begin() + 4});
  expect_order<CellType::tet10>("tet10", tet);
  expect_order<CellType::wedge6>(
      "penta6", {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
}

} // namespace
