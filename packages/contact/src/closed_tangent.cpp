// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/point_tangent.hpp"
#include "point_tangents.hpp"

namespace abut::contact {

bool closed_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y, const Vec3* z,
                    bool one_face, double* k) {
  return point_tangent(c, x, y, z, one_face, k);
}

} // namespace abut::contact
