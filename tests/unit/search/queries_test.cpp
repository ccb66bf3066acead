// SPDX-License-Identifier: BSD-3-Clause
// Queries by the tree against trying every face, against sampled faces, and at ties.
#include "abut/search/brute_force.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace abut;
using namespace abut::search;
using fem::FaceType;

namespace {

const FaceType all_faces[] = {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3,
                              FaceType::tri6};

/// A wavy sheet over [0, 1]^2 of cells x cells squares, each one quad or two triangles; neighbours
/// share nodes. Nodes are moved off the wave by up to `noise`.
struct Sheet {
  Faces faces;
  Bvh<3> tree;

  Sheet(FaceType type, int cells, double height, double noise, unsigned seed = 1) {
    std::vector<FaceType> types;
    std::vector<Local> offset{0}, node;
    const int side = 2 * cells + 1; // a lattice of corners, middles and centers
    const double step = 0.5 / cells;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-noise, noise);
    std::vector<Vec3> x;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        x.push_back({{i * step + off(random), j * step + off(random),
                      height * std::sin(7.0 * i * step) * std::cos(5.0 * j * step) + off(random)}});
    const bool triangle = fem::is_triangle(type);
    for (int c = 0; c < cells * cells; ++c)
      for (int half = 0; half < (triangle ? 2 : 1); ++half) {
        for (int a = 0; a < fem::face_nodes(type); ++a) {
          double xi[2];
          node_parameters(type, a, xi);
          int i = int(2.0 * xi[0]), j = int(2.0 * xi[1]); // lattice steps from the cell's corner
          if (!triangle)
            i = int(xi[0]) + 1, j = int(xi[1]) + 1;
          else if (half == 1)
            i = 2 - i, j = 2 - j;
          node.push_back((2 * (c / cells) + j) * side + 2 * (c % cells) + i);
        }
        types.push_back(type);
        offset.push_back(static_cast<Local>(node.size()));
      }
    faces = {make_view("type", types), make_view("offset", offset), make_view("node", node),
             make_view("x", x)};
    std::vector<Box<3>> boxes;
    for (Local f = 0; f < faces.size(); ++f) {
      Vec3 y[fem::max_face_nodes];
      faces.coordinates(f, y);
      boxes.push_back(face_box(type, y));
    }
    tree.build(boxes);
  }
};

std::vector<Vec3> random_points(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.1, 1.1), height(-0.3, 0.3);
  std::vector<Vec3> x;
  for (int k = 0; k < n; ++k)
    x.push_back({{place(random), place(random), height(random)}});
  return x;
}

void expect_same(const Nearest& fast, const Nearest& slow) {
  EXPECT_EQ(fast.face, slow.face);
  EXPECT_EQ(fast.distance, slow.distance);
  EXPECT_EQ(fast.xi[0], slow.xi[0]);
  EXPECT_EQ(fast.xi[1], slow.xi[1]);
}

} // namespace

class Queries : public testing::TestWithParam<FaceType> {};
INSTANTIATE_TEST_SUITE_P(AllFaces, Queries, testing::ValuesIn(all_faces));

TEST_P(Queries, ClosestPointsAreThoseOfBruteForce) {
  const Sheet sheet(GetParam(), 6, 0.1, 0.01);
  for (const double reach : {1e3, 0.1}) {
    const auto points = make_view("points", random_points(150, 2));
    const auto found = closest_points(sheet.faces, sheet.tree.view(), points, reach);
    int none = 0;
    for (std::size_t i = 0; i < points.extent(0); ++i) {
      const PointQuery query{points(i), reach};
      expect_same(found(i), nearest_by_trying_all(sheet.faces, query));
      none += found(i).face < 0;
    }
    EXPECT_EQ(none > 0, reach < 1.0);
  }
}

