// SPDX-License-Identifier: BSD-3-Clause
// Closed-form tangents of the points against automatic differentiation through the whole residual,
// search included: all formulations, rules and face pairs.
#include <Sacado.hpp>

namespace abut {
using Fad = Sacado::Fad::SFad<double, 81>;
inline double value_of(const Fad& x) {
  return x.val();
}
} // namespace abut

#include "point_cases.hpp"

using namespace abut;
using namespace abut::contact;
using namespace abut::contact::testing;

namespace {

/// Derivative of the residual by all columns, rows of an own anchor face zero.
std::vector<double> automatic(const Case& s) {
  const int n = 3 * s.columns(), rows = 3 * (s.n1 + s.n2());
  std::vector<Vec<Fad, 3>> u(27);
  for (int a = 0; a < s.columns(); ++a)
    for (int i = 0; i < 3; ++i) {
      const Vec3& v = a < s.n1            ? s.x[std::size_t(a)]
                      : a < s.n1 + s.n2() ? s.y[std::size_t(a - s.n1)]
                                          : s.z[std::size_t(a - s.n1 - s.n2())];
      u[std::size_t(a)][i] = Fad(81, 3 * a + i, v[i]);
    }
  std::vector<Fad> r(81, Fad(0.0));
  const Vec<Fad, 3>*y = u.data() + s.n1, *z = s.one_face ? y : y + s.n2();
  const ContactPoint c = s.point();
  point_force(c, point_traction<Fad>(c, u.data(), y, z), r.data());
  std::vector<double> k(std::size_t(n) * std::size_t(n), 0.0);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < n; ++j)
      k[std::size_t(i * n + j)] = r[std::size_t(i)].dx(j);
  return k;
}

/// Worst relative Frobenius error over the blocks primary, secondary x primary, secondary, anchor.
double worst_block(const Case& s, const std::vector<double>& ours,
                   const std::vector<double>& exact) {
  const int n = 3 * s.columns();
  const int at[] = {0, 3 * s.n1, 3 * (s.n1 + s.n2()), n};
  double total = 0.0, worst = 0.0;
  for (const double v : exact)
    total += v * v;
  for (int r = 0; r < 3; ++r)
    for (int q = 0; q < 3; ++q) {
      double error = 0.0, size = 0.0;
      for (int i = at[r]; i < at[r + 1]; ++i)
        for (int j = at[q]; j < at[q + 1]; ++j) {
          const double a = ours[std::size_t(i * n + j)], b = exact[std::size_t(i * n + j)];
          error += (a - b) * (a - b);
          size += b * b;
        }
      worst = std::max(worst, std::sqrt(error / std::max(size, 1e-12 * total)));
    }
  return worst;
}

double error_of(const Case& s) {
  return worst_block(s, s.tangent(), automatic(s));
}

constexpr double rounding = 1e-12; ///< relative; the formulas are exact

/// What the AL variants set: nothing, a multiplier with shear across the slip, an offset, tension.
enum class Load { penalty, augmented, offset, open_but_pressed };

void apply(Case& s, Load load) {
  if (load == Load::penalty)
    return;
  s.c.multiplier = load == Load::open_but_pressed ? 30.0 : 4.0;
  carry(s, 1.0, -0.7, 0.4);
  if (load == Load::offset)
    s.c.offset = 0.03;
}

/// Runs body(case) over all 25 face pairs, convex and concave, loads and two seeds.
template <class Body> double sweep(bool ray, PointRule rule, const Body& body) {
  double worst = 0.0;
  int count = 0;
  for (const FaceType f1 : all_types)
    for (const FaceType f2 : all_types)
      for (const double bulge : {0.08, -0.08})
        for (const Load load :
             {Load::penalty, Load::augmented, Load::offset, Load::open_but_pressed})
          for (unsigned seed = 1; seed <= 2; ++seed) {
            CaseOptions o;
            o.bulge = bulge;
            o.seed = seed;
            o.depth = load == Load::open_but_pressed ? -0.15 : 0.15;
            Case s = make_case(f1, f2, o);
            s.c.ray = ray;
            s.c.rule = rule;
            apply(s, load);
            body(s);
            if (!s.find()) {
              ADD_FAILURE() << "no partner " << int(f1) << int(f2) << ' ' << seed;
              continue;
            }
            const auto t = s.traction();
            if (t.pressure <= 0.0)
              continue; // noise opened it
            ++count;
            const double error = error_of(s);
            EXPECT_LT(error, rounding)
                << int(f1) << ' ' << int(f2) << ' ' << int(load) << ' ' << bulge << ' ' << seed;
            worst = std::max(worst, error);
          }
  EXPECT_GT(count, 300) << "of 400 points must press";
  std::printf("  worst relative error of a block: %.1e over %d points\n", worst, count);
  return worst;
}

