// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlaps.hpp"

namespace abut::audit {

/// Distance of x from the triangle.
double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);
/// Distance of x from a face with nodes y, taken as flat triangles between its nodes and its
/// middle: of a curved one off by a quarter of the height of its arc.
double distance_to_face(fem::FaceType type, const Vec3* y, const Vec3& x);

/// Fills in how deep each overlap is: the distance from the nearest face of the piece that does not
/// look the same way as the skin does at the sample, for through such a one it did not come; of
/// its own piece, from the nearest that it does not touch. Collective.
void measure_depths(const Scan& scan, std::vector<Overlap>& overlaps);

} // namespace abut::audit
