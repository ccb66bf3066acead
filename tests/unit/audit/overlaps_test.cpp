// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <cmath>

using namespace audit_test;
using audit::Cause;
using audit::Kind;

namespace {

constexpr double deep = 0.06; // of faces of size 0.25

void expect_overlap(const Scene& s, const audit::Findings& found, Cause cause, double depth) {
  const audit::Finding f = s.only(found);
  EXPECT_EQ(f.kind, Kind::overlap) << s.texts(found);
  EXPECT_EQ(f.cause, cause) << s.texts(found);
  EXPECT_NEAR(f.value, depth, 1e-12);
  EXPECT_NEAR(found.measures.overlap, depth, 1e-12);
  EXPECT_NEAR(found.measures.unseen_overlap, depth, 1e-12);
  EXPECT_NE(s.texts(found), "");
}

void expect_nothing(const Scene& s, const audit::Findings& found) {
  EXPECT_TRUE(found.list.empty()) << s.texts(found);
  EXPECT_EQ(found.measures.unseen_overlap, 0.0);
}

TEST(Overlaps, TouchingOrOpenBodiesHaveNone) {
  for (const double gap : {0.0, 1e-6, 0.3}) {
    Scene s(small_on_large());
    s.move("upper", {{0.0, 0.0, gap}});
    const audit::Findings found = s.look();
    expect_nothing(s, found);
    EXPECT_NEAR(found.measures.overlap, 0.0, 1e-15);
  }
}

TEST(Overlaps, OfTwoBodiesWithoutAPairIsFound) {
  for (const auto element : {fem::CellType::hex8, fem::CellType::hex20, fem::CellType::hex27,
                             fem::CellType::tet4, fem::CellType::tet10, fem::CellType::wedge6}) {
    Scene s(small_on_large(element));
    s.move("upper", {{0.0, 0.0, -deep}});
    const audit::Findings found = s.look();
    expect_overlap(s, found, Cause::no_contact, deep);
    const audit::Finding f = s.only(found);
    EXPECT_EQ(f.body[0] + f.body[1], 1); // each is in the other
    EXPECT_NEAR(f.place[2], f.body[0] == 1 ? -deep : 0.0, 1e-12);
    EXPECT_NE(s.texts(found).find("no contact joins these bodies"), std::string::npos);
  }
}

TEST(Overlaps, AreMeasuredInSizesOfTheSmallerFace) {
  Scene s(small_on_large());
  s.move("upper", {{0.0, 0.0, -deep}});
  EXPECT_NEAR(s.look().measures.overlap_over_face_size, deep / 0.25, 1e-12);
}

/// A corner of the upper block hangs down between the points of the one face below, which see
/// nothing before them.
TEST(Overlaps, OfACornerBetweenPointsIsFound) {
  Scene s(small_on_large(), pair());
  s.move("upper", [](const Vec3& x) {
    const bool hangs = x[0] < 0.3 && x[1] < 0.3 && x[2] < 0.1;
    return Vec3{{0.0, 0.0, hangs ? -deep : 0.01}};
  });
  s.believe(0, [](audit::BelievedPoint& p) { p.paired = false; });
  const audit::Findings found = s.look();
  expect_overlap(s, found, Cause::no_partner, deep);
  EXPECT_NEAR(s.only(found).place[0], 0.25, 1e-12);
  EXPECT_NE(s.texts(found).find("contact.pair sees nothing"), std::string::npos);
}

/// A spike of the lower block in the middle of the face above.
TEST(Overlaps, OfASpikeUnderAFaceIsFound) {
  const mesh::MeshData blocks = both(block("low", {1, 1, 1}, {2, 2, 1}, {0, 0, -1}),
                                     block("up", {1, 1, 1}, {1, 1, 1}, {0, 0, 0.01}));
  Scene s(blocks, {{"pair", "up_z0", "low_z1"}});
  s.move("low", [](const Vec3& x) {
    const bool spike = std::fabs(x[0] - 0.5) + std::fabs(x[1] - 0.5) < 0.1 && x[2] > -0.1;
    return Vec3{{0.0, 0.0, spike ? 0.09 : 0.0}};
  });
  s.believe(0, [](audit::BelievedPoint& p) { p.gap = 0.005; });
  const audit::Findings found = s.look();
  expect_overlap(s, found, Cause::open, 0.08);
  EXPECT_NE(s.texts(found).find("believes in a gap of 0.005"), std::string::npos);
}

TEST(Overlaps, ThatAnInterfaceKnowsOfAreNone) {
  Scene s(small_on_large(), pair());
  s.move("upper", {{0.0, 0.0, -deep}});
  s.believe(0, [](audit::BelievedPoint& p) { p.gap = -deep, p.pressure = 1.0; });
  const audit::Findings found = s.look();
  expect_nothing(s, found);
  EXPECT_NEAR(found.measures.overlap, deep, 1e-12);
}

TEST(Overlaps, BeyondWhatAnInterfaceKnowsAreFound) {
  Scene s(small_on_large(), pair());
  s.move("upper", {{0.0, 0.0, -deep}});
  s.believe(0, [](audit::BelievedPoint& p) { p.gap = -0.5 * deep, p.pressure = 1.0; });
  const audit::Findings found = s.look();
  expect_overlap(s, found, Cause::less, deep);
  EXPECT_NE(s.texts(found).find("knows of 0.03 only"), std::string::npos);
}

TEST(Overlaps, OfTiedPointsAreMeant) {
  Scene s(small_on_large(), pair());
  s.move("upper", {{0.0, 0.0, -deep}});
  s.believe(0, [](audit::BelievedPoint& p) { p.held = true; });
  expect_nothing(s, s.look());
}

/// The interface has the back of the lower block instead of its top.
TEST(Overlaps, OfFacesThatTheInterfaceDoesNotHaveAreFound) {
  Scene s(small_on_large(), {{"pair", "lower_bottom", "upper_bottom"}});
  s.move("upper", {{0.0, 0.0, -deep}});
  s.believe(0, [](audit::BelievedPoint& p) { p.paired = false; });
  const audit::Findings found = s.look();
  expect_overlap(s, found, Cause::other_faces, deep);
  EXPECT_NE(s.texts(found).find("but not these faces"), std::string::npos);
}

TEST(Overlaps, OfAnInterfaceAtRestAreFound) {
  Scene s(small_on_large(), pair());
  s.move("upper", {{0.0, 0.0, -deep}});
  s.beliefs[0].acts = false;
  s.believe(0, [](audit::BelievedPoint& p) { p.paired = false; });
  expect_overlap(s, s.look(), Cause::rests, deep);
}

TEST(Overlaps, FarFromAllPointsAreFound) {
  Scene s(small_on_large(), pair());
  s.move("upper", {{0.0, 0.0, -deep}});
  expect_overlap(s, s.look(), Cause::no_point, deep);
}

/// One interface knows, another one does not: that is enough.
TEST(Overlaps, NeedBeKnownByOneInterfaceOnly) {
  Scene s(small_on_large(),
          {{"blind", "lower_top", "upper_bottom"}, {"other", "lower_top", "upper_bottom"}});
  s.move("upper", {{0.0, 0.0, -deep}});
  s.believe(1, [](audit::BelievedPoint& p) { p.gap = -deep, p.pressure = 1.0; });
  expect_nothing(s, s.look());
}

/// Beams across each other: edges cut edges, and no node is in anything.
TEST(Overlaps, OfEdgesAcrossEachOtherAreFound) {
  const double depth = 0.08;
  const mesh::MeshData beams = both(block("low", {8, 1, 1}, {1, 1, 1}, {0, 0, -1}),
                                    block("up", {1, 8, 1}, {1, 1, 1}, {1.7, -3.4, -depth}));
  Scene s(beams);
  const audit::Findings found = s.look();
  expect_overlap(s, found, Cause::no_contact, depth);
  // Both turned to lie on an edge, so that a bit of two edges is all that meets.
  Scene t(both(block("low", {1, 1, 1}, {1, 1, 1}, {0, -0.5, -0.5}),
               block("up", {1, 1, 1}, {1, 1, 1}, {0.04, -0.53, -0.5})));
  const double h = std::sqrt(0.5), lift = 2.0 * h - 0.2;
  t.move("low", [&](const Vec3& x) {
    return Vec3{{0.0, h * (x[1] - x[2]) - x[1], h * (x[1] + x[2]) - x[2]}};
  });
  t.move("up", [&](const Vec3& x) {
    const double a = x[0] - 0.54;
    return Vec3{{h * (a - x[2]) - a, 0.0, h * (a + x[2]) - x[2] + lift}};
  });
  const audit::Findings edges = t.look();
  EXPECT_EQ(t.only(edges).cause, Cause::no_contact);
  EXPECT_GT(edges.measures.unseen_overlap, (0.2 - 1.0 / 16.0) * h);
  EXPECT_LE(edges.measures.unseen_overlap, 0.2 * h + 1e-12);
}

/// A bar bent to a ring whose ends go into each other.
TEST(Overlaps, OfABodyWithItselfAreFound) {
  const int n = 24;
  const auto bend = [&](double angle) {
    return [=](const Vec3& x) {
      const double a = angle * x[0] / n, r = 4.0 + x[1];
      return Vec3{{r * std::sin(a) - x[0], r * std::cos(a) - x[1], 0.0}};
    };
  };
  Scene open(block("bar", {double(n), 1, 1}, {n, 1, 1}, {0, 0, 0}));
  open.move("bar", bend(6.0));
  expect_nothing(open, open.look());
  Scene closed(block("bar", {double(n), 1, 1}, {n, 1, 1}, {0, 0, 0}));
  closed.move("bar", bend(6.6));
  const audit::Findings found = closed.look();
  const audit::Finding f = closed.only(found);
  EXPECT_EQ(f.body[0], f.body[1]);
  EXPECT_EQ(f.cause, Cause::no_contact);
  // The ends pass each other by 0.317 rad on radii 4 to 5; nearest skin: that or the sides.
  EXPECT_GT(found.measures.unseen_overlap, 0.3);
  EXPECT_NE(closed.texts(found).find("into itself"), std::string::npos);
}

/// More than half of a plate is passed: the depth is that from the face of entry.
TEST(Overlaps, OfAThinPlateCountFromTheFaceOfEntry) {
  Scene s(both(block("plate", {1, 1, 0.1}, {4, 4, 1}, {0, 0, -0.1}),
               block("foot", {0.5, 0.5, 0.5}, {2, 2, 2}, {0.25, 0.25, -0.08})));
  const audit::Findings found = s.look();
  const audit::Finding f = s.only(found);
  EXPECT_NEAR(f.value, 0.08, 1e-12) << s.texts(found);
}

TEST(Overlaps, OfOneFrameAreMeantOfTwoAreNot) {
  for (const bool same : {true, false}) {
    Scene s(small_on_large());
    s.fix("lower", 0);
    s.fix("upper", same ? 0 : 1);
    s.move("upper", {{0.0, 0.0, -deep}});
    const audit::Findings found = s.look();
    EXPECT_EQ(found.list.size(), same ? 0u : 1u) << s.texts(found);
  }
}

/// Facets of two rings whose nodes lie on one circle overlap by their sagittas: no fault; a whole
/// overlap of the same size is one.
TEST(Overlaps, ByTheSagittaOfFacetsAreNone) {
  meshgen::RingsOptions o;
  o.inner_theta = 4;
  o.outer_theta = 5;
  o.thickness = 0.5;
  Scene s(meshgen::rings(o));
  const audit::Findings found = s.look();
  expect_nothing(s, found);
  EXPECT_GT(found.measures.overlap, 0.01);
  o.inner_theta = 32;
  o.outer_theta = 40;
  o.gap = -found.measures.overlap;
  Scene fine(meshgen::rings(o));
  EXPECT_EQ(fine.look().list.size(), 1u);
}

TEST(Overlaps, BelowTheToleranceAreNone) {
  Scene s(small_on_large());
  s.move("upper", {{0.0, 0.0, -deep}});
  s.tolerance = 0.3;
  expect_nothing(s, s.look());
}

} // namespace
