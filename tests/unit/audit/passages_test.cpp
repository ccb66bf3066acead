// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <cmath>

using namespace audit_test;
using audit::Cause;
using audit::Kind;

namespace {

mesh::MeshData plate_and_ball() {
  return both(block("plate", {2, 2, 0.1}, {4, 4, 1}, {-1, -1, -0.1}),
              block("ball", {0.5, 0.5, 0.5}, {2, 2, 2}, {-0.25, -0.25, 0.02}));
}

void expect_passage(Scene& s, Cause cause) {
  const audit::Findings found = s.look();
  const audit::Finding f = s.only(found);
  EXPECT_EQ(f.kind, Kind::passage) << s.texts(found);
  EXPECT_EQ(f.cause, cause);
  EXPECT_NEAR(f.value, 0.5 / 0.8 * std::hypot(0.8, 0.01), 1e-9); // the plate through the ball
  EXPECT_EQ(found.measures.unseen_overlap, f.value);
  EXPECT_EQ(found.measures.overlap, 0.0);
  EXPECT_NE(s.texts(found).find("went through"), std::string::npos);
}

TEST(Passages, ThroughAPlateInOneStepAreFound) {
  Scene s(plate_and_ball(), {{"pair", "ball_z0", "plate_z1"}});
  s.begin_step();
  s.move("ball", {{0.01, 0.0, -0.8}});
  expect_passage(s, Cause::step);
}

TEST(Passages, OfBodiesWithoutAPairAreFound) {
  Scene s(plate_and_ball());
  s.begin_step();
  s.move("ball", {{0.01, 0.0, -0.8}});
  expect_passage(s, Cause::no_contact);
}

/// The plate moves and the ball rests; the frame of the way does not matter.
TEST(Passages, OfAPlateThatMovesAreFound) {
  Scene s(plate_and_ball());
  s.begin_step();
  s.move("plate", {{0.01, 0.0, 0.8}});
  expect_passage(s, Cause::no_contact);
}

/// Both go the same way; the one goes round the other; the one comes back out where it went in.
TEST(Passages, OfBodiesThatStayOnTheirSidesAreNone) {
  Scene together(plate_and_ball());
  together.begin_step();
  together.move("plate", {{0.0, 0.0, -5.0}});
  together.move("ball", {{0.0, 0.0, -5.0}});
  EXPECT_TRUE(together.look().list.empty());
  Scene away(plate_and_ball());
  away.begin_step();
  away.move("ball", {{5.0, 0.0, 3.0}});
  EXPECT_TRUE(away.look().list.empty());
  Scene out(plate_and_ball());
  out.move("ball", {{0.0, 0.0, -0.05}});
  out.begin_step();
  out.move("ball", {{0.3, 0.0, 2.0}});
  EXPECT_TRUE(out.look().list.empty());
}

/// The step begins anew: what was passed before is not told again.
TEST(Passages, AreOfOneStep) {
  Scene s(plate_and_ball());
  s.begin_step();
  s.move("ball", {{0.0, 0.0, -0.8}});
  EXPECT_EQ(s.look().list.size(), 1u);
  s.begin_step();
  s.move("ball", {{0.0, 0.0, -0.1}});
  EXPECT_TRUE(s.look().list.empty());
}

/// A pin that turns by a right angle in its bearing, and a bearing that turns about its pin: nodes
/// do not go on straight ways, and nothing passes.
TEST(Passages, OfTurningBodiesAreNone) {
  meshgen::RingsOptions o;
  o.inner_radius = 0.2;
  o.gap = 0.01;
  for (const char* turned : {"inner", "outer"})
    for (const double angle : {0.5, 1.5}) {
      Scene s(meshgen::rings(o));
      s.begin_step();
      s.move(turned, [&](const Vec3& x) {
        const double c = std::cos(angle), d = std::sin(angle);
        return Vec3{{c * x[0] - d * x[1] - x[0], d * x[0] + c * x[1] - x[1], 0.0}};
      });
      const audit::Findings found = s.look();
      EXPECT_TRUE(found.list.empty()) << turned << angle << s.texts(found);
    }
}

} // namespace