TEST_P(Queries, LineHitsAreThoseOfBruteForce) {
  const Sheet sheet(GetParam(), 6, 0.1, 0.01);
  std::vector<Line> list;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (const Vec3& x : random_points(150, 4)) {
    const Vec3 d{{part(random), part(random), part(random)}};
    list.push_back({x, (1.0 / norm(d)) * d});
  }
  const auto lines = make_view("lines", list);
  const auto found = line_hits(sheet.faces, sheet.tree.view(), lines, 0.5);
  int hits = 0, behind = 0;
  for (std::size_t i = 0; i < lines.extent(0); ++i) {
    expect_same(found(i), nearest_by_trying_all(sheet.faces, LineQuery{lines(i), 0.5}));
    hits += found(i).face >= 0;
    behind += found(i).face >= 0 && found(i).distance < 0.0;
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(behind, 10);
  EXPECT_LT(hits, 150);
}

// No sampled point of any face is closer than the answer, and the box of a face holds its samples.
TEST_P(Queries, NothingSampledIsCloser) {
  const Sheet sheet(GetParam(), 3, 0.1, 0.01);
  const int n = 12;
  for (const Vec3& x : random_points(30, 5)) {
    const Nearest found = nearest(sheet.faces, sheet.tree.view(), PointQuery{x, 1e3});
    ASSERT_GE(found.face, 0);
    for (Local f = 0; f < sheet.faces.size(); ++f) {
      Vec3 y[fem::max_face_nodes];
      sheet.faces.coordinates(f, y);
      const Box<3> box = face_box(GetParam(), y);
      for (int k = 0; k <= n * n + 2 * n; ++k) {
        double xi[2] = {double(k % (n + 1)) / n, double(k / (n + 1)) / n};
        if (!fem::is_triangle(GetParam()))
          xi[0] = 2.0 * xi[0] - 1.0, xi[1] = 2.0 * xi[1] - 1.0;
        else if (xi[0] + xi[1] > 1.0)
          continue;
        const Vec3 sample = place_on_face(GetParam(), y, xi);
        EXPECT_GE(norm(sample - x), found.distance - 1e-12);
        EXPECT_LE(box.distance2(sample.v), 1e-28);
      }
    }
  }
}

// Above every node of a flat sheet lie several faces, equally near: the answer is the one with the
// lowest number of those that have the node, for a point and for a line.
TEST_P(Queries, TiesGoToTheLowestNumber) {
  const Sheet sheet(GetParam(), 4, 0.0, 0.0);
  int ties = 0;
  for (Local n = 0; n < Local(sheet.faces.x.extent(0)); ++n) {
    Local lowest = -1;
    int faces = 0;
    for (Local f = sheet.faces.size(); f-- > 0;)
      for (Local k = sheet.faces.offset(f); k < sheet.faces.offset(f + 1); ++k)
        if (sheet.faces.node(k) == n)
          lowest = f, ++faces;
    if (faces == 0)
      continue; // the lattice has points that this type does not use
    ties += faces > 1;
    const Vec3 above = sheet.faces.x(n) + Vec3{{0.0, 0.0, 0.2}};
    const auto point = nearest(sheet.faces, sheet.tree.view(), PointQuery{above, 1.0});
    const Line line{above, {{0.0, 0.0, -1.0}}};
    const auto hit = nearest(sheet.faces, sheet.tree.view(), LineQuery{line, 1.0});
    EXPECT_EQ(point.face, lowest);
    EXPECT_EQ(hit.face, lowest);
    EXPECT_NEAR(point.distance, 0.2, 1e-14);
    EXPECT_NEAR(hit.distance, 0.2, 1e-14);
    expect_same(point, nearest_by_trying_all(sheet.faces, PointQuery{above, 1.0}));
    expect_same(hit, nearest_by_trying_all(sheet.faces, LineQuery{line, 1.0}));
  }
  EXPECT_GT(ties, 8);
}

// On a curved sheet lines through points of shared edges hit, never fall between two faces.
TEST_P(Queries, LinesThroughEdgesAreNotMissed) {
  const Sheet sheet(GetParam(), 4, 0.1, 0.01);
  for (Local f = 0; f < sheet.faces.size(); ++f) {
    Vec3 y[fem::max_face_nodes];
    sheet.faces.coordinates(f, y);
    double from[2], to[2];
    node_parameters(GetParam(), 0, from);
    node_parameters(GetParam(), 1, to);
    for (const double t : {0.0, 0.1, 1.0 / 3.0, 0.77, 1.0}) {
      const double xi[2] = {(1 - t) * from[0] + t * to[0], (1 - t) * from[1] + t * to[1]};
      const Vec3 on_edge = place_on_face(GetParam(), y, xi);
      const Line line{on_edge + Vec3{{0.0, 0.0, 0.05}}, {{0.0, 0.0, -1.0}}};
      const auto hit = nearest(sheet.faces, sheet.tree.view(), LineQuery{line, 0.2});
      ASSERT_GE(hit.face, 0);
      EXPECT_NEAR(hit.distance, 0.05, 1e-9);
    }
  }
}

// More faces meet at the tip of a cone than a query keeps: still the lowest number is the answer.
TEST(QueriesAtTies, MoreTiesThanAreKept) {
  const int n = 3 * NearestFaces::most;
  std::vector<Vec3> x{{{0.0, 0.0, 0.1}}};
  std::vector<Local> offset{0}, node;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::acos(-1.0) * k / n;
    x.push_back({{std::cos(angle), std::sin(angle), 0.0}});
    const int face = (k * 7) % n; // numbers in no order around the tip
    for (const Local a : {0, 1 + face, 1 + (face + 1) % n})
      node.push_back(a);
    offset.push_back(static_cast<Local>(node.size()));
  }
  const std::vector<FaceType> types(std::size_t(n), FaceType::tri3);
  const Faces faces{make_view("type", types), make_view("offset", offset), make_view("node", node),
                    make_view("x", x)};
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < faces.size(); ++f) {
    Vec3 y[fem::max_face_nodes];
    faces.coordinates(f, y);
    boxes.push_back(face_box(FaceType::tri3, y));
  }
  Bvh<3> tree;
  tree.build(boxes);
  const PointQuery query{{{0.0, 0.0, 0.5}}, 1.0};
  const Nearest found = nearest(faces, tree.view(), query);
  EXPECT_EQ(found.face, 0);
  EXPECT_NEAR(found.distance, 0.4, 1e-14);
  expect_same(found, nearest_by_trying_all(faces, query));
}
