// SPDX-License-Identifier: BSD-3-Clause
#include "free_motions.hpp"

#include "symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace abut::scene {

namespace {

constexpr double none = 1e-3; ///< of a motion of unit size

Vec3 unit(int i) {
  Vec3 e = Vec3::zero();
  e[i] = 1.0;
  return e;
}

Vec3 projected(const Vec3& x, const std::vector<Vec3>& orthonormal) {
  Vec3 sum = Vec3::zero();
  for (const Vec3& b : orthonormal)
    sum += dot(x, b) * b;
  return sum;
}

/// An orthonormal basis of the same space, along axes where they lie in it.
std::vector<Vec3> readable(const std::vector<Vec3>& orthonormal) {
  std::vector<Vec3> result;
  for (int i = 0; i < 3; ++i)
    if (norm(projected(unit(i), orthonormal)) > 1.0 - none * none)
      result.push_back(unit(i));
  while (result.size() < orthonormal.size()) {
    Vec3 longest = Vec3::zero();
    for (int i = 0; i < 3; ++i) {
      const Vec3 inside = projected(unit(i), orthonormal);
      const Vec3 rest = inside - projected(inside, result);
      if (norm(rest) > norm(longest) + none)
        longest = rest;
    }
    result.push_back((1.0 / norm(longest)) * longest);
  }
  return result;
}

/// Motions with spins at right angles to each other, those without one apart.
struct Split {
  std::vector<Vec3> translations; ///< orthonormal
  std::vector<Twist> turning;
};

Split split(const std::vector<Twist>& basis) {
  const std::size_t n = basis.size();
  std::vector<double> gram(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      gram[n * i + j] = dot(basis[i].turn, basis[j].turn);
  const std::vector<double> vectors = symmetric_eigen(gram, n);
  Split result;
  for (std::size_t j = 0; j < n; ++j) {
    Twist sum{Vec3::zero(), Vec3::zero()};
    for (std::size_t i = 0; i < n; ++i) {
      sum.velocity += vectors[n * i + j] * basis[i].velocity;
      sum.turn += vectors[n * i + j] * basis[i].turn;
    }
    if (gram[(n + 1) * j] < none * none)
      result.translations.push_back((1.0 / norm(sum.velocity)) * sum.velocity);
    else
      result.turning.push_back(sum);
  }
  return result;
}

double rounded(double x, double size) {
  return std::fabs(x) < none * size ? 0.0 : x;
}

std::string direction(const Vec3& d) {
  for (int i = 0; i < 3; ++i)
    if (std::fabs(d[i]) > 1.0 - none * none)
      return std::string(1, "xyz"[i]);
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", rounded(d[0], 1.0), rounded(d[1], 1.0),
                     rounded(d[2], 1.0));
}

} // namespace

std::vector<std::string> describe_motions(const std::vector<Twist>& basis, const Vec3& center,
                                          double size) {
  const auto [translations, turning] = split(basis);
  std::vector<std::string> words;
  for (const Vec3& d : readable(translations))
    words.push_back("translation along " + direction(d));
  std::vector<Vec3> spins;
  for (const Twist& t : turning)
    spins.push_back((1.0 / norm(t.turn)) * t.turn);
  for (const Vec3& axis : readable(spins)) {
    Vec3 velocity = Vec3::zero(); // of the centre, for a spin of 1
    for (const Twist& t : turning)
      velocity += size * dot(axis, t.turn) / dot(t.turn, t.turn) * t.velocity;
    velocity -= projected(velocity, translations);
    const double advance = dot(velocity, axis);
    const Vec3 point = center + cross(axis, velocity);
    const bool is_screw = std::fabs(advance) > none * size;
    std::string text = (is_screw ? "screw motion about " : "rotation about ") + direction(axis);
    if (translations.size() < 3) // else about any axis
      text += fmt::format(" through ({:.4g}, {:.4g}, {:.4g})", rounded(point[0], size),
                          rounded(point[1], size), rounded(point[2], size));
    if (is_screw)
      text += fmt::format(" that advances {:.3g} a radian", advance);
    words.push_back(text);
  }
  return words;
}

} // namespace abut::scene
