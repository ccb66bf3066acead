// SPDX-License-Identifier: BSD-3-Clause
// A host without decks: options filled by hand, on a mesh of its own.
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/rigid/assign_nodes.hpp"
#include "abut/scene/contact_fields.hpp"
#include "abut/scene/results.hpp"
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

std::shared_ptr<const mesh::Mesh> make_mesh(double gap = -0.01) {
  const Comm comm(MPI_COMM_WORLD);
  meshgen::BlockPairOptions o;
  o.gap = gap;
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

/// Another contact, like the first.
contact::ContactOptions& add_contact(scene::Options& options, const char* name) {
  options.contact.push_back(options.contact[0]);
  options.contact.back().name = name;
  return options.contact.back();
}

/// The scene with contact evaluated where it starts.
scene::Scene at_rest(const scene::Options& options, PhaseTimers& timers, double gap = -0.01) {
  scene::Scene s = scene::build_scene(options, make_mesh(gap), timers, where);
  Vector x(s.equations->dofs().map()), f(x.getMap());
  s.equations->residual(x, f);
  return s;
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
  EXPECT_THAT(message_of([&] { scene::require_supports(options, s, x, where); }),
              HasSubstr("options.bodies.upper: body 'upper' is free to move"));
}

TEST(Scene, ShowsContactOnBothSides) {
  PhaseTimers timers;
  const scene::Options options = two_blocks();
  const scene::Scene s = at_rest(options, timers);
  const scene::ContactFields fields = scene::contact_fields(*s.mesh, s.contacts);
  Global touching[2] = {0, 0};
  for (std::size_t n = 0; n < fields.pressure.size(); ++n)
    if (fields.pressure[n] > 0.0) {
      const bool above = s.mesh->x[3 * n + 2] < 0.0; // they overlap
      ++touching[above];
      EXPECT_NEAR(fields.gap[n], -0.01, 1e-12);
      EXPECT_EQ(fields.status[n], 1.0);
      EXPECT_NEAR(fields.traction[3 * n + 2], (above ? 1.0 : -1.0) * fields.pressure[n],
                  1e-12 * fields.pressure[n]);
    }
  EXPECT_EQ(s.mesh->comm.sum(touching[0]), 9); // the same on any number of ranks
  EXPECT_EQ(s.mesh->comm.sum(touching[1]), 16);
}

TEST(Scene, ContactThatPressesNowhereChangesNoField) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  options.contact[0].friction = 0.5;
  const scene::Scene one = at_rest(options, timers);
  const scene::ContactFields alone = scene::contact_fields(*one.mesh, one.contacts);
  const char* const others[][2] = {{"upper_bottom", "lower_x0"}, // the same faces
                                   {"upper_x1", "lower_x0"},     // faces that share an edge
                                   {"lower_y0", "lower_x0"}};
  for (const auto& sides : others) {
    scene::Options both = options;
    auto& other = add_contact(both, "other");
    other.primary = sides[0];
    other.secondary = sides[1];
    const scene::Scene two = at_rest(both, timers);
    ASSERT_EQ(two.contacts[1]->summary().active_points, 0);
    const scene::ContactFields fields = scene::contact_fields(*two.mesh, two.contacts);
    EXPECT_EQ(fields.pressure, alone.pressure);
    EXPECT_EQ(fields.traction, alone.traction);
    EXPECT_EQ(fields.status, alone.status);
  }
}

TEST(Scene, ContactOutsideItsWindowChangesNoField) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  const scene::Scene one = at_rest(options, timers, 0.02);
  const scene::ContactFields alone = scene::contact_fields(*one.mesh, one.contacts);
  add_contact(options, "later").window.from = 0.5;
  const scene::Scene two = at_rest(options, timers, 0.02);
  const scene::ContactFields fields = scene::contact_fields(*two.mesh, two.contacts);
  EXPECT_EQ(fields.gap, alone.gap);
  double most = 0.0;
  for (const double gap : fields.gap)
    most = std::max(most, gap);
  EXPECT_NEAR(two.mesh->comm.max(most), 0.02, 1e-12);
}

TEST(Scene, AddsWhatSeveralContactsExert) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  options.contact[0].penalty = 10.0;
  const scene::Scene one = at_rest(options, timers);
  const scene::ContactFields whole = scene::contact_fields(*one.mesh, one.contacts);
  options.contact[0].penalty = 3.0;
  add_contact(options, "other").penalty = 7.0;
  const scene::Scene two = at_rest(options, timers);
  const scene::ContactFields fields = scene::contact_fields(*two.mesh, two.contacts);
  double most = 0.0;
  for (std::size_t n = 0; n < whole.pressure.size(); ++n) {
    most = std::max(most, whole.pressure[n]);
    EXPECT_NEAR(fields.pressure[n], whole.pressure[n], 1e-13);
    EXPECT_NEAR(fields.gap[n], whole.gap[n], 1e-15);
    for (std::size_t i = 3 * n; i < 3 * n + 3; ++i)
      EXPECT_NEAR(fields.traction[i], whole.traction[i], 1e-13);
  }
  EXPECT_GT(two.mesh->comm.max(most), 0.09);
}

TEST(Scene, TwoPassesShowTheWholePressure) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  options.contact[0].penalty = 10.0;
  options.contact[0].two_pass = true;
  const scene::Scene s = at_rest(options, timers);
  const scene::ContactFields fields = scene::contact_fields(*s.mesh, s.contacts);
  double sum = 0.0, count = 0.0;
  for (const double p : fields.pressure)
    if (p > 0.0)
      sum += p, count += 1.0;
  EXPECT_EQ(s.mesh->comm.sum(count), 25.0);
  EXPECT_NEAR(s.mesh->comm.sum(sum) / 25.0, 0.1, 0.005); // the transferred half is uneven
}

TEST(Scene, RefusesTwoThatWouldWriteOneVariable) {
  PhaseTimers timers;
  const auto mesh = make_mesh();
  scene::Options options = two_blocks();
  options.contact[0].two_pass = true;
  add_contact(options, "pair_second_pass");
  EXPECT_THAT(message_of([&] { scene::build_scene(options, mesh, timers, where); }),
              HasSubstr("options.contact.pair_second_pass: its 'pair_second_pass_force_x' in the "
                        "results would have the name of that of contact.pair_second_pass"));
}

TEST(Scene, RefusesNamesThatNoFileHolds) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  options.contact[0].name = std::string(260, 'n');
  EXPECT_THAT(message_of([&] { scene::build_scene(options, make_mesh(), timers, where); }),
              HasSubstr("would be 268 characters long: expected at most 255"));
}

TEST(Scene, ContactAndBodyOfOneNameWriteVariablesOfTheirOwn) {
  PhaseTimers timers;
  scene::Options options = two_blocks();
  options.bodies[0].rigid = true;
  options.bodies[0].material.clear();
  options.displacements.erase(options.displacements.begin());
  options.contact[0].name = "lower";
  const scene::Scene s = at_rest(options, timers);
  const std::vector<std::string> names = scene::result_names(s, {}).global;
  for (const char* name : {"lower_force_x", "lower_body_force_x", "lower_body_rotation_z"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  const scene::State state = scene::make_state(s, Vector(s.equations->dofs().map()), 0.0, {});
  EXPECT_EQ(scene::result_step(s, state, {}).global.size(), names.size());
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
