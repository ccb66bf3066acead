// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

/// Finite rotations in space by rotation vectors [rad]: direction is the axis, length the angle.
namespace abut::rigid {

/// skew(a) b = a x b.
Mat3 skew(const Vec3& a);

/// exp(skew(w)): Rodrigues' formula.
Mat3 rotation(const Vec3& w);

/// T(w) with d rotation(w) = skew(T dw) rotation(w), the left Jacobian of the exponential map:
/// T = I + (1 - cos a)/a^2 skew(w) + (a - sin a)/a^3 skew(w)^2, a = |w|. Singular at a = 2 pi.
Mat3 rotation_tangent(const Vec3& w);

/// The rotation vector of r nearest to `near`: of all that differ by whole turns about the axis. At
/// whole turns, where r has no axis, that of `near`.
Vec3 rotation_vector(const Mat3& r, const Vec3& near);

} // namespace abut::rigid
