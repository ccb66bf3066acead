// SPDX-License-Identifier: BSD-3-Clause
// A host without decks: options filled by hand, on a mesh of its own.
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/rigid/assign_nodes.hpp"
#include "abut/scene/contact_fields.hpp"
#include "abut/scene/scene.hpp"
#include "abut/scene/state.hpp"
#include "abut/scene/supports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

/// Two elastic blocks that overlap by 0.01, the lower one held from below, the upper one only by
/// contact and along x.
scene::Options two_blocks() {
  scene::Options o;
  o.materials.resize(1);
  o.materials[0].name = "rubber";
  o.materials[0].young = 2.0;
  o.materials[0].poisson = 0.3;
  for (const char* name : {"lower", "upper"}) {
    scene::BodyOptions& body = o.bodies.emplace_back();
    body.name = name;
    body.blocks = {name};
    body.material = "rubber";
  }
  const auto hold = [&](const char* set, std::array<bool, 3> components) {
    scene::DisplacementOptions& d = o.displacements.emplace_back();
    d.name = d.set = set;
    d.components = components;
  };
  hold("lower_bottom", {true, true, true});
  hold("upper_x0", {true, false, false});
  contact::ContactOptions& c = o.contact.emplace_back();
  c.name = "pair";
  c.primary = "upper_bottom";
  c.secondary = "lower_top";
  return o;
}

std::shared_ptr<const mesh::Mesh> make_mesh() {
  const Comm comm(MPI_COMM_WORLD);
  meshgen::BlockPairOptions o;
  o.gap = -0.01;
  return std::make_shared<const mesh::Mesh>(
      mesh::distribute(comm.is_root() ? meshgen::block_pair(o) : mesh::MeshData{}, comm));
}

std::string where(const std::string& path) {
  return "options." + path;
}

template <class Work> std::string message_of(const Work& work) {
  try {
    work();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST(Scene, NamesWhatNothingHolds) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  scene::Scene s = scene::build_scene(options, make_mesh(), timers, where);
  Vector x(s.equations->dofs().map()), f(x.getMap());
  s.equations->residual(x, f);
  const auto free = scene::free_pieces(options, s);
  ASSERT_EQ(free.size(), 1U); // contact holds z and the rotations about x and y; x0 that about z
  EXPECT_EQ(free[0].body, "upper");
  EXPECT_THAT(free[0].motions, ElementsAre("translation along y"));
  EXPECT_THAT(message_of([&] { scene::require_supports(options, s, where); }),
              HasSubstr("options.bodies.upper: body 'upper' is free to move"));
}

TEST(Scene, AveragesPressureOnThePrimarySide) {
  PhaseTimers timers;
  const scene::Options options = two_blocks();
  scene::Scene s = scene::build_scene(options, make_mesh(), timers, where);
  Vector x(s.equations->dofs().map()), f(x.getMap());
  s.equations->residual(x, f);
  const scene::State state = scene::make_state(s, x, 0.0, {});
  ASSERT_GT(state.contacts.at(0).active_points, 0);
  const scene::ContactFields fields = scene::contact_fields(*s.mesh, s.contacts);
  Global touching = 0;
  for (std::size_t n = 0; n < fields.pressure.size(); ++n)
    if (fields.pressure[n] > 0.0) {
      ++touching;
      EXPECT_NEAR(fields.gap[n], -0.01, 1e-12);
      EXPECT_NEAR(fields.traction[3 * n + 2], fields.pressure[n], 1e-12 * fields.pressure[n]);
    }
  EXPECT_EQ(s.mesh->comm.sum(touching), 16); // 3 x 3 faces, the same on any number of ranks
}

TEST(Scene, NamesTheOptionThatDoesNotFit) {
  PhaseTimers timers;
  const auto mesh = make_mesh();
  const auto message = [&](const scene::Options& options) {
    return message_of([&] { scene::build_scene(options, mesh, timers, where); });
  };
  scene::Options options = two_blocks();
  options.contact[0].primary = "upper_botom";
  EXPECT_THAT(message(options), HasSubstr("options.contact.pair.primary: the mesh has no side set "
                                          "'upper_botom'"));
  options = two_blocks();
  options.bodies.pop_back();
  EXPECT_THAT(message(options), HasSubstr("block 'upper' of the mesh belongs to no body"));
  options = two_blocks();
  options.displacements.push_back(options.displacements[1]);
  options.displacements[2].name = "pull";
  options.displacements[2].values[0] = 0.5;
  EXPECT_THAT(message(options), HasSubstr("options.displacements.pull: node"));
  options = two_blocks();
  options.bodies[1].rigid = true;
  EXPECT_THAT(message(options), HasSubstr("moves with rigid body 'upper', which alone prescribes"));
}

TEST(AssignNodes, ABlockOnAnyRankGivesItsNodes) {
  const auto mesh = make_mesh();
  const std::vector<rigid::BodyNodes> bodies{{"plate", {}, {"lower_bottom"}}, {"top", {1}, {}}};
  const std::vector<int> body = rigid::assign_nodes(*mesh, bodies, where);
  Global count[2] = {0, 0};
  for (Local n = 0; n < mesh->num_local(); ++n) {
    const double z = mesh->x[3 * std::size_t(n) + 2];
    EXPECT_EQ(body[std::size_t(n)], z < -1.0 + 1e-12 ? 0 : z > -0.01 - 1e-12 && z != 0.0 ? 1 : -1);
    if (n < mesh->num_owned && body[std::size_t(n)] >= 0)
      ++count[body[std::size_t(n)]];
  }
  EXPECT_EQ(mesh->comm.sum(count[0]), 9);
  EXPECT_EQ(mesh->comm.sum(count[1]), 64);
  EXPECT_THAT(message_of([&] {
                rigid::assign_nodes(*mesh, {{"plate", {}, {"upper_top"}}, {"top", {1}, {}}}, where);
              }),
              HasSubstr("options.bodies.top: node"));
}
