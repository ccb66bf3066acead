// SPDX-License-Identifier: BSD-3-Clause
#include "abut/febio/model.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut::febio;

namespace {

LoadCurve curve(Interpolation interpolation, Extension extension,
                std::vector<std::array<double, 2>> points) {
  LoadCurve c;
  c.interpolation = interpolation;
  c.extension = extension;
  c.points = std::move(points);
  return c;
}

/// The deck's function of these points.
double in_deck(const std::vector<std::array<double, 2>>& points, double t) {
  if (t <= points.front()[0])
    return points.front()[1];
  for (std::size_t i = 1; i < points.size(); ++i)
    if (t <= points[i][0])
      return points[i - 1][1] + (points[i][1] - points[i - 1][1]) * (t - points[i - 1][0]) /
                                    (points[i][0] - points[i - 1][0]);
  return points.back()[1];
}

TEST(LoadCurve, Interpolations) {
  const std::vector<std::array<double, 2>> points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
  const LoadCurve linear = curve(Interpolation::linear, Extension::constant, points);
  EXPECT_DOUBLE_EQ(linear(0.25), 0.5);
  EXPECT_DOUBLE_EQ(linear(3.5), 1.0);
  const LoadCurve step = curve(Interpolation::step, Extension::constant, points);
  EXPECT_EQ(step(0.0), 0.0);
  EXPECT_EQ(step(0.1), 2.0); // of the next point
  EXPECT_EQ(step(3.0), 2.0);
  EXPECT_EQ(step(3.1), 0.0);
  // Through (0,0), (1,2), (3,2): t (8 - 2 t) / 3; in the middle the mean of that and its mirror
  // image.
  const LoadCurve smooth = curve(Interpolation::smooth, Extension::constant, points);
  EXPECT_DOUBLE_EQ(smooth(0.5), 0.5 * 7.0 / 3.0);
  EXPECT_NEAR(smooth(2.0), 2.0 * 4.0 / 3.0, 1e-15);
  EXPECT_DOUBLE_EQ(smooth(1.0), 2.0);
  EXPECT_NEAR(smooth(1.5), 0.75 * 1.5 * 5.0 / 3.0 + 0.25 * 2.5 * 3.0 / 3.0, 1e-15);
  const LoadCurve two = curve(Interpolation::smooth, Extension::constant, {{0, 0}, {2, 1}});
  EXPECT_DOUBLE_EQ(two(0.5), 0.25);
}

TEST(LoadCurve, Extensions) {
  const std::vector<std::array<double, 2>> points = {{1, 1}, {2, 3}};
  const auto at = [&](Extension e, double t) { return curve(Interpolation::linear, e, points)(t); };
  EXPECT_DOUBLE_EQ(at(Extension::constant, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(at(Extension::constant, 5.0), 3.0);
  EXPECT_DOUBLE_EQ(at(Extension::extrapolate, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(at(Extension::extrapolate, 4.0), 7.0);
  EXPECT_DOUBLE_EQ(at(Extension::repeat, 3.25), 1.5);
  EXPECT_DOUBLE_EQ(at(Extension::repeat_offset, 3.25), 5.5);
}

// The deck's curve is the same function, but for the parabolas' sixteenths and next to jumps.
TEST(LoadCurve, DeckHasTheSameFunction) {
  const std::vector<std::array<double, 2>> points = {{0, 0}, {0.4, 0.3}, {0.9, -0.2}, {1, 0.1}};
  for (const Interpolation i : {Interpolation::linear, Interpolation::step, Interpolation::smooth})
    for (const Extension e : {Extension::constant, Extension::extrapolate, Extension::repeat,
                              Extension::repeat_offset}) {
      if (i != Interpolation::linear && e == Extension::extrapolate)
        continue; // along the last two points there
      const LoadCurve c = curve(i, e, points);
      const auto deck = deck_points(c, 3.0);
      for (std::size_t k = 1; k < deck.size(); ++k)
        ASSERT_GT(deck[k][0], deck[k - 1][0]);
      for (double t = 0.0137; t < 3.0; t += 0.0271)
        EXPECT_NEAR(in_deck(deck, t), c(t), i == Interpolation::smooth ? 4e-3 : 1e-7)
            << static_cast<int>(i) << static_cast<int>(e) << " " << t;
    }
  const auto single = deck_points(curve(Interpolation::linear, Extension::constant, {{0, 4}}), 3.0);
  EXPECT_EQ(single, (std::vector<std::array<double, 2>>{{0, 4}, {3, 4}}));
}

} // namespace
