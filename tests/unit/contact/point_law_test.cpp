// SPDX-License-Identifier: BSD-3-Clause
// What the tractions of a point must obey whatever the tangent: signs, balance, objectivity,
// continuity at the cone and across edges.
#include "point_on_springs.hpp"

using namespace abut;
using namespace abut::contact;
using namespace abut::contact::testing;

namespace {

struct Kind {
  bool ray;
  PointRule rule;
};
constexpr Kind objective_kinds[] = {
    {false, PointRule::frictionless},     {false, PointRule::incremental_stick},
    {false, PointRule::incremental_slip}, {false, PointRule::anchored},
    {true, PointRule::frictionless},      {true, PointRule::incremental_stick},
    {true, PointRule::incremental_slip},  {true, PointRule::anchored},
    {true, PointRule::inclined_slip}};

Case loaded(const Kind& kind, FaceType f1, FaceType f2, double multiplier = 4.0) {
  CaseOptions o;
  o.depth = 0.25;
  Case s = make_case(f1, f2, o);
  s.c.ray = kind.ray;
  s.c.rule = kind.rule;
  s.c.multiplier = multiplier;
  if (multiplier > 0.0)
    carry(s, 1.0, -0.7, 0.0);
  EXPECT_TRUE(s.find());
  EXPECT_GT(s.traction().pressure, 0.0);
  return s;
}

Vec3 total(const Case& s, bool moment) {
  const auto f = s.force();
  Vec3 sum = Vec3::zero();
  for (int a = 0; a < s.n1 + s.n2(); ++a) {
    const std::size_t i = std::size_t(3 * a);
    const Vec3 fa{{f[i], f[i + 1], f[i + 2]}};
    const Vec3& at = a < s.n1 ? s.x[std::size_t(a)] : s.y[std::size_t(a - s.n1)];
    sum += moment ? cross(at, fa) : fa;
  }
  return sum;
}

double size_of(const std::vector<double>& f) {
  double sum = 0.0;
  for (const double v : f)
    sum += v * v;
  return std::sqrt(sum);
}

Case turned(Case s, const Vec3& axis, double angle) {
  s.x = rotate(axis, angle, s.x);
  s.y = rotate(axis, angle, s.y);
  s.z = rotate(axis, angle, s.z);
  EXPECT_TRUE(s.find());
  return s;
}

std::vector<double> turned(const Vec3& axis, double angle, std::vector<double> f) {
  for (std::size_t i = 0; i < f.size(); i += 3) {
    const Vec3 v = rotate(axis, angle, Vec3{{f[i], f[i + 1], f[i + 2]}});
    for (int j = 0; j < 3; ++j)
      f[i + std::size_t(j)] = v[j];
  }
  return f;
}

/// Q K Q^T block by block: both indices turned.
std::vector<double> turned_matrix(const Vec3& axis, double angle, const std::vector<double>& k,
                                  std::size_t n) {
  std::vector<double> rows(k.size()), both(k.size());
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = turned(axis, angle, {k.begin() + long(i * n), k.begin() + long((i + 1) * n)});
    for (std::size_t j = 0; j < n; ++j)
      rows[j * n + i] = row[j]; // transposed
  }
  for (std::size_t j = 0; j < n; ++j) {
    const auto col =
        turned(axis, angle, {rows.begin() + long(j * n), rows.begin() + long((j + 1) * n)});
    for (std::size_t i = 0; i < n; ++i)
      both[i * n + j] = col[i];
  }
  return both;
}

} // namespace

// Check 7, the forces; Newton on springs is in point_history_test.
TEST(PointLaw, PushesApartAndOpposesTheSlip) {
  for (const bool ray : {false, true})
    for (const Map map : {Map::incremental, Map::inclined, Map::literal}) {
      if (!ray && map != Map::incremental)
        continue; // those maps are laws along the primary normal
      auto p = PointOnSprings::planes(0.1, map, ray);
      const Vec3 slip{{0.4, 0.3, 0.0}};
      for (Vec3& v : p.s.x)
        v += slip;
      const PointRule rule = p.decide();
      ASSERT_TRUE(rule == PointRule::incremental_slip || rule == PointRule::inclined_slip ||
                  rule == PointRule::literal_slip);
      const auto t = p.s.traction();
      // Against the outward normal of the primary: away from the secondary.
      EXPECT_LT(dot(p.s.primary().normal, t.traction), -1.0);
      EXPECT_LT(dot(p.shear(), slip), -0.5);
      EXPECT_NEAR(norm(p.shear()), 0.5 * t.pressure, 1e-13 * t.pressure);
      const auto f = p.s.force(); // internal side: minus the force on the node
      EXPECT_NEAR(f[0], -0.25 * t.weight * t.traction[0], 1e-14);
    }
}

