// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_force.hpp"

namespace abut::contact {

/// Adds the derivative of a point's residual by the nodes to k: ((n1+n2+n3)*3)^2, row by row; n3 =
/// 0 when one_face, the anchor then lies on the face that carries the force. False, adding nothing,
/// where it is singular. Closed form, and by automatic differentiation.
bool closed_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y, const Vec3* z,
                    bool one_face, double* k);
bool automatic_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y, const Vec3* z,
                       bool one_face, double* k);

} // namespace abut::contact
