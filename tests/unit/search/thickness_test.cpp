// SPDX-License-Identifier: BSD-3-Clause
#include "abut/search/thickness.hpp"

#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/generators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace abut;

namespace {

/// Two plates that overlap by gap < 0.
mesh::Mesh plates(double gap) {
  meshgen::BlockPairOptions o;
  o.lower_size = {2.0, 1.0, 0.3};
  o.upper_size = {1.0, 1.0, 0.5};
  o.lower_divisions = {5, 4, 3};
  o.upper_divisions = {3, 3, 2};
  o.gap = gap;
  const Comm comm(MPI_COMM_WORLD);
  return mesh::distribute(comm.is_root() ? meshgen::block_pair(o) : mesh::MeshData{}, comm);
}

void expect_thickness(const mesh::Mesh& mesh, const std::string& side_set, double expected) {
  const mesh::Surface faces = mesh::extract_surface(mesh, side_set);
  for (const double t : search::BodyThickness(mesh).behind(faces))
    EXPECT_NEAR(t, expected, 1e-12) << side_set;
  EXPECT_GT(mesh.comm.sum(Global(faces.num_faces())), 0);
}

/// Other bodies, touching or overlapping, do not end a line.
TEST(BodyThickness, IsThatOfTheBodyBehindTheFace) {
  for (const double gap : {0.0, -0.1, -0.4}) {
    const mesh::Mesh mesh = plates(gap);
    expect_thickness(mesh, "lower_top", 0.3);
    expect_thickness(mesh, "lower_bottom", 0.3);
    expect_thickness(mesh, "upper_bottom", 0.5);
    expect_thickness(mesh, "lower_x0", 2.0);
    expect_thickness(mesh, "upper_x0", 1.0);
  }
}

/// Every face of the skin once, whatever the ranks: by area.
TEST(BodyThickness, OuterSurfaceIsTheWholeSkin) {
  const mesh::Mesh mesh = plates(0.0);
  const mesh::Surface skin = mesh::outer_surface(mesh);
  EXPECT_EQ(mesh.comm.sum(Global(skin.num_faces())),
            2 * (5 * 4 + 5 * 3 + 4 * 3) + 2 * (3 * 3 + 3 * 2 + 3 * 2));
  EXPECT_TRUE(std::is_sorted(skin.face_id.begin(), skin.face_id.end()));
}

} // namespace
