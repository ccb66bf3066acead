// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/facet_gap.hpp"
#include "kinematics/facing_surface.hpp"
#include "kinematics/primary_surface.hpp"
#include "law/constants.hpp"

/// Surfaces that face each other may do so across a gap, in an overlap, or through the bodies
/// behind them: the back of one thin plate and that of another that lies on it, the two sides of
/// one plate. Only the first two are contact. Device code.
namespace abut::contact {

/// A point behind a face, at its projection or hit xi.
struct BodySight {
  const PrimaryView& primary;
  const FacingView& facing;
  Local point, face;
  const double* xi;

  /// Whether the point lies beyond the middle of a body, its own or the face's: it is nearer to the
  /// opposite side then, and has not come in by this one. Unless it did so in this very step.
  KOKKOS_INLINE_FUNCTION bool beyond_middle(double depth, const Vec3& x_previous) const {
    const double most =
        nearer_side * fmin(primary.thickness(primary.face(point)), facing.thickness(face));
    if (depth <= most)
      return false;
    Vec3 y[fem::max_face_nodes];
    facing.previous_coordinates(face, y);
    return -facet_gap<double>(facing.type(face), y, x_previous, xi).gap > most;
  }

  /// Of one surface: whether the way from the point to the face has led through the body from the
  /// start and has not become far shorter since, as it has where distant parts of the body meet.
  KOKKOS_INLINE_FUNCTION bool through_own(double depth) const {
    const auto from = primary_point(primary.shape(point), primary.at_rest(primary.face(point)));
    Vec3 y[fem::max_face_nodes];
    facing.reference_coordinates(face, y);
    fem::FacePoint<double> to;
    fem::face_point(facing.type(face), y, xi, to);
    const Vec3 area = cross(to.tangent[0], to.tangent[1]), way = to.x - from.x;
    return dot(way, (1.0 / norm(area)) * area - from.normal) > leads_inward * norm(way) &&
           depth > squeezed * norm(way);
  }
};

} // namespace abut::contact