const auto plain = [](Case&) {};

} // namespace

// Checks 1, 2, 3, 5 for each formulation and rule.
TEST(PointTangent, ClosestFrictionless) {
  sweep(false, PointRule::frictionless, plain);
}
TEST(PointTangent, ClosestIncrementalStick) {
  sweep(false, PointRule::incremental_stick, plain);
}
TEST(PointTangent, ClosestIncrementalSlip) {
  sweep(false, PointRule::incremental_slip, plain);
}
TEST(PointTangent, ClosestAnchored) {
  sweep(false, PointRule::anchored, plain);
}
TEST(PointTangent, ClosestLiteralSlip) {
  sweep(false, PointRule::literal_slip, plain);
}
TEST(PointTangent, ClosestInclinedSlip) {
  sweep(false, PointRule::inclined_slip, plain);
}
TEST(PointTangent, RayFrictionless) {
  sweep(true, PointRule::frictionless, plain);
}
TEST(PointTangent, RayIncrementalStick) {
  sweep(true, PointRule::incremental_stick, plain);
}
TEST(PointTangent, RayIncrementalSlip) {
  sweep(true, PointRule::incremental_slip, plain);
}
TEST(PointTangent, RayAnchored) {
  sweep(true, PointRule::anchored, plain);
}
TEST(PointTangent, RayLiteralSlip) {
  sweep(true, PointRule::literal_slip, plain);
}
TEST(PointTangent, RayInclinedSlipAnchorOnTheSameFace) {
  sweep(true, PointRule::inclined_slip, plain);
}
TEST(PointTangent, RayInclinedSlipAnchorOnAnotherFace) {
  sweep(true, PointRule::inclined_slip, [](Case& s) { s.one_face = false; });
}
TEST(PointTangent, RayInclinedSlipAnchorOnAnotherTypeOfFace) {
  sweep(true, PointRule::inclined_slip, [](Case& s) {
    s.one_face = false;
    s.c.anchor_face = s.c.face == FaceType::tri6 ? FaceType::quad4 : FaceType::tri6;
    s.z = reference_nodes(s.c.anchor_face, 1.4);
    for (std::size_t a = 0; a < s.z.size(); ++a)
      s.z[a] += Vec3{{0.2, 0.1, 0.03 * double(a % 3)}};
    s.c.anchor_xi[0] = 0.25;
    s.c.anchor_xi[1] = 0.3;
  });
}

TEST(PointTangent, TiedInTensionClosestAndRay) {
  for (const bool ray : {false, true}) {
    double worst = 0.0;
    for (const auto& pair : pairs) {
      CaseOptions o;
      o.depth = -0.2;
      Case s = make_case(pair[0], pair[1], o);
      s.c.ray = ray;
      s.c.rule = PointRule::anchored;
      s.c.multiplier = -9.0;
      s.c.offset = 0.02;
      carry(s, 2.0, 1.0, 0.0);
      ASSERT_TRUE(s.find());
      ASSERT_LT(s.traction().pressure, 0.0) << "the point must pull";
      worst = std::max(worst, error_of(s));
    }
    EXPECT_LT(worst, rounding);
  }
}

TEST(PointTangent, FirstContactSharesTheSlip) {
  for (const bool ray : {false, true})
    for (const PointRule rule : {PointRule::incremental_stick, PointRule::incremental_slip})
      for (const double multiplier : {0.0, 6.0})
        for (const auto& pair : pairs) {
          CaseOptions o;
          o.depth = 0.25;
          Case s = make_case(pair[0], pair[1], o);
          s.c.ray = ray;
          s.c.rule = rule;
          s.c.first = true;
          s.c.previous_gap = 0.2;
          s.c.multiplier = multiplier;
          ASSERT_TRUE(s.find());
          const auto t = s.traction();
          ASSERT_GT(t.pressure, 0.0);
          const double share = contact_share(s.point(), t.gap);
          ASSERT_GT(share, 0.01);
          ASSERT_LT(share, 0.9);
          EXPECT_LT(error_of(s), rounding);
        }
}

