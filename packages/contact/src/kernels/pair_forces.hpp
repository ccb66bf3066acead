// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/node_columns.hpp"
#include "abut/core/scatter.hpp"
#include "kernels/automatic_tangent.hpp"
#include "kernels/contact_point.hpp"
#include "kernels/pairs.hpp"

/// Forces of the points on the nodes of their pairs, and their derivatives. Evaluation has left
/// every point's traction.
namespace abut::contact {

constexpr int max_pair_nodes = 3 * fem::max_face_nodes;

struct PairResidual {
  PrimaryView primary;
  FacingView facing;
  PointArrays points;
  PairArrays pairs;
  PointTerms terms;
  ResidualScatter scatter;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    const fem::FaceType type = facing.type(pairs.facing(i));
    double r[max_pair_nodes * 3] = {};
    for (Local k = pairs.first_point(i); k < pairs.first_point(i + 1); ++k) {
      const Local p = pairs.point(k);
      const PointState& state = points.state(p);
      const double measure = terms.ray ? primary.current_area(p) : primary.area(p);
      double N[fem::max_face_nodes];
      fem::dispatch_face(type, [&](auto face) { decltype(face)::values(state.xi, N); });
      add_force(primary.shape(p), fem::face_nodes(type), N, terms.share * measure * state.traction,
                r);
    }
    scatter.add(i, r, 3);
  }
};

/// Far from equilibrium the spring of a deep point presses so hard that the terms of the tangent
/// that turn its force would outweigh all others: they are taken for one that is not deeper than
/// this.
KOKKOS_INLINE_FUNCTION void moderate(ContactPoint& c, const PointState& state, double size) {
  const double excess =
      state.site.pressure - state.multiplier - moderate_depth * size * state.penalty;
  if (excess > 0.0 && c.ray)
    c.multiplier -= excess;
}

struct PairTangent {
  PrimaryView primary;
  FacingView facing;
  PointArrays points;
  PairArrays pairs;
  PointTerms terms;
  TangentScatter scatter;
  bool moderated = false, automatic = false, symmetric = false;

  /// failed: points whose derivative does not exist.
  KOKKOS_INLINE_FUNCTION void operator()(Local i, int& failed) const {
    const Local face = pairs.face(i);
    SecondaryNodes s;
    facing.coordinates(pairs.facing(i), s.y);
    facing.previous_coordinates(pairs.facing(i), s.y_previous);
    facing.coordinates(pairs.anchor(i) >= 0 ? pairs.anchor(i) : pairs.facing(i), s.z);
    const int n = 3 * pairs.columns(i);
    double k[9 * max_pair_nodes * max_pair_nodes];
    for (int j = 0; j < n * n; ++j)
      k[j] = 0.0;
    for (Local q = pairs.first_point(i); q < pairs.first_point(i + 1); ++q)
      failed += !add_point(pairs.point(q), primary.now(face), s, pairs.anchor(i) < 0, k);
    if (symmetric)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < a; ++b)
          k[a * n + b] = k[b * n + a] = 0.5 * (k[a * n + b] + k[b * n + a]);
    scatter.add(i, k, 3);
  }

private:
  /// Positions of the nodes of a pair's secondary faces: of the force, then, and of the anchor.
  struct SecondaryNodes {
    Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes], z[fem::max_face_nodes];
  };

  KOKKOS_INLINE_FUNCTION bool add_point(Local p, const Vec3* x, const SecondaryNodes& s,
                                        bool one_face, double* k) const {
    const PointState& state = points.state(p);
    ContactPoint c = terms.at_nodes
                         ? given_point(primary, facing, points, terms, p, s.y_previous)
                         : contact_point(primary, facing, points, terms, p, s.y_previous);
    if (moderated)
      moderate(c, state, primary.size(primary.face(p)));
    if (terms.at_nodes && terms.law.friction > 0.0)
      return given_traction_tangent(c, state.site.shear, x, s.y, k);
    if (automatic)
      return automatic_tangent(c, x, s.y, s.z, one_face, k);
    return point_tangent(c, x, s.y, s.z, one_face, k);
  }
};

} // namespace abut::contact
