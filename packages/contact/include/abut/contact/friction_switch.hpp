// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

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
  Vec3 direction = {{0.0, 0.0, 0.0}}; ///< n
  double turning = 0.0;               ///< k, share of the trial across n [1]
  KOKKOS_INLINE_FUNCTION bool given() const { return dot(direction, direction) > 0.0; }
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

/// Status that a site must keep, whatever the trial says.
enum class Keep : signed char { nothing, stick, slip };

/// Status and traction of the next iterate.
struct ShearChoice {
  bool slips = false;
  SlipLine line;
  Vec3 traction = {{0.0, 0.0, 0.0}}; ///< tangential [pressure]
  bool settled = true;               ///< it is the return map's
};

namespace detail {

KOKKOS_INLINE_FUNCTION Vec3 within_cone(const Vec3& t, double limit) {
  const double size = norm(t);
  return size > limit ? (limit / size) * t : t;
}

} // namespace detail

/// trial, normal: z and the normal that it is orthogonal to; limit: mu p >= 0 [pressure]; share:
/// stiffness of the soft spring over the penalty, 1: the return map decides.
KOKKOS_INLINE_FUNCTION ShearChoice choose_shear(const ShearIterate& last, const Vec3& trial,
                                                const Vec3& normal, double limit, double share,
                                                Keep keep = Keep::nothing) {
  constexpr double law_tolerance = 1e-8; // of mu p, within which a traction is the return map's
  if (!last.pressed)                     // nothing to go on from
    share = 1.0;
  // The present traction by the law of the last iterate, in the plane and within the cone.
  Vec3 predicted = last.slips ? slip_traction(last.line, limit, trial) : trial;
  predicted = detail::within_cone(predicted - dot(normal, predicted) * normal, limit);
  const Vec3 mixed = (1.0 - share) * predicted + share * trial;
  const double size = norm(mixed);
  ShearChoice choice;
  choice.slips = (keep == Keep::nothing ? size > limit : keep == Keep::slip) && size > 0.0;
  if (choice.slips) {
    const double ratio = limit < size ? limit / size : 1.0;
    choice.line.direction = (1.0 / size) * mixed;
    choice.line.turning = share * ratio / (1.0 - (1.0 - share) * ratio);
    choice.traction = slip_traction(choice.line, limit, trial);
  } else {
    choice.traction = trial;
  }
  choice.settled =
      norm(choice.traction - detail::within_cone(trial, limit)) <= law_tolerance * limit;
  return choice;
}

} // namespace abut::contact