TEST(PointTangent, OpenAddsNothing) {
  for (const bool ray : {false, true}) {
    Case s = make_case(FaceType::quad8, FaceType::quad9, {});
    s.c.ray = ray;
    s.c.rule = PointRule::open;
    for (const double v : s.tangent())
      ASSERT_EQ(v, 0.0);
  }
}

// Check 4: literal slip at no slip, below and above the elastic slip, and the gap exactly
// zero.
TEST(PointTangent, LiteralSlipAtAndNearZeroSlip) {
  for (const double slip : {0.0, 1e-8, 0.999, 1.001}) {
    CaseOptions o;
    o.noise = 0.0, o.tilt = 0.0, o.bulge = 0.0;
    Case s = make_case(FaceType::quad4, FaceType::quad4, o);
    for (std::size_t a = 0; a < 4; ++a)
      s.x[a][2] = -0.1;
    s.c.ray = true;
    s.c.rule = PointRule::literal_slip;
    const double elastic = s.c.friction * 0.1; // mu p/eps at the depth .1
    s.y_previous = s.y;
    s.x_previous = s.x;
    for (Vec3& v : s.x_previous)
      v += Vec3{{slip == 1e-8 ? 1e-8 : slip * elastic, 0.0, 0.0}};
    ASSERT_TRUE(s.find());
    const auto t = s.traction();
    EXPECT_NEAR(t.pressure, 5.0, 1e-13);
    const double shear = norm(t.traction - Vec3{{0, 0, t.pressure}});
    EXPECT_NEAR(shear, std::min(s.c.friction * 5.0, 50.0 * (slip == 1e-8 ? 1e-8 : slip * elastic)),
                1e-13);
    EXPECT_LT(error_of(s), rounding) << slip;
  }
}

TEST(PointTangent, GapZeroWithMultiplier) {
  for (const bool ray : {false, true})
    for (const PointRule rule :
         {PointRule::frictionless, PointRule::incremental_stick, PointRule::incremental_slip,
          PointRule::literal_slip, PointRule::inclined_slip}) {
      CaseOptions o;
      o.noise = 0.0, o.tilt = 0.0, o.bulge = 0.0, o.depth = 0.0;
      Case s = make_case(FaceType::quad4, FaceType::quad4, o);
      for (Vec3& v : s.x)
        v[2] = 0.0;
      s.c.ray = ray;
      s.c.rule = rule;
      s.c.multiplier = 5.0;
      carry(s, 0.5, -0.3, 0.0);
      ASSERT_TRUE(s.find());
      if (rule != PointRule::inclined_slip) {
        EXPECT_EQ(s.traction().gap, 0.0);
      }
      for (const double f : s.force())
        ASSERT_TRUE(std::isfinite(f));
      EXPECT_LT(error_of(s), rounding) << int(rule);
    }
}

// Check 5: the symmetric rule, and only that, stays symmetric to the last bit that matters.
TEST(PointTangent, FrictionlessClosestPointIsSymmetric) {
  for (const auto& pair : pairs)
    for (const double bulge : {0.15, -0.15}) {
      CaseOptions o;
      o.bulge = bulge;
      Case s = make_case(pair[0], pair[1], o);
      s.c.rule = PointRule::frictionless;
      s.c.multiplier = 7.0;
      ASSERT_TRUE(s.find());
      const auto k = s.tangent();
      const auto n = std::size_t(3 * s.columns());
      auto transposed = k;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          transposed[i * n + j] = k[j * n + i];
      EXPECT_LT(distance(transposed, k), 1e-15);
    }
}

// The general scheme gives the same frictionless tangent as the symmetric kernel.
TEST(PointTangent, GeneralSchemeReproducesTheSymmetricKernel) {
  for (const auto& pair : pairs) {
    Case s = make_case(pair[0], pair[1], {});
    s.c.rule = PointRule::frictionless;
    ASSERT_TRUE(s.find());
    const auto symmetric = s.tangent();
    s.c.rule = PointRule::incremental_slip;
    s.c.friction = 0.0;
    EXPECT_LT(distance(s.tangent(), symmetric), 1e-13);
  }
}

