// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_force.hpp"

namespace abut::contact {

/// The same as point_tangent by automatic differentiation: true always.
bool automatic_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y, const Vec3* z,
                       bool one_face, double* k);

} // namespace abut::contact
