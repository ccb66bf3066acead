// SPDX-License-Identifier: BSD-3-Clause
// Elements of all types, and their faces by the corners that Abaqus gives them.
#include "abut/fem/cell.hpp"
#include "abut/fem/measure.hpp"
#include "two_cubes.hpp"

#include <algorithm>
#include <array>
#include <sstream>

using namespace abut;
using namespace abut::abaqus_test;

namespace {

using Point = std::array<double, 3>;

struct Kind {
  const char* type;
  std::vector<Point> corners;
  std::vector<std::array<int, 2>> edges; ///< between corners, of the nodes behind them
  std::vector<std::vector<int>> faces; ///< corners of S1, S2, ...: Abaqus' manual, "Solid elements"
  double volume;
};

const std::vector<Point> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<Point> prism = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
const std::vector<Point> tet = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::vector<int>> cube_faces = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                                  {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
const std::vector<std::vector<int>> tet_faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
const std::vector<std::array<int, 2>> cube_edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                    {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
const std::vector<std::array<int, 2>> tet_edges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

const Kind kinds[] = {
    {"C3D4", tet, {}, tet_faces, 1.0 / 6.0},
    {"C3D10", tet, tet_edges, tet_faces, 1.0 / 6.0},
    {"C3D6", prism, {}, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}, 0.5},
    {"C3D8", cube, {}, cube_faces, 1.0},
    {"C3D8R", cube, {}, cube_faces, 1.0},
    {"C3D8I", cube, {}, cube_faces, 1.0},
    {"C3D20", cube, cube_edges, cube_faces, 1.0},
    {"C3D20R", cube, cube_edges, cube_faces, 1.0},
};

std::vector<Point> nodes_of(const Kind& kind) {
  std::vector<Point> x = kind.corners;
  for (const auto& [a, b] : kind.edges) {
    Point middle{};
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] = 0.5 * (kind.corners[std::size_t(a)][i] + kind.corners[std::size_t(b)][i]);
    x.push_back(middle);
  }
  return x;
}

std::string deck_of(const Kind& kind) {
  std::ostringstream text;
  text << "*NODE, NSET=ALL\n";
  const std::vector<Point> x = nodes_of(kind);
  for (std::size_t n = 0; n < x.size(); ++n)
    text << n + 1 << ", " << x[n][0] << ", " << x[n][1] << ", " << x[n][2] << "\n";
  text << "*ELEMENT, TYPE=" << kind.type << ", ELSET=E\n1";
  for (std::size_t n = 0; n < x.size(); ++n)
    text << (n == 10 ? ",\n" : ", ") << n + 1;
  text << "\n";
  for (std::size_t f = 0; f < kind.faces.size(); ++f)
    text << "*SURFACE, NAME=F" << f + 1 << "\nE, S" << f + 1 << "\n";
  text << "*MATERIAL, NAME=M\n*ELASTIC\n1, 0\n*SOLID SECTION, ELSET=E, MATERIAL=M\n"
       << "*BOUNDARY\nALL, 1, 3\n*STEP\n*STATIC\n*END STEP\n";
  return text.str();
}

TEST(AbaqusCells, NodesAndFacesAreThoseOfExodus) {
  for (const Kind& kind : kinds) {
    const abaqus::Scene s = scene_of(deck_of(kind));
    ASSERT_EQ(s.mesh.blocks.size(), 1u) << kind.type;
    const mesh::BlockData& block = s.mesh.blocks[0];
    Vec3 x[fem::max_cell_nodes];
    for (std::size_t a = 0; a < block.nodes.size(); ++a)
      for (int i = 0; i < 3; ++i)
        x[a][i] = s.mesh.x[3 * std::size_t(block.nodes[a]) + std::size_t(i)];
    const fem::CellMeasure m = fem::measure_cell(block.type, x);
    EXPECT_NEAR(m.volume, kind.volume, 1e-12) << kind.type;
    EXPECT_GT(m.least, 0.0) << kind.type; // middles that are swapped fold the element
    for (std::size_t f = 0; f < kind.faces.size(); ++f) {
      const auto& sides = s.mesh.side_sets.at("F" + std::to_string(f + 1));
      ASSERT_EQ(sides.size(), 1u);
      const fem::CellSide& side = fem::side(block.type, sides[0].side);
      std::vector<Global> corners, expected(kind.faces[f].begin(), kind.faces[f].end());
      for (int a = 0; a < fem::face_corners(side.type); ++a)
        corners.push_back(block.nodes[std::size_t(side.nodes[a])]);
      std::sort(corners.begin(), corners.end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(corners, expected) << kind.type << " S" << f + 1;
    }
  }
}

TEST(AbaqusCells, MiddlesOfEdgesAreWhereExodusHasThem) {
  for (const Kind& kind : kinds) {
    if (kind.edges.empty())
      continue;
    const abaqus::Scene s = scene_of(deck_of(kind));
    const mesh::BlockData& block = s.mesh.blocks[0];
    const auto at = [&](int a, std::size_t i) {
      return s.mesh.x[3 * std::size_t(block.nodes[std::size_t(a)]) + i];
    };
    for (int side = 0; side < fem::info(block.type).sides; ++side) {
      const fem::CellSide& c = fem::side(block.type, side);
      const int corners = fem::face_corners(c.type);
      for (int a = 0; a < corners; ++a)
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(at(c.nodes[corners + a], i),
                      0.5 * (at(c.nodes[a], i) + at(c.nodes[(a + 1) % corners], i)), 1e-15)
              << kind.type << " side " << side;
    }
  }
}

} // namespace