// Check 8.
TEST(PointLaw, ForcesSumToZero) {
  for (const Kind& kind : objective_kinds)
    for (const auto& pair : pairs) {
      const Case s = loaded(kind, pair[0], pair[1]);
      EXPECT_LT(norm(total(s, false)), 2e-15 * size_of(s.force())) << int(kind.rule);
    }
}

TEST(PointLaw, MomentsOfThePenaltyLawsBalanceOrHaveTheKnownArm) {
  for (const auto& pair : pairs) {
    for (const Kind kind : {Kind{true, PointRule::anchored}, Kind{false, PointRule::anchored},
                            Kind{true, PointRule::inclined_slip}}) {
      const Case s = loaded(kind, pair[0], pair[1], 0.0);
      EXPECT_LT(norm(total(s, true)), 5e-15 * size_of(s.force()));
    }
    // Where t_T acts across the gap the couple is gap c x t_T, per point.
    for (const Kind kind :
         {Kind{true, PointRule::incremental_slip}, Kind{true, PointRule::incremental_stick},
          Kind{true, PointRule::literal_slip}, Kind{false, PointRule::incremental_slip}}) {
      const Case s = loaded(kind, pair[0], pair[1], 0.0);
      const auto t = s.traction();
      const auto partner = contact_partner(s.point(), s.primary(), s.y.data());
      const Vec3 couple = (-t.weight * t.gap) * cross(partner.c, t.traction);
      EXPECT_LT(norm(total(s, true) - couple), 5e-15 * size_of(s.force()));
      EXPECT_GT(norm(couple), 1e-3 * size_of(s.force()));
    }
  }
}

// Check 9.
TEST(PointLaw, ForceAndTangentTurnWithTheBodies) {
  const Vec3 axis{{1.0, 1.0, 1.0}};
  double force = 0.0, tangent = 0.0;
  for (const Kind& kind : objective_kinds)
    for (const auto& pair : pairs)
      for (const double multiplier : {0.0, 4.0}) {
        const Case s = loaded(kind, pair[0], pair[1], multiplier);
        const Case q = turned(s, axis, 0.3);
        force = std::max(force, distance(q.force(), turned(axis, 0.3, s.force())));
        tangent =
            std::max(tangent, distance(q.tangent(), turned_matrix(axis, 0.3, s.tangent(),
                                                                  std::size_t(3 * s.columns()))));
      }
  std::printf("  worst relative error: force %.1e, tangent %.1e\n", force, tangent);
  EXPECT_LT(force, 1e-12);
  EXPECT_LT(tangent, 1e-12);
}

TEST(PointLaw, LiteralSlipIsNotObjective) {
  const Vec3 axis{{1.0, 1.0, 1.0}};
  const Case s = loaded({true, PointRule::literal_slip}, FaceType::quad4, FaceType::quad4);
  const double error = distance(turned(s, axis, 0.3).force(), turned(axis, 0.3, s.force()));
  EXPECT_GT(error, 1e-3) << "this is why the literal law is for comparisons only";
}

TEST(PointLaw, ARigidTurnIsNoSlip) {
  for (const bool ray : {false, true})
    for (const auto& pair : pairs) {
      Case s = loaded({ray, PointRule::incremental_stick}, pair[0], pair[1], 0.0);
      s.x_previous = s.x;
      s.y_previous = s.y;
      const Case q = turned(s, {{1.0, 0.5, -0.3}}, 0.3);
      const Vec3 slip =
          objective_slip(q.point(), contact_partner(q.point(), q.primary(), q.y.data()));
      EXPECT_LT(norm(slip), 1e-14);
    }
}

