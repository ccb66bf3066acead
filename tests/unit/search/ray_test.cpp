// SPDX-License-Identifier: BSD-3-Clause
// Where a line meets a face: hits of known place, and lines that do not meet it.
#include "abut/search/ray.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace abut;
using fem::FaceType;

namespace {

constexpr FaceType types[] = {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3,
                              FaceType::tri6};

void warped_face(FaceType type, std::mt19937& random, double noise, Vec3* y) {
  std::uniform_real_distribution<double> jitter(-noise, noise);
  fem::dispatch_face(type, [&](auto shape) {
    for (int a = 0; a < decltype(shape)::nodes; ++a) {
      double p[2];
      decltype(shape)::node(a, p);
      y[a] = {{p[0] + jitter(random), p[1] + jitter(random), jitter(random)}};
    }
  });
}

} // namespace

TEST(Ray, FindsThePointItWasAimedAt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> inside(0.1, 0.4), slant(-0.5, 0.5), reach(-0.6, 0.6);
  int hits = 0;
  for (const FaceType type : types)
    for (int trial = 0; trial < 100; ++trial) {
      Vec3 y[9];
      warped_face(type, random, 0.08, y);
      const double aim[2] = {inside(random), inside(random)};
      fem::FacePoint<double> at;
      fem::face_point(type, y, aim, at);
      const Vec3 direction{{slant(random), slant(random), 1.3}}; // not a unit vector
      const double distance = reach(random);
      double start[2];
      fem::dispatch_face(type, [&](auto shape) { decltype(shape)::center(start); });
      const auto hit = search::intersect(type, y, at.x - distance * direction, direction, start);
      ASSERT_TRUE(hit.converged) << int(type) << ' ' << trial;
      EXPECT_NEAR(hit.distance, distance, 1e-14);
      EXPECT_NEAR(hit.xi[0], aim[0], 1e-14);
      EXPECT_NEAR(hit.xi[1], aim[1], 1e-14);
      ++hits;
    }
  EXPECT_EQ(hits, 500);
}

TEST(Ray, MayHitBesideTheFace) {
  const Vec3 y[4] = {{{-1, -1, 0}}, {{1, -1, 0}}, {{1, 1, 0}}, {{-1, 1, 0}}};
  const double start[2] = {0, 0};
  const auto hit = search::intersect(FaceType::quad4, y, {{1.5, 0.25, 2}}, {{0, 0, -1}}, start);
  ASSERT_TRUE(hit.converged);
  EXPECT_NEAR(hit.xi[0], 1.5, 1e-15);
  EXPECT_NEAR(hit.xi[1], 0.25, 1e-15);
  EXPECT_NEAR(hit.distance, 2.0, 1e-15);
  EXPECT_FALSE(search::intersect(FaceType::quad4, y, {{9, 0, 2}}, {{0, 0, -1}}, start).converged);
}

TEST(Ray, DistanceIsNegativeBehindTheOrigin) {
  const Vec3 y[4] = {{{-1, -1, 0}}, {{1, -1, 0}}, {{1, 1, 0}}, {{-1, 1, 0}}};
  const double start[2] = {0, 0};
  const auto hit = search::intersect(FaceType::quad4, y, {{0.1, 0, -0.5}}, {{0, 0, -2}}, start);
  ASSERT_TRUE(hit.converged);
  EXPECT_NEAR(hit.distance, -0.25, 1e-15);
}

TEST(Ray, DoesNotMeetAParallelFace) {
  const Vec3 y[4] = {{{-1, -1, 0}}, {{1, -1, 0}}, {{1, 1, 0}}, {{-1, 1, 0}}};
  const double start[2] = {0, 0};
  EXPECT_FALSE(
      search::intersect(FaceType::quad4, y, {{0, 0, 0.1}}, {{1, 0.3, 0}}, start).converged);
  fem::FacePoint<double> p;
  fem::face_point(FaceType::quad4, y, start, p);
  double step[3] = {7, 7, 7};
  EXPECT_FALSE(search::ray_step(p, Vec3{{0, 0, 0.1}}, Vec3{{1, 0, 0}}, 0.0, step));
  EXPECT_EQ(step[0], 7.0) << "no step is written";
  // A thousandth of a radian is no hindrance.
  EXPECT_TRUE(
      search::intersect(FaceType::quad4, y, {{0, 0, 5e-4}}, {{1, 0, -1e-3}}, start).converged);
}

TEST(Ray, IsIndependentOfTheStart) {
  std::mt19937 random(8);
  Vec3 y[9];
  warped_face(FaceType::quad9, random, 0.08, y);
  const Vec3 origin{{0.2, -0.3, 0.8}}, direction{{0.1, 0.05, -1}};
  const double a[2] = {0, 0}, b[2] = {0.9, 0.9};
  const auto first = search::intersect(FaceType::quad9, y, origin, direction, a);
  const auto second = search::intersect(FaceType::quad9, y, origin, direction, b);
  ASSERT_TRUE(first.converged && second.converged);
  EXPECT_NEAR(first.xi[0], second.xi[0], 1e-14);
  EXPECT_NEAR(first.distance, second.distance, 1e-14);
}
