// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/joint_equations.hpp"

#include "abut/core/error.hpp"
#include "abut/rigid/joint.hpp"
#include "abut/rigid/rotation.hpp"

#include <cmath>

namespace abut::rigid {

namespace {

Mat3 dyad(const Vec3& a, const Vec3& b) {
  Mat3 m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m[i][j] = a[i] * b[j];
  return m;
}

void add(Mat3& to, double factor, const Mat3& m) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      to[i][j] += factor * m[i][j];
}

PairMatrix zero_matrix() {
  PairMatrix k;
  for (auto& row : k)
    row.fill(Mat3::zero());
  return k;
}

/// Directions of b and of a whose product is the sine of a rotation across the axis.
struct Across {
  const Vec3 &b, &a;
};
Across across(const JointSide& a, const JointSide& b, std::size_t component) {
  // a small rotation about direction 0 moves the axis along -1, one about 1 along 0
  return {b.frame[2], a.frame[component == 3 ? 1 : 0]};
}
double sign(std::size_t component) {
  return component == 3 ? -1.0 : 1.0;
}

/// The rotation about the axis: cosine and sine between the first directions, and what they change
/// by with a rotation of b against a.
struct Turn {
  double cosine, sine;
  Vec3 of_cosine, of_sine;

  Turn(const JointSide& a, const JointSide& b)
      : cosine(dot(b.frame[0], a.frame[0])), sine(dot(b.frame[0], a.frame[1])),
        of_cosine(cross(b.frame[0], a.frame[0])), of_sine(cross(b.frame[0], a.frame[1])) {}
  double square() const { return cosine * cosine + sine * sine; }
  Vec3 slope() const { return (1.0 / square()) * (cosine * of_sine - sine * of_cosine); }
};

/// Adds a moment m on b, -m on a, whose change is of_b w_b - of_a w_a.
void add_moment(PairMatrix& k, double factor, const Mat3& of_a, const Mat3& of_b) {
  add(k[3][3], factor, of_b);
  add(k[3][1], -factor, of_a);
  add(k[1][3], -factor, of_b);
  add(k[1][1], factor, of_a);
}

/// Of the moment of the rotation about the axis.
void add_turn(PairMatrix& k, double factor, const JointSide& a, const JointSide& b) {
  const Turn t(a, b);
  const Vec3 m = t.slope();
  Mat3 common = dyad(t.of_sine, t.of_cosine);
  add(common, -1.0, dyad(t.of_cosine, t.of_sine));
  add(common, -2.0, dyad(m, t.cosine * t.of_cosine + t.sine * t.of_sine));
  const Mat3 s = skew(b.frame[0]), s0 = skew(a.frame[0]), s1 = skew(a.frame[1]);
  Mat3 of_a = common, of_b = common;
  add(of_b, t.cosine, s1 * s);
  add(of_b, -t.sine, s0 * s);
  add(of_a, t.cosine, s * s1);
  add(of_a, -t.sine, s * s0);
  add_moment(k, factor / t.square(), of_a, of_b);
}

/// Of a force p, fixed to a, on b's point and -p on the same point of a.
void add_force(PairMatrix& k, const Vec3& p, const JointSide& a, const JointSide& b) {
  const Mat3 sp = skew(p), arm = skew(b.arm()), reach = skew(b.point - a.center);
  add(k[0][1], 1.0, sp);
  add(k[1][0], -1.0, sp);
  add(k[1][1], 1.0, reach * sp);
  add(k[1][2], 1.0, sp);
  add(k[1][3], -1.0, sp * arm);
  add(k[2][1], -1.0, sp);
  add(k[3][1], -1.0, arm * sp);
  add(k[3][3], 1.0, sp * arm);
}

} // namespace

std::array<Vec3, 3> joint_frame(const Vec3& axis) {
  const Vec3 third = (1.0 / norm(axis)) * axis;
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(third[i]) < std::fabs(third[least]))
      least = i;
  Vec3 first = -third[least] * third;
  first[least] += 1.0;
  first = (1.0 / norm(first)) * first;
  return {first, cross(third, first), third};
}

double joint_value(const JointSide& a, const JointSide& b, std::size_t component) {
  if (component < 3)
    return dot(a.frame[component], b.point - a.point);
  if (component == Joint::about) {
    const Turn t(a, b);
    return std::atan2(t.sine, t.cosine);
  }
  const Across e = across(a, b, component);
  return sign(component) * dot(e.b, e.a);
}

PairVector joint_slope(const JointSide& a, const JointSide& b, std::size_t component) {
  if (component < 3) {
    const Vec3& p = a.frame[component];
    return {-p, -cross(b.point - a.center, p), p, cross(b.arm(), p)};
  }
  Vec3 m;
  if (component == Joint::about) {
    m = Turn(a, b).slope();
  } else {
    const Across e = across(a, b, component);
    m = sign(component) * cross(e.b, e.a);
  }
  return {Vec3::zero(), -m, Vec3::zero(), m};
}

PairMatrix joint_curvature(const JointSide& a, const JointSide& b,
                           const std::array<double, 6>& factor) {
  PairMatrix k = zero_matrix();
  Vec3 p = Vec3::zero();
  for (std::size_t i = 0; i < 3; ++i)
    p += factor[i] * a.frame[i];
  add_force(k, p, a, b);
  for (std::size_t i = 3; i < 5; ++i) {
    if (factor[i] == 0.0)
      continue;
    const Across e = across(a, b, i);
    const Mat3 of_b = skew(e.b), of_a = skew(e.a);
    add_moment(k, sign(i) * factor[i], of_b * of_a, of_a * of_b);
  }
  if (factor[Joint::about] != 0.0)
    add_turn(k, factor[Joint::about], a, b);
  return k;
}

PairVector Spring::force(const JointSide& a, const JointSide& b) const {
  const Vec3 d = b.point - a.point;
  const double length = norm(d);
  if (length == 0.0 && free_length > 0.0)
    throw SolveError("a spring between rigid bodies has lost its length");
  const Vec3 f = (free_length > 0.0 ? stiffness * (1.0 - free_length / length) : stiffness) * d;
  return {-f, -cross(a.arm(), f), f, cross(b.arm(), f)};
}

PairMatrix Spring::tangent(const JointSide& a, const JointSide& b) const {
  const Vec3 d = b.point - a.point, f = force(a, b)[2];
  const double length = norm(d);
  const double across = free_length > 0.0 ? stiffness * (1.0 - free_length / length) : stiffness;
  Mat3 c = Mat3::zero();
  add(c, across, Mat3::identity());
  if (free_length > 0.0)
    add(c, (stiffness - across) / (length * length), dyad(d, d));
  const Mat3 arm_a = skew(a.arm()), arm_b = skew(b.arm());
  // d f = c (db - arm_b wb - da + arm_a wa)
  const std::array<Mat3, 4> of{Mat3::identity(), arm_a, Mat3::identity(), arm_b};
  constexpr double signs[4] = {-1.0, 1.0, 1.0, -1.0};
  PairMatrix k = zero_matrix();
  for (std::size_t j = 0; j < 4; ++j) {
    const Mat3 df = c * of[j];
    add(k[0][j], -signs[j], df);
    add(k[1][j], -signs[j], arm_a * df);
    add(k[2][j], signs[j], df);
    add(k[3][j], signs[j], arm_b * df);
  }
  add(k[1][1], -1.0, skew(f) * arm_a);
  add(k[3][3], 1.0, skew(f) * arm_b);
  return k;
}

double Spring::elongation(const JointSide& a, const JointSide& b) const {
  return norm(b.point - a.point) - free_length;
}

} // namespace abut::rigid
