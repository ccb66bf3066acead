// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "skin.hpp"

#include <vector>

namespace abut::audit {

/// A place on the skin.
struct Sample {
  Local face;
  double xi[2];                      ///< on the face
  int anchors[4] = {-1, -1, -1, -1}; ///< corners of the face that it lies between: 1, 2 or all
};

/// Corners once, edges once and the faces between them, at a distance of half the shorter edge of a
/// face; edges of bodies at a sixteenth of it, for there two bodies may meet with nothing but a bit
/// of an edge. normal: (N) of the reference configuration. The same on any number of ranks, but for
/// repetition. Collective.
std::vector<Sample> make_samples(const Skin& skin, const NodeExchange& exchange,
                                 const std::vector<Vec3>& x, const std::vector<Vec3>& normal);

/// Position at nodes x (N).
Vec3 position(const Skin& skin, const Sample& s, const std::vector<Vec3>& x);
/// Unit outward direction there: the mean of the body's normals at corners and edges.
Vec3 direction(const Skin& skin, const Sample& s, const Pose& pose);

} // namespace abut::audit
