// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A small rigid motion: velocity of the centre, and spin times the size of what moves, both
/// [length].
struct Twist {
  Vec3 velocity, turn;
};

/// A space of rigid motions in words, one for each dimension: translations by their direction,
/// rotations by direction and a point of the axis, screws by what they advance. `basis` is
/// orthonormal; directions along x, y, z are preferred.
std::vector<std::string> describe_motions(const std::vector<Twist>& basis, const Vec3& center,
                                          double size);

} // namespace abut::scene