// Check 5: refusals.
TEST(PointTangent, RefusesCentreOfCurvatureAndParallelRay) {
  Case s = make_case(FaceType::quad4, FaceType::quad9, {});
  s.y = reference_nodes(FaceType::quad9, 1.0);
  for (Vec3& v : s.y)
    v[2] = 0.25 * (v[0] * v[0] + v[1] * v[1]); // bowl of radius 2 at the bottom
  s.x = reference_nodes(FaceType::quad4, 1.0);
  s.set_primary_point(FaceType::quad4, 0.0, 0.0);
  for (Vec3& v : s.x)
    v = {{v[1], v[0], 2.0}};
  s.c.xi[0] = s.c.xi[1] = 0.0;
  s.c.multiplier = 200.0;
  for (const PointRule rule : {PointRule::frictionless, PointRule::incremental_slip}) {
    s.c.rule = rule;
    bool fine = true;
    for (const double v : s.tangent(&fine))
      ASSERT_EQ(v, 0.0);
    EXPECT_FALSE(fine);
  }
  for (Vec3& v : s.x)
    v = {{0.0, v[0], v[1]}}; // upright: the ray runs along the bottom of the bowl
  s.c.ray = true;
  s.c.rule = PointRule::frictionless;
  bool fine = true;
  for (const double v : s.tangent(&fine))
    ASSERT_EQ(v, 0.0);
  EXPECT_FALSE(fine);
  for (const double f : s.force())
    EXPECT_TRUE(std::isfinite(f));
}

// Check 6: long faces and another numbering of the nodes.
TEST(PointTangent, LongFacesAndRolledNodes) {
  for (const bool ray : {false, true})
    for (const PointRule rule :
         {PointRule::frictionless, PointRule::incremental_stick, PointRule::incremental_slip,
          PointRule::literal_slip, PointRule::anchored, PointRule::inclined_slip})
      for (const FaceType type : {FaceType::quad4, FaceType::tri3}) {
        for (const bool roll : {false, true}) {
          CaseOptions o;
          o.aspect = 3.0;
          o.depth = 0.3;
          o.roll = roll;
          Case s = make_case(FaceType::quad4, type, o);
          s.c.ray = ray;
          s.c.rule = rule;
          apply(s, Load::augmented);
          ASSERT_TRUE(s.find());
          ASSERT_GT(s.traction().pressure, 0.0);
          EXPECT_LT(error_of(s), rounding);
        }
      }
}

// Check 18: the measure of the reference area drops the terms of D J, and nothing else.
TEST(PointTangent, AreaTermsAreTheOnlyDifferenceOfTheMeasures) {
  for (const PointRule rule : {PointRule::frictionless, PointRule::incremental_slip,
                               PointRule::literal_slip, PointRule::inclined_slip}) {
    Case s = make_case(FaceType::quad8, FaceType::quad9, {});
    s.c.ray = true;
    s.c.rule = rule;
    apply(s, Load::augmented);
    ASSERT_TRUE(s.find());
    const auto p = s.primary();
    PrimaryColumns columns;
    primary_columns({s.n1, s.N, s.dN}, s.x.data(), columns);
    // K - r (x) a_c is the tangent under a weight that stays.
    auto k = s.tangent();
    const auto r = s.force();
    const auto n = std::size_t(3 * s.columns());
    for (std::size_t i = 0; i < r.size(); ++i)
      for (int a = 0; a < s.n1; ++a)
        for (int j = 0; j < 3; ++j)
          k[i * n + std::size_t(3 * a + j)] -= r[i] * columns.gradient[a][j];
    std::vector<double> exact(n * n, 0.0); // of the residual under a weight that stays
    const auto scaled = [&](double h, std::size_t column) {
      Case moved = s;
      auto& v = column < std::size_t(3 * s.n1) ? moved.x[column / 3]
                                               : moved.y[column / 3 - std::size_t(s.n1)];
      v[int(column % 3)] += h;
      moved.find();
      auto f = moved.force();
      const double J = moved.primary().area;
      for (double& q : f)
        q *= p.area / J;
      return f;
    };
    for (std::size_t j = 0; j < n; ++j) {
      const double h = 1e-5;
      const auto plus = scaled(h, j), minus = scaled(-h, j);
      for (std::size_t i = 0; i < r.size(); ++i)
        exact[i * n + j] = (plus[i] - minus[i]) / (2.0 * h);
    }
    EXPECT_LT(distance(k, exact), 1e-8); // of central differences
    EXPECT_GT(distance(s.tangent(), exact), 1e-3);
  }
}
