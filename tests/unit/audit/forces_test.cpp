// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <cmath>

using namespace audit_test;
using audit::Kind;

namespace {

/// Two blocks that touch, with equal and opposite forces on their corners, and what points say.
class Forces : public ::testing::Test {
protected:
  Forces() : scene(small_on_large(), pair()) {
    scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 2.0; });
    exert("lower", 0.0, -1.0);
    exert("upper", 0.0, 1.0);
    scene.beliefs[0].force = {0.0, 0.0, -4.0};
  }

  /// A force on the four nodes of a block in the corners of the small one's lower face, or those of
  /// the large one's upper face.
  void exert(const std::string& block, double along_x, double along_z) {
    const bool low = block == "lower";
    const auto& set = scene.mesh().node_sets.at(low ? "lower_top" : "upper_bottom");
    for (const Local n : set) {
      const Vec3 x = scene.present(n);
      const double half = low ? 0.5 : 0.25;
      if (n < scene.mesh().num_owned && std::fabs(std::fabs(x[0] - 0.5) - half) < 1e-9 &&
          std::fabs(std::fabs(x[1] - 0.5) - half) < 1e-9)
        scene.beliefs[0].forces.push_back({n, {{along_x, 0.0, along_z}}});
    }
  }

  void expect_only(Kind kind, double value) {
    const audit::Findings found = scene.look();
    const audit::Finding f = scene.only(found);
    EXPECT_EQ(f.kind, kind) << scene.texts(found);
    EXPECT_NEAR(f.value, value, 1e-12);
    EXPECT_EQ(f.interface, 0);
    EXPECT_NE(scene.texts(found).find("contact.pair"), std::string::npos);
  }

  Scene scene;
};

TEST_F(Forces, InBalanceAreNoFault) {
  const audit::Findings found = scene.look();
  EXPECT_TRUE(found.list.empty()) << scene.texts(found);
  EXPECT_LT(found.measures.balance, 1e-14);
  EXPECT_EQ(found.measures.tension, 0.0);
  EXPECT_EQ(found.measures.cone, 0.0);
}

TEST_F(Forces, ThatPullAreFound) {
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = p.x[0] < 0.5 ? 2.0 : -0.5; });
  expect_only(Kind::tension, 0.25);
  scene.beliefs[0].may_pull = true;
  EXPECT_TRUE(scene.look().list.empty());
}

TEST_F(Forces, BeyondTheConeAreFound) {
  scene.beliefs[0].friction = 0.3;
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 2.0, p.shear = 0.6; });
  EXPECT_TRUE(scene.look().list.empty());
  scene.believe(
      0, [](audit::BelievedPoint& p) { p.pressure = 2.0, p.shear = p.x[1] < 0.5 ? 0.6 : 0.8; });
  expect_only(Kind::cone, 0.1);
  EXPECT_GT(scene.only(scene.look()).place[1], 0.5);
}

TEST_F(Forces, WithShearButWithoutFrictionAreFound) {
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 2.0, p.shear = 0.02; });
  expect_only(Kind::cone, 0.01);
}

TEST_F(Forces, OfOpenPointsWithShearAreFound) {
  scene.beliefs[0].friction = 0.3;
  scene.believe(0, [](audit::BelievedPoint& p) {
    p.pressure = p.x[0] < 0.5 ? 2.0 : 0.0;
    p.shear = p.x[0] < 0.5 ? 0.0 : 0.1;
  });
  expect_only(Kind::cone, 0.05);
}

TEST_F(Forces, OfTiesHaveNeitherConeNorTensionToKeep) {
  scene.believe(0,
                [](audit::BelievedPoint& p) { p.held = true, p.pressure = -1.0, p.shear = 5.0; });
  EXPECT_TRUE(scene.look().list.empty());
}

TEST_F(Forces, ThatAreNotOppositeAreFound) {
  exert("upper", 0.0, 0.4); // 1.6 too much, sizes 4 + 4 + 1.6
  expect_only(Kind::force, 1.6 / 9.6);
}

/// Equal and opposite, but the one beside the other.
TEST_F(Forces, ThatLeaveAMomentAreFound) {
  scene.move("upper", {{0.2, 0.0, 0.0}});
  const audit::Findings found = scene.look();
  const audit::Finding f = scene.only(found);
  EXPECT_EQ(f.kind, Kind::moment) << scene.texts(found);
  // Moment 4 x 0.2 about y; sizes 8; the farthest node from the common center (0.6, 0.5).
  EXPECT_NEAR(f.value, 0.8 / (8.0 * std::hypot(0.6, 0.5)), 1e-12);
}

/// Shear on both sides of a gap is a couple that no law avoids.
TEST_F(Forces, AcrossAGapMayLeaveTheCoupleOfTheirShear) {
  scene.beliefs[0].friction = 1.0;
  scene.move("upper", {{0.0, 0.0, 0.05}});
  exert("lower", 0.3, 0.0);
  exert("upper", -0.3, 0.0);
  scene.beliefs[0].force = {1.2, 0.0, -4.0};
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 2.0, p.gap = 0.05, p.shear = 0.6; });
  EXPECT_TRUE(scene.look().list.empty());
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 2.0; });
  EXPECT_EQ(scene.only(scene.look()).kind, Kind::moment);
}

TEST_F(Forces, ThatTheInterfaceReportsOtherwiseAreFound) {
  scene.beliefs[0].force = {0.0, 0.0, -3.0};
  expect_only(Kind::believed_force, 1.0 / 8.0);
}

TEST_F(Forces, OfAnInterfaceThatExertsNoneAreNoFault) {
  scene.beliefs[0].forces.clear();
  scene.believe(0, [](audit::BelievedPoint& p) { p.pressure = 0.0; });
  EXPECT_TRUE(scene.look().list.empty());
}

} // namespace