// Check 10: at the limit, found by choosing the coefficient, stick and slip agree.
TEST(PointLaw, IncrementalMapIsContinuousAtTheCone) {
  double worst = 0.0;
  for (const bool ray : {false, true})
    for (const auto& pair : pairs)
      for (const double multiplier : {0.0, 4.0}) {
        Case s = loaded({ray, PointRule::incremental_stick}, pair[0], pair[1], multiplier);
        const auto partner = contact_partner(s.point(), s.primary(), s.y.data());
        s.c.friction =
            norm(incremental_trial(s.point(), s.primary(), partner)) / s.traction().pressure;
        ASSERT_GT(s.c.friction, 0.01);
        const auto stick = s.force();
        s.c.rule = PointRule::incremental_slip;
        worst = std::max(worst, distance(s.force(), stick));
      }
  std::printf("  worst relative jump: %.1e\n", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST(PointLaw, InclinedMapIsContinuousAtTheCone) {
  double worst = 0.0;
  for (const auto& pair : pairs)
    for (const double multiplier : {0.0, 4.0}) {
      Case s = loaded({true, PointRule::anchored}, pair[0], pair[1], multiplier);
      const auto stick = s.force();
      const auto t = s.traction();
      s.c.friction = norm(t.traction + t.pressure * s.primary().normal) / t.pressure;
      ASSERT_GT(s.c.friction, 0.01);
      s.c.rule = PointRule::inclined_slip;
      ASSERT_TRUE(s.find());
      EXPECT_NEAR(s.c.xi[0], s.c.anchor_xi[0], 1e-12);
      worst = std::max(worst, distance(s.force(), stick));
    }
  std::printf("  worst relative jump: %.1e\n", worst);
  EXPECT_LT(worst, 1e-12);
}

namespace {

/// Tractions on both sides of the limit of stick.
struct Limit {
  Vec3 stick, slip;
  double jump() const { return norm(slip - stick) / norm(stick); }
};

/// Moves the primary along x until stick ends, by bisection.
Limit find_limit(PointOnSprings& p) {
  const Nodes start = p.s.x;
  double low = 0.0, high = 1.0;
  Limit limit{Vec3::zero(), Vec3::zero()};
  for (int k = 0; k < 55; ++k) {
    const double middle = 0.5 * (low + high);
    for (std::size_t a = 0; a < 4; ++a)
      p.s.x[a] = start[a] + Vec3{{middle, 0.0, 0.0}};
    const PointRule rule = p.decide();
    const bool sticks = rule == PointRule::incremental_stick || rule == PointRule::anchored;
    (sticks ? low : high) = middle;
    (sticks ? limit.stick : limit.slip) = p.s.traction().traction;
  }
  return limit;
}

} // namespace

TEST(PointLaw, LiteralMapJumpsByTheFrictionTimesTheSlope) {
  for (const double degrees : {5.0, 10.0, 20.0}) {
    const double phi = degrees * std::acos(-1.0) / 180.0;
    auto p = PointOnSprings::planes(phi, Map::literal, true);
    const Limit limit = find_limit(p);
    ASSERT_GT(norm(limit.stick), 0.0);
    ASSERT_GT(norm(limit.slip), 0.0);
    const double jump = limit.jump(), law = 0.5 * std::tan(phi);
    EXPECT_NEAR(jump, law, 0.005 * law) << degrees; // three digits, as the theory's check found
  }
}

// Check 10, sheared across the step beforehand: parallel planes, .8 of the limit in y.
TEST(PointLaw, JumpAfterShearAcross) {
  for (const Map map : {Map::incremental, Map::inclined, Map::literal}) {
    auto p = PointOnSprings::planes(0.0, map, true);
    for (Vec3& v : p.s.x)
      v[1] += 0.8 * 0.5 * 0.1;
    const PointRule first = p.decide();
    ASSERT_TRUE(first == PointRule::incremental_stick || first == PointRule::anchored);
    p.end_step();
    const double jump = find_limit(p).jump();
    // At the limit the shear is mu p (.6, .8) in stick. The literal law forgets the .8: its slip of
    // .6 mu p/eps in this step gives mu p (.6, 0).
    if (map == Map::literal)
      EXPECT_NEAR(jump, 0.8 * 0.5 / std::sqrt(1.25), 1e-12);
    else
      EXPECT_LT(jump, 1e-12);
  }
}

// Check 13.
TEST(PointLaw, TensileTrialOpens) {
  for (const bool ray : {false, true})
    for (const Map map : {Map::incremental, Map::inclined, Map::literal}) {
      auto p = PointOnSprings::planes(0.1, map, ray);
      for (Vec3& v : p.s.x)
        v += Vec3{{0.01, 0.0, -0.2}};
      EXPECT_EQ(p.decide(), PointRule::open);
    }
}

// Check 4: no shear at all is stick, and slip against it is refused, not a NaN.
TEST(PointLaw, NoShearSticks) {
  for (const Map map : {Map::incremental, Map::inclined, Map::literal}) {
    auto p = PointOnSprings::planes(0.0, map, true);
    const PointRule rule = p.decide();
    EXPECT_TRUE(rule == PointRule::incremental_stick || rule == PointRule::anchored);
    EXPECT_LT(norm(p.shear()), 1e-15);
    p.s.c.rule = map == Map::inclined ? PointRule::inclined_slip : PointRule::incremental_slip;
    bool fine = true;
    for (const double v : p.s.tangent(&fine))
      ASSERT_EQ(v, 0.0);
    EXPECT_FALSE(fine);
  }
}

// Check 14: the ray's hit lies on the edge between two faces that meet at an angle; both
// give the same force, each with its own previous positions.
TEST(PointLaw, ForceIsContinuousAcrossAnEdge) {
  for (const Kind kind :
       {Kind{true, PointRule::frictionless}, Kind{true, PointRule::incremental_slip},
        Kind{true, PointRule::incremental_stick}, Kind{true, PointRule::inclined_slip}}) {
    auto p = PointOnSprings::planes(0.0, Map::inclined, true);
    Case left = p.s;
    left.c.rule = kind.rule;
    left.c.anchor_xi[0] = 0.5;
    left.c.anchor_xi[1] = 0.1;
    left.one_face = false;
    left.z = left.y;
    left.z_previous = left.y;
    const double h = -0.1;
    const auto face = [&](double x1, double h1, double x2, double h2) {
      return Nodes{{{x1, 3, h1}}, {{x2, 3, h2}}, {{x2, -3, h2}}, {{x1, -3, h1}}};
    };
    left.y = face(-3, h - 0.4, 0, h);
    Case right = left;
    right.y = face(0, h, 2.5, h + 0.7);
    for (Case* s : {&left, &right}) {
      s->y_previous = s->y;
      for (Vec3& v : s->y_previous)
        v += Vec3{{-0.03, 0.02, 0.01}};
      s->x_previous = s->x;
      for (Vec3& v : s->x_previous)
        v += Vec3{{-0.2, 0.1, 0.03}};
    }
    // Move the primary until its ray meets the edge of the left face.
    for (int k = 0; k < 60; ++k) {
      ASSERT_TRUE(left.find());
      const double away = 1.0 - left.c.xi[0];
      for (Vec3& v : left.x)
        v[0] += 1.5 * away;
    }
    ASSERT_NEAR(left.c.xi[0], 1.0, 1e-14);
    right.x = left.x;
    ASSERT_TRUE(right.find());
    ASSERT_NEAR(right.c.xi[0], -1.0, 1e-13);
    const auto a = left.traction(), b = right.traction();
    ASSERT_GT(a.pressure, 0.0);
    EXPECT_LT(norm(a.traction - b.traction), 1e-12 * norm(a.traction)) << int(kind.rule);
    EXPECT_NEAR(a.N[1], b.N[0], 1e-13); // the shared nodes carry the same shares
    EXPECT_NEAR(a.N[2], b.N[3], 1e-13);
    EXPECT_NEAR(a.N[0] + a.N[3] + b.N[1] + b.N[2], 0.0, 1e-13);
  }
}

// Check 16: the theory's tangent differentiates the way of the secondary at a fixed place.
// That is right where the secondary only translates, and wrong where it turns.
TEST(PointLaw, PrintedLiteralTangentAgreesForATranslatingSecondary) {
  for (const bool turns : {false, true}) {
    CaseOptions o;
    o.depth = 0.25;
    Case s = make_case(FaceType::quad4, FaceType::quad4, o);
    s.c.ray = true;
    s.c.rule = PointRule::literal_slip;
    if (!turns) {
      s.y_previous = s.y;
      for (Vec3& v : s.y_previous)
        v += Vec3{{0.2, -0.1, 0.05}};
    }
    ASSERT_TRUE(s.find());
    const double* fixed = s.c.xi;
    const auto printed = [&](const Case& q) {
      fem::FacePoint<double> now, then;
      const ContactPoint c = q.point();
      const auto p = q.primary();
      const auto partner = contact_partner(c, p, q.y.data());
      const auto before = primary_point(c.shape, c.x_previous);
      fem::face_point(c.face, q.y.data(), fixed, now);
      fem::face_point(c.face, c.y_previous, fixed, then);
      const Vec3 m = cross(p.tangent[0] - before.tangent[0], p.tangent[1]) +
                     cross(p.tangent[0], p.tangent[1] - before.tangent[1]);
      const Vec3 r = (partner.gap / p.area) * m + (p.x - before.x) - (now.x - then.x);
      const Vec3 way = r - dot(p.normal, r) * p.normal;
      PointTraction<double> t = q.traction();
      EXPECT_GT(norm(way), c.friction * t.pressure / c.penalty) << "the point must slip";
      t.traction = t.pressure * (partner.c - (c.friction / norm(way)) * way);
      std::vector<double> f(std::size_t(3 * (q.n1 + q.n2())), 0.0);
      point_force(c, t, f.data());
      return f;
    };
    const auto n = std::size_t(3 * s.columns());
    std::vector<double> exact(n * n);
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<double> side[2];
      for (const int k : {0, 1}) {
        Case q = s;
        (j < 12 ? q.x[j / 3] : q.y[j / 3 - 4])[int(j % 3)] += k == 0 ? -1e-5 : 1e-5;
        q.find();
        side[k] = printed(q);
      }
      for (std::size_t i = 0; i < n; ++i)
        exact[i * n + j] = (side[1][i] - side[0][i]) / 2e-5;
    }
    if (turns)
      EXPECT_GT(distance(s.tangent(), exact), 1e-3);
    else
      EXPECT_LT(distance(s.tangent(), exact), 1e-8); // of central differences
  }
}
