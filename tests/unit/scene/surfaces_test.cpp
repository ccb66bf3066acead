// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/sides.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/scene/surfaces.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace abut;

namespace {

std::string where(const std::string& path) {
  return "options." + path;
}

/// Body `both` of two blocks; the upper one has number 2.
struct Scene {
  scene::Options options;
  mesh::MeshData mesh = meshgen::block_pair({});

  Scene() {
    options.bodies.resize(2);
    options.bodies[0].name = "both";
    options.bodies[0].blocks = {"lower", "2"};
    options.bodies[1].name = "cap";
  }
  scene::SurfaceOptions& add(const std::string& name) {
    options.surfaces.emplace_back().name = name;
    return options.surfaces.back();
  }
  std::size_t size(const std::string& name) const { return mesh.side_sets.at(name).size(); }
  std::string error() {
    try {
      scene::add_surfaces(options, mesh, where);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }
};

TEST(Surfaces, OfBlocksBodiesAndEachOther) {
  Scene s;                                       // 2 x 2 x 2 and 3 x 3 x 3 elements
  s.add("rest").subtract = {"top", "lower_top"}; // made before what it is made of
  s.add("of_block").blocks = {"2"};
  s.add("of_body").body = "both";
  s.options.surfaces.reserve(6);
  scene::SurfaceOptions& top = s.add("top");
  top.part_of = "of_block";
  top.selection.normal = mesh::NormalOptions{{0.0, 0.0, 1.0}, 30.0};
  s.add("joined").join = {"top", "lower_top"};
  ASSERT_EQ(s.error(), "no error");
  EXPECT_EQ(s.size("of_block"), 6u * 9u);
  EXPECT_EQ(s.size("of_body"), 6u * 9u + 6u * 4u);
  EXPECT_EQ(s.size("top"), 9u);
  EXPECT_EQ(s.size("joined"), 9u + 4u);
  EXPECT_EQ(s.size("rest"), 6u * 9u + 6u * 4u - 13u);
  EXPECT_EQ(s.mesh.node_sets.at("top").size(), 16u);
}

TEST(Surfaces, FacesBetweenBlocksThatShareNodesAreInside) {
  Scene s;
  mesh::BlockData half = s.mesh.blocks[0];
  half.name = "half";
  half.id = 7;
  const auto middle = std::ptrdiff_t(half.nodes.size() / 2);
  half.nodes.erase(half.nodes.begin(), half.nodes.begin() + middle);
  s.mesh.blocks[0].nodes.resize(std::size_t(middle));
  s.mesh.blocks.push_back(half);
  s.mesh.side_sets.clear();
  s.add("half_").blocks = {"half"};
  ASSERT_EQ(s.error(), "no error");
  EXPECT_EQ(s.size("half_"), 4u + 4u * 2u); // a layer of 2 x 2 without its lower side
}

TEST(Surfaces, ErrorsNameKeyAndNearestWord) {
  const auto error = [](auto change) {
    Scene s;
    change(s.add("s"), s);
    return s.error();
  };
  EXPECT_EQ(error([](auto& o, Scene&) { o.blocks = {"uper"}; }),
            "options.surfaces.s.blocks: the mesh has no block 'uper'; valid: lower, upper; did you "
            "mean 'upper'?");
  EXPECT_EQ(error([](auto& o, Scene& s) {
              s.mesh.side_sets = {{"upper_top", {}}};
              o.join = {"uper_top"};
            }),
            "options.surfaces.s.join: the mesh has no side set or surface 'uper_top'; valid: "
            "upper_top, s; did you mean 'upper_top'?");
  EXPECT_EQ(error([](auto& o, Scene& s) {
              s.mesh.node_sets = {{"rim", {}}};
              o.selection.node_set = "rin";
            }),
            "options.surfaces.s.node_set: the mesh has no node set 'rin'; valid: rim; did you mean "
            "'rim'?");
  EXPECT_EQ(error([](auto& o, Scene& s) {
              o.join = {"t"};
              s.add("t").subtract = {"s"};
            }),
            "options.surfaces.t.subtract: 's' is itself made of this surface");
  EXPECT_EQ(error([](auto& o, Scene&) { o.body = "cap"; }),
            "options.surfaces.s.body: body 'cap' has no blocks");
  EXPECT_EQ(error([](auto& o, Scene&) {
              o.name = "upper_top";
              o.blocks = {"upper"};
            }),
            "options.surfaces.upper_top: the mesh has a side set of this name");
}

TEST(Surfaces, AnEmptyOneTellsWhatLeftNothing) {
  Scene s;
  scene::SurfaceOptions& o = s.add("s");
  o.body = "both";
  o.selection.normal = mesh::NormalOptions{{0.0, 0.0, 1.0}, 30.0};
  o.selection.plane = mesh::PlaneOptions{{0.0, 0.0, 1.25}, {0.0, 0.0, 1.0}};
  EXPECT_EQ(s.error(),
            "options.surfaces.s: no face is left: 78 outer faces, 78 of the body, 0 near "
            "the plane (the nearest face keeps within 0.25 of it), 0 with the normal");
}

} // namespace
