// SPDX-License-Identifier: BSD-3-Clause
// Every automatic choice of an interface, and what does not go together.
#include "abut/contact/option_error.hpp"
#include "abut/contact/resolve.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace abut::contact {
namespace {

ContactOptions pair() {
  ContactOptions o;
  o.name = "pair";
  o.primary = "p";
  o.secondary = "s";
  return o;
}

ContactOptions augmented() {
  ContactOptions o = pair();
  o.enforcement = Enforcement::augmented_lagrangian;
  return o;
}

SideComparison alike() {
  SideComparison sides;
  sides.softest = 2.0;
  sides.face_size = 1.0;
  return sides;
}

SideComparison stiff_primary(double stiffness) {
  SideComparison sides = alike();
  sides.stiffness = stiffness;
  return sides;
}

TEST(Resolve, MultipliersAreDualWhereTheyGo) {
  EXPECT_EQ(resolve(augmented(), alike()).multipliers, Multipliers::dual);
  EXPECT_EQ(resolve(augmented(), stiff_primary(10.0)).multipliers, Multipliers::dual);
  EXPECT_EQ(resolve(augmented(), stiff_primary(11.0)).multipliers, Multipliers::smoothed);
  EXPECT_EQ(resolve(pair(), alike()).multipliers, Multipliers::smoothed);
  const std::function<void(ContactOptions&)> changes[] = {
      [](auto& o) { o.tied = true; },
      [](auto& o) { o.sticky = true; },
      [](auto& o) { o.tension = true; },
      [](auto& o) { o.tangent = Tangent::automatic; },
  };
  for (const auto& change : changes) {
    ContactOptions o = augmented();
    change(o);
    EXPECT_EQ(resolve(o, alike()).multipliers, Multipliers::smoothed);
    o.multipliers = Multipliers::dual;
    EXPECT_THROW(resolve(o, alike()), InputError);
  }
}

TEST(Resolve, FactorFollowsTheMultipliers) {
  ContactOptions o = augmented();
  EXPECT_EQ(resolve(pair(), alike()).penalty_factor, 10.0);
  EXPECT_EQ(resolve(o, alike()).penalty_factor, 30.0);
  o.multipliers = Multipliers::smoothed;
  EXPECT_EQ(resolve(o, alike()).penalty_factor, 3.0);
  EXPECT_FALSE(resolve(o, alike()).factor_by_pressure);
  o.gap_tolerance = 1e-3;
  EXPECT_TRUE(resolve(o, alike()).factor_by_pressure);
  o.penalty_factor = 7.0;
  EXPECT_EQ(resolve(o, alike()).penalty_factor, 7.0);
  EXPECT_FALSE(resolve(o, alike()).factor_by_pressure);
  o.multipliers = Multipliers::per_point;
  o.penalty_factor.reset();
  EXPECT_EQ(resolve(o, alike()).penalty_factor, 10.0);
}

TEST(Resolve, Tolerances) {
  ContactOptions o = augmented();
  EXPECT_EQ(resolve(o, alike()).gap_tolerance, 1e-3);
  EXPECT_TRUE(std::isinf(resolve(o, alike()).change_tolerance));
  o.gap_limit = 0.5;
  EXPECT_TRUE(std::isinf(resolve(o, alike()).gap_tolerance));
  EXPECT_EQ(resolve(o, alike()).length_tolerance, 0.5);
  o.multipliers = Multipliers::smoothed;
  EXPECT_EQ(resolve(o, alike()).change_tolerance, 1e-2);
  o.multiplier_tolerance = 0.2;
  EXPECT_EQ(resolve(o, alike()).change_tolerance, 0.2);
}

TEST(Resolve, FrictionMap) {
  ContactOptions o = pair();
  EXPECT_EQ(resolve(o, alike()).friction_map, FrictionMap::incremental);
  o.formulation = Formulation::sliding_elastic;
  EXPECT_EQ(resolve(o, alike()).friction_map, FrictionMap::inclined_ray);
  o.friction_map = FrictionMap::literal;
  EXPECT_EQ(resolve(o, alike()).friction_map, FrictionMap::literal);
  o.friction_map = FrictionMap::automatic;
  o.enforcement = Enforcement::augmented_lagrangian;
  EXPECT_EQ(resolve(o, alike()).friction_map, FrictionMap::incremental); // dual
}

TEST(Resolve, AndersonWithoutFriction) {
  ContactOptions o = augmented();
  EXPECT_TRUE(resolve(o, alike()).anderson);
  o.friction = 0.1;
  EXPECT_FALSE(resolve(o, alike()).anderson);
  o.friction = 0.0;
  o.multipliers = Multipliers::per_point;
  EXPECT_FALSE(resolve(o, alike()).anderson);
  o.augmentation = AugmentationRule::anderson;
  EXPECT_TRUE(resolve(o, alike()).anderson);
}

TEST(Resolve, TheSofterSideBecomesThePrimary) {
  ContactOptions o = augmented();
  EXPECT_EQ(resolve(o, stiff_primary(20.0)).primary, "p");
  o.primary_side = PrimarySide::automatic;
  const Settings s = resolve(o, stiff_primary(20.0));
  EXPECT_EQ(s.primary, "s");
  EXPECT_EQ(s.secondary, "p");
  EXPECT_EQ(s.sides.stiffness, 0.05);
  EXPECT_EQ(s.multipliers, Multipliers::dual);
  EXPECT_NE(explain(o, s).find("swapped"), std::string::npos);
  EXPECT_EQ(resolve(o, alike()).primary, "p");
}

TEST(Resolve, PenaltyAndLimits) {
  ContactOptions o = pair();
  EXPECT_EQ(resolve(o, alike()).penalty_source, PenaltySource::factor);
  EXPECT_TRUE(std::isinf(resolve(o, alike()).stick_strength));
  EXPECT_EQ(resolve(o, alike()).segment_updates, std::numeric_limits<int>::max());
  o.penalty = 5.0;
  o.segment_updates = 4;
  const Settings s = resolve(o, alike());
  EXPECT_EQ(s.penalty_source, PenaltySource::given);
  EXPECT_EQ(s.penalty, 5.0);
  EXPECT_EQ(s.segment_updates, 4);
  EXPECT_NE(explain(o, s).find("eps = 5, given"), std::string::npos);
}

struct Refusal {
  std::function<void(ContactOptions&)> change;
  const char *path, *reason;
};

TEST(Resolve, RefusalsKnowTheirKeys) {
  const Refusal refusals[] = {
      {[](auto& o) { o.two_pass = true, o.secondary = "p"; }, "contact.pair.two_pass",
       "expected false: self-contact of 'p' has points on both sides already"},
      {[](auto& o) { o.tied = o.tension = true; }, "contact.pair.tension",
       "expected false: tied points pull already"},
      {[](auto& o) { o.sticky = o.tied = true; }, "contact.pair.sticky",
       "does not go with 'tied': leave one of them out"},
      {[](auto& o) { o.sticky = true, o.friction = 0.1; }, "contact.pair.sticky",
       "does not go with 'friction': leave one of them out"},
      {[](auto& o) { o.multipliers = Multipliers::dual, o.tied = true; },
       "contact.pair.multipliers",
       "'dual' does not go with 'tied'; valid here: automatic, smoothed, per_point"},
      {[](auto& o) { o.friction_map = FrictionMap::literal; }, "contact.pair.friction_map",
       "'literal' needs the rays of 'formulation: sliding_elastic'; valid here: automatic, "
       "incremental"},
      {[](auto& o) { o.max_augmentations = 0; }, "contact.pair.max_augmentations",
       "expected a whole number >= 1; for multipliers that change once, at the end of each step, "
       "give 'uzawa: end_of_step'"},
      {[](auto& o) { o.min_augmentations = 21; }, "contact.pair.min_augmentations",
       "expected at most max_augmentations, which is 20, got 21"},
  };
  const auto expect = [](const ContactOptions& o, const SideComparison& sides,
                         const std::string& path, const std::string& reason) {
    try {
      resolve(o, sides);
      ADD_FAILURE() << "taken: " << path << ": " << reason;
    } catch (const OptionError& error) {
      EXPECT_EQ(error.path(), path);
      EXPECT_EQ(error.reason(), reason);
      EXPECT_EQ(error.what(), path + ": " + reason);
    }
  };
  for (const Refusal& refusal : refusals) {
    ContactOptions o = pair();
    refusal.change(o);
    expect(o, alike(), refusal.path, refusal.reason);
  }
  expect(pair(), SideComparison(), "contact.pair",
         "missing key 'penalty' (both surfaces are rigid: expected a number > 0 "
         "[pressure/length])");
}

TEST(Resolve, SaysWhyMultipliersAreNotDual) {
  const auto why = [](const SideComparison& sides) {
    const std::string text = explain(augmented(), resolve(augmented(), sides));
    const std::size_t begin = text.find("multipliers: ");
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  const std::string smoothed = "multipliers: smoothed, automatic: dual ones do not go with ";
  EXPECT_EQ(why(alike()), "multipliers: dual, automatic");
  SideComparison sides = stiff_primary(11.0);
  EXPECT_EQ(why(sides), smoothed + "a primary so stiff");
  sides.size = 0.5;
  EXPECT_EQ(why(sides), smoothed + "a primary so stiff and fine");
  sides.stiffness = 2.0;
  EXPECT_EQ(why(sides), smoothed + "a primary so stiff and fine");
}

} // namespace
} // namespace abut::contact
