// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/rotation.hpp"

#include <cmath>

namespace abut::rigid {

namespace {

constexpr double turn = 6.283185307179586476925;

/// I + first skew(w) + second skew(w)^2.
Mat3 polynomial(const Vec3& w, double first, double second) {
  const Mat3 s = skew(w), square = s * s;
  Mat3 r = Mat3::identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r[i][j] += first * s[i][j] + second * square[i][j];
  return r;
}

/// (1 - cos a)/a^2 without cancellation.
double versine(double a) {
  const double half = 0.5 * a;
  const double sinc = half == 0.0 ? 1.0 : std::sin(half) / half;
  return 0.5 * sinc * sinc;
}

struct Quaternion {
  double real;
  Vec3 imaginary;
};

/// Unit quaternion of a rotation, real part >= 0; from the largest of its four components.
Quaternion quaternion(const Mat3& r) {
  const double trace = r[0][0] + r[1][1] + r[2][2];
  Quaternion q{};
  int largest = 0;
  for (int i = 1; i < 3; ++i)
    if (r[i][i] > r[largest][largest])
      largest = i;
  if (trace > r[largest][largest]) {
    q.real = 0.5 * std::sqrt(1.0 + trace);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      q.imaginary[i] = 0.25 * (r[k][j] - r[j][k]) / q.real;
    }
    return q;
  }
  const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  const double d = std::sqrt(1.0 + r[i][i] - r[j][j] - r[k][k]);
  q.imaginary[i] = 0.5 * d;
  q.imaginary[j] = 0.5 * (r[j][i] + r[i][j]) / d;
  q.imaginary[k] = 0.5 * (r[k][i] + r[i][k]) / d;
  q.real = 0.5 * (r[k][j] - r[j][k]) / d;
  if (q.real < 0.0)
    return {-q.real, -q.imaginary};
  return q;
}

} // namespace

Mat3 skew(const Vec3& a) {
  return {{{0.0, -a[2], a[1]}, {a[2], 0.0, -a[0]}, {-a[1], a[0], 0.0}}};
}

Mat3 rotation(const Vec3& w) {
  const double a = norm(w);
  return polynomial(w, a == 0.0 ? 1.0 : std::sin(a) / a, versine(a));
}

Mat3 rotation_tangent(const Vec3& w) {
  constexpr double small = 0.1; // the next term of the series is below 1e-18 of the first
  const double a = norm(w), a2 = a * a;
  const double second = a < small ? 1.0 / 6.0 - a2 / 120.0 + a2 * a2 / 5040.0 -
                                        a2 * a2 * a2 / 362880.0 + a2 * a2 * a2 * a2 / 39916800.0
                                  : (a - std::sin(a)) / (a2 * a);
  return polynomial(w, versine(a), second);
}

Vec3 rotation_vector(const Mat3& r, const Vec3& near) {
  constexpr double no_axis = 1e-9; // half an angle that rounding may turn anywhere
  const Quaternion q = quaternion(r);
  const double sine = norm(q.imaginary), size = norm(near);
  const double turns = std::round(size / turn);
  if (sine < no_axis && turns > 0.0)
    return (turns * turn / size) * near + 2.0 * q.imaginary;
  if (sine == 0.0)
    return Vec3::zero();
  const Vec3 axis = (1.0 / sine) * q.imaginary;
  const double angle = 2.0 * std::atan2(sine, q.real);
  return (angle + turn * std::round((dot(near, axis) - angle) / turn)) * axis;
}

} // namespace abut::rigid
