// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/core/tensor.hpp"
#include "abut/core/timers.hpp"

#include <gtest/gtest.h>
#include <thread>

using namespace abut;

TEST(Tensor, InverseAndDeterminant) {
  const Mat3 a = {{{2, 1, 0.5}, {-1, 3, 0.2}, {0.3, 0.7, 1.5}}};
  const Mat3 one = a * inverse(a, det(a));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(one[i][j], i == j, 1e-15);
  const Mat<double, 2> b = {{{2, 1}, {-1, 3}}};
  const auto two = b * inverse(b, det(b));
  EXPECT_NEAR(two[0][0], 1, 1e-15);
  EXPECT_NEAR(two[0][1], 0, 1e-15);
  const Vec3 x = {{1, 0, 0}}, y = {{0, 1, 0}};
  EXPECT_EQ(cross(x, y)[2], 1);
}

TEST(Error, NearestWord) {
  const std::string words[] = {"penalty", "penalty_factor", "points"};
  const std::string hint = nearest_word_hint("penalty_factr", words, 3);
  EXPECT_NE(hint.find("did you mean 'penalty_factor'?"), std::string::npos);
  EXPECT_EQ(nearest_word_hint("zzzzzzzzzz", words, 3).find("did you mean"), std::string::npos);
}

TEST(Error, RequireThrowsDefectWithPlace) {
  try {
    ABUT_REQUIRE(1 + 1 == 3, "arithmetic");
    FAIL();
  } catch (const Defect& e) {
    EXPECT_NE(std::string(e.what()).find("arithmetic"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("basics_test.cpp"), std::string::npos);
  }
}

TEST(PhaseTimers, InnerTimeIsTakenOffTheOuter) {
  PhaseTimers timers;
  const auto nap = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  {
    const PhaseTimers::Scope outer(timers, Phase::contact);
    nap();
    const PhaseTimers::Scope inner(timers, Phase::search);
    nap();
    nap();
  }
  EXPECT_GE(timers.seconds(Phase::search), 0.04);
  EXPECT_GE(timers.seconds(Phase::contact), 0.02);
  EXPECT_LT(timers.seconds(Phase::contact), timers.seconds(Phase::search));
}
