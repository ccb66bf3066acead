// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/solid/face_stiffness.hpp"
#include "abut/solid/reference_checks.hpp"
#include "small_mesh.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;
using test::all_cells;

namespace {

std::vector<Vec3> scaled(CellType type, double sx, double sy, double sz) {
  std::mt19937 engine(1);
  auto x = test::straight_nodes(type, test::distorted_corners(type, 0.0, engine));
  for (Vec3& p : x)
    p = {{sx * p[0], sy * p[1], sz * p[2]}};
  return x;
}

TEST(ReferenceChecks, VolumeIsExact) {
  for (const CellType type : all_cells) {
    const mesh::Mesh mesh = test::separate_elements(type, {scaled(type, 2, 3, 0.5)});
    const bool tet = type == CellType::tet4 || type == CellType::tet10;
    EXPECT_NEAR(element_volume(mesh, 0, 0),
                3.0 * (tet                        ? 1.0 / 6.0
                       : type == CellType::wedge6 ? 1.0
                                                  : 8.0),
                1e-13);
  }
}

TEST(ReferenceChecks, FindsMirroredElements) {
  for (const CellType type : all_cells) {
    const mesh::Mesh good = test::separate_elements(type, {scaled(type, 1, 1, 1)});
    EXPECT_TRUE(bad_elements(good).empty());
    const mesh::Mesh mesh = test::separate_elements(
        type, {scaled(type, 1, 1, 1), scaled(type, 1, -2, 1), scaled(type, 1, 1, 0)});
    const std::vector<BadElement> bad = bad_elements(mesh);
    ASSERT_EQ(bad.size(), 2u) << fem::info(type).name;
    EXPECT_EQ(bad[0].element_id, 102);
    EXPECT_NEAR(bad[0].det, -2.0, 1e-13);
    EXPECT_EQ(bad[1].element_id, 103);
    EXPECT_NEAR(bad[1].det, 0.0, 1e-15);
  }
}

// Only the last rank has a bad element; all ranks hear of it.
TEST(ReferenceChecks, ErrorNamesBlockAndElementOnAllRanks) {
  const CellType type = CellType::hex8;
  const Comm world(MPI_COMM_WORLD);
  const bool last = world.rank() == world.size() - 1;
  const mesh::Mesh mesh = test::separate_elements(
      type, {scaled(type, 1, 1, 1), scaled(type, 1, last ? -1 : 1, 1)}, MPI_COMM_WORLD);
  try {
    check_elements(mesh);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("element 102 (HEX8) of block 'body'"), std::string::npos) << what;
    EXPECT_NE(what.find("-1"), std::string::npos) << what;
  }
  EXPECT_NO_THROW(
      check_elements(test::separate_elements(type, {scaled(type, 1, 1, 1)}, MPI_COMM_WORLD)));
}

// A brick of 4 x 6 x 1: A/V is one over the depth behind the face.
TEST(FaceStiffness, ModulusAndDepth) {
  for (const CellType type : {CellType::hex8, CellType::hex20, CellType::hex27}) {
    const mesh::Mesh mesh = test::separate_elements(type, {scaled(type, 2, 3, 0.5)});
    const std::vector<mesh::Side> sides = {{0, 0, 0}, {0, 0, 1}, {0, 0, 5}};
    MaterialOptions options;
    options.young = 12.0;
    options.poisson = 0.3;
    const Material material = make_material(options);
    const double depth[] = {6.0, 4.0, 1.0};
    const FaceStiffness stiffness = face_stiffness(mesh, sides, {&material});
    const std::vector<double> base = penalty_base(mesh, sides, {&material});
    for (int f = 0; f < 3; ++f) {
      EXPECT_NEAR(stiffness.modulus[f], 12.0, 1e-12);
      EXPECT_NEAR(stiffness.inverse_depth[f], 1.0 / depth[f], 1e-14);
      EXPECT_NEAR(base[f], 12.0 / depth[f], 2e-12);
    }
    EXPECT_EQ(penalty_base(mesh, sides, {nullptr}), std::vector<double>(3, 0.0));
  }
}

// Tetrahedra: A/V = 3 / height.
TEST(FaceStiffness, Tetrahedron) {
  for (const CellType type : {CellType::tet4, CellType::tet10}) {
    const mesh::Mesh mesh = test::separate_elements(type, {scaled(type, 2, 3, 0.5)});
    const Material material = NeoHookean{1.0, 0.0}; // E = 2
    EXPECT_NEAR(penalty_base(mesh, {{0, 0, 3}}, {&material})[0], 2.0 * 3.0 / 0.5, 1e-12);
  }
}

} // namespace
