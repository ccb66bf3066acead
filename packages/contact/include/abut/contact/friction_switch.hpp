// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

#include <optional>

/// How Newton gets to the return map of Coulomb's law. A stiff spring overshoots the cone on either
/// side with every small motion, so that the return map itself can throw Newton from slip to slip
/// for ever. Here the traction is an unknown of Newton's own: the law of the last iterate, made
/// linear there, gives the present traction t; t and the trial z, as a soft spring would see it,
/// choose the status and the direction n of slip, and the law is made linear again. It ends where n
/// is the direction of z, with the value and the derivative of the return map (Alart & Curnier
/// 1991; Hueber, Stadler & Wohlmuth 2008; docs/theory/multipliers.md (M6), (M7)).
namespace abut::contact {

/// Slip made linear: t = mu p n + k (1 - n n) z. Without a direction: the return map itself.
struct SlipLine {
  Vec3 direction = Vec3::zero(); ///< n
  double turning = 0.0;          ///< k, share of the trial across n [1]
  bool given() const { return dot(direction, direction) > 0.0; }
};

/// Its traction, limit: mu p [pressure].
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> slip_traction(const SlipLine& line, const T& limit,
                                               const Vec<T, 3>& trial) {
  T along = T(0.0);
  for (int i = 0; i < 3; ++i)
    along += line.direction[i] * trial[i];
  Vec<T, 3> t;
  for (int i = 0; i < 3; ++i)
    t[i] = limit * line.direction[i] + line.turning * (trial[i] - along * line.direction[i]);
  return t;
}

/// What the last Newton iterate left.
struct ShearIterate {
  bool pressed = false, slips = false;
  SlipLine line;
};

/// Status and traction of the next iterate.
struct ShearChoice {
  bool slips = false;
  SlipLine line;
  Vec3 traction = Vec3::zero(); ///< tangential [pressure]
  bool settled = true;          ///< it is the return map's
};

/// trial, normal: z and the normal that it is orthogonal to; limit: mu p >= 0 [pressure]; share:
/// stiffness of the soft spring over the penalty, 1: the return map decides; held_slip: the status
/// to stay with.
ShearChoice choose_shear(const ShearIterate& last, const Vec3& trial, const Vec3& normal,
                         double limit, double share, std::optional<bool> held_slip = {});

} // namespace abut::contact
