// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facets.hpp"

#include <vector>

namespace abut::audit {

/// A place on the skin.
struct Sample {
  Local face;
  double xi[2];                      ///< on the face
  int anchors[4] = {-1, -1, -1, -1}; ///< corners of the face that it lies between: 1, 2 or all
};

/// Corners once, points on faces at a distance of half their shorter edge, and edges of bodies
/// once, in eighths, for there two bodies may meet with nothing but a bit of an edge. x: (N) in the
/// reference configuration. The same on any number of ranks, but for repetition. Collective.
std::vector<Sample> make_samples(const Skin& skin, const Facets& facets,
                                 const std::vector<Vec3>& x);

/// Position at nodes x (N).
Vec3 position(const Skin& skin, const Sample& s, const std::vector<Vec3>& x);
/// Unit outward direction there: the mean of the body's normals at corners and edges.
Vec3 direction(const Skin& skin, const Sample& s, const Pose& pose);

} // namespace abut::audit
