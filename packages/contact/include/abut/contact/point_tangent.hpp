// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/facet_gap.hpp"
#include "abut/contact/trial_columns.hpp"

/// The closed-form derivative of point_force by the nodes of the faces, for all rules.
///
/// Every rule gives, per column node q, the block V_q = (W t),q / W and the rows D xi^a_q of the
/// point where the traction acts; one scatter makes K_aq = -W N_a V_q on the primary and
/// K_bq = W (N_b V_q + t (x) N_b,a D xi^a_q) on the secondary. docs/theory/friction.md.
namespace abut::contact {

namespace detail {

/// What a rule hands to the scatter. Columns: primary, face of the force, face of the anchor.
struct TractionColumns {
  static constexpr int max_columns = 3 * fem::max_face_nodes;
  Vec3 traction;
  int columns = 0;                            ///< filled
  Mat3 block[max_columns];                    ///< V_q
  const Vec3* row_xi[2] = {nullptr, nullptr}; ///< null: the point is fixed to the face
};

/// t = p c + w in stick, t = p (c + mu w/|w|) or along c.line in slip; without a trial t = p c.
/// False when a slipping point has no direction.
inline KOKKOS_FUNCTION bool law_columns(const ContactPoint& c, const PartnerColumns& s,
                                        const TrialColumns* trial, bool slips, TractionColumns& t) {
  const double pressure = c.multiplier - c.penalty * (s.gap - c.offset);
  Vec3 ray = s.c, direction = Vec3::zero();
  double ratio = 1.0; // of the tangential traction to the trial
  t.traction = pressure * s.c;
  if (trial != nullptr && slips && c.line.given()) {
    direction = c.line.direction;
    ratio = c.line.turning;
    ray += c.friction * direction;
    t.traction += (c.friction * pressure - ratio * dot(direction, trial->w)) * direction;
  } else if (trial != nullptr && slips) {
    const double size = norm(trial->w);
    if (!(size > 0.0))
      return false;
    direction = (1.0 / size) * trial->w;
    ratio = c.friction * pressure / size;
    ray += c.friction * direction;
  }
  if (trial != nullptr)
    t.traction += ratio * trial->w;
  const Vec3 stiff = -c.penalty * ray;
  const Vec3 tilt[2] = {-pressure * s.dual[0], -pressure * s.dual[1]};
  for (int q = 0; q < t.columns; ++q) {
    Mat3& v = t.block[q];
    v = Mat3::zero();
    if (trial != nullptr) {
      v = trial->block[q];
      if (slips) {
        add_dyad(v, -direction, row_times(direction, v));
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            v[i][j] *= ratio;
      }
    }
    add_dyad(v, stiff, s.row_gap[q]);
    for (int k = 0; k < 2; ++k)
      add_dyad(v, tilt[k], s.turn[k][q]);
  }
  return true;
}

/// The multiplier as a vector with the offset taken off: the anchored laws read t = lambda + eps
/// (x2(anchor) - x1) with it.
inline KOKKOS_FUNCTION Vec3 net_multiplier(const ContactPoint& c, const PrimaryColumns& p) {
  return vector_multiplier(c, p.at) - (c.penalty * c.offset) * p.at.normal;
}

inline KOKKOS_FUNCTION void anchored_columns(const ContactPoint& c, const PrimaryColumns& p,
                                             const Vec3* y, fem::FacePoint<double>& anchor,
                                             TractionColumns& t) {
  fem::face_point(c.face, y, c.anchor_xi, anchor);
  const Vec3 lambda = net_multiplier(c, p);
  const TurnedColumns turned(c.carried, p, lambda);
  t.traction = lambda + c.penalty * (anchor.x - p.at.x);
  const int n1 = c.shape.nodes;
  for (int q = 0; q < t.columns; ++q) {
    Mat3& v = t.block[q];
    v = Mat3::zero();
    const double stiffness = c.penalty * (q < n1 ? -c.shape.N[q] : anchor.N[q - n1]);
    for (int i = 0; i < 3; ++i)
      v[i][i] = stiffness;
    if (q < n1)
      turned.add(c.shape, q, v);
  }
}

/// t = eps q m at the point where the ray x1 - lambda/eps + q m meets the face, m = mu s - n with s
/// the direction of the trial shear, e = n x s.
struct InclinedRay {
  Vec3 s, e, m;
  double q;
  double shear;   ///< |w| of the trial
  double elastic; ///< (trial - lambda) . n
  LineSolver line;
};

/// Blocks and rows of the primary: D rho = e . Dw/|w| turns the ray, Do = D x1 - D lambda/eps moves
/// its origin.
inline KOKKOS_FUNCTION void inclined_primary(const ContactPoint& c, const PrimaryColumns& p,
                                             const TurnedColumns& turned, const InclinedRay& ray,
                                             TractionColumns& t,
                                             Vec3 (*row_xi)[TractionColumns::max_columns]) {
  const Vec3& n = p.at.normal;
  const double mu = c.friction, eps = c.penalty, spin = dot(ray.s, turned.tangential());
  for (int a = 0; a < c.shape.nodes; ++a) {
    const Vec3& grad = p.gradient[a];
    const Vec3 rho =
        (1.0 / ray.shear) * ((ray.elastic * dot(ray.e, grad)) * n + spin * turned.turn(c.shape, a) -
                             (eps * c.shape.N[a]) * ray.e);
    Mat3 along = Mat3::zero(); // q Dm
    add_dyad(along, (ray.q * mu) * ray.e, rho);
    add_dyad(along, ray.q * (mu * dot(ray.s, grad) * n + grad), n);
    Mat3 moved = Mat3::zero(); // Do + q Dm
    turned.add(c.shape, a, moved);
    Mat3& v = t.block[a];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        moved[i][j] = along[i][j] - moved[i][j] / eps + (i == j ? c.shape.N[a] : 0.0);
        v[i][j] = eps * along[i][j];
      }
    add_dyad(v, -eps * ray.m, row_times(ray.line.distance, moved));
    for (int k = 0; k < 2; ++k)
      row_xi[k][a] = row_times(ray.line.xi[k], moved);
  }
}

/// Of the face that is hit, then of the anchor, which turns the ray; they fall together when the
/// anchor has no columns of its own.
inline KOKKOS_FUNCTION void inclined_secondary(const ContactPoint& c, const InclinedRay& ray,
                                               const fem::FacePoint<double>& face,
                                               const fem::FacePoint<double>& anchor,
                                               TractionColumns& t,
                                               Vec3 (*row_xi)[TractionColumns::max_columns]) {
  const int n1 = c.shape.nodes, n2 = fem::face_nodes(c.face), n3 = fem::face_nodes(c.anchor_face);
  const double eps = c.penalty;
  for (int b = 0; b < n2; ++b) {
    t.block[n1 + b] = Mat3::zero();
    add_dyad(t.block[n1 + b], (eps * face.N[b]) * ray.m, ray.line.distance);
    for (int k = 0; k < 2; ++k)
      row_xi[k][n1 + b] = -face.N[b] * ray.line.xi[k];
  }
  const double swing = ray.q * c.friction;
  const Vec3 push = (eps * swing) * (ray.e - dot(ray.line.distance, ray.e) * ray.m);
  const double turn[2] = {swing * dot(ray.line.xi[0], ray.e), swing * dot(ray.line.xi[1], ray.e)};
  const bool merged = t.columns == n1 + n2;
  for (int d = 0; d < n3; ++d) {
    const int column = merged ? n1 + d : n1 + n2 + d;
    const Vec3 rho = (eps * anchor.N[d] / ray.shear) * ray.e;
    if (!merged) {
      t.block[column] = Mat3::zero();
      row_xi[0][column] = row_xi[1][column] = Vec3::zero();
    }
    add_dyad(t.block[column], push, rho);
    for (int k = 0; k < 2; ++k)
      row_xi[k][column] += turn[k] * rho;
  }
}

/// Slip along the inclined ray. False when it runs along the face or the trial has no shear.
inline KOKKOS_FUNCTION bool inclined_columns(const ContactPoint& c, const PrimaryColumns& p,
                                             const Vec3* y, const Vec3* z,
                                             fem::FacePoint<double>& face, TractionColumns& t,
                                             Vec3 (*row_xi)[TractionColumns::max_columns]) {
  fem::FacePoint<double> anchor;
  fem::face_point(c.anchor_face, z, c.anchor_xi, anchor);
  fem::face_point(c.face, y, c.xi, face);
  const Vec3& n = p.at.normal;
  const Vec3 lambda = net_multiplier(c, p);
  const TurnedColumns turned(c.carried, p, lambda);
  const Vec3 trial = lambda + c.penalty * (anchor.x - p.at.x);
  const double trial_normal = dot(n, trial);
  const Vec3 w = trial - trial_normal * n;
  InclinedRay ray;
  ray.shear = norm(w);
  if (!(ray.shear > 0.0))
    return false;
  ray.elastic = trial_normal - turned.normal_part();
  ray.s = (1.0 / ray.shear) * w;
  ray.e = cross(n, ray.s);
  ray.m = c.friction * ray.s - n;
  if (!line_solver(face, ray.m, ray.line))
    return false;
  ray.q = dot(ray.m, face.x - p.at.x + (1.0 / c.penalty) * lambda) / dot(ray.m, ray.m);
  t.traction = (c.penalty * ray.q) * ray.m;
  inclined_primary(c, p, turned, ray, t, row_xi);
  inclined_secondary(c, ray, face, anchor, t, row_xi);
  return true;
}

/// Adds W times the columns to k, (columns*3)^2: rows of the primary and of the face of the force.
inline KOKKOS_FUNCTION void scatter_columns(const ContactPoint& c, double weight,
                                            const fem::FacePoint<double>& face,
                                            const TractionColumns& t, double* k) {
  const int n1 = c.shape.nodes, n2 = fem::face_nodes(c.face), width = 3 * t.columns;
  const Vec3 force = weight * t.traction;
  for (int q = 0; q < t.columns; ++q) {
    double v[9];
    for (int i = 0; i < 9; ++i)
      v[i] = weight * t.block[q][i / 3][i % 3];
    const auto add = [&](int node, double N) {
      for (int i = 0; i < 3; ++i) {
        double* row = k + (3 * node + i) * width + 3 * q;
        for (int j = 0; j < 3; ++j)
          row[j] += N * v[3 * i + j];
      }
    };
    for (int a = 0; a < n1; ++a)
      add(a, -c.shape.N[a]);
    if (t.row_xi[0] == nullptr) {
      for (int b = 0; b < n2; ++b)
        add(n1 + b, face.N[b]);
      continue;
    }
    for (int b = 0; b < n2; ++b) {
      const Vec3 row = face.dN[b][0] * t.row_xi[0][q] + face.dN[b][1] * t.row_xi[1][q];
      for (int i = 0; i < 3; ++i) {
        double* to = k + (3 * (n1 + b) + i) * width + 3 * q;
        for (int j = 0; j < 3; ++j)
          to[j] += face.N[b] * v[3 * i + j] + force[i] * row[j];
      }
    }
  }
}

/// Frictionless contact at the closest point keeps its symmetric form.
inline KOKKOS_FUNCTION bool symmetric_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y,
                                              double* k) {
  Vec3 at = Vec3::zero();
  for (int a = 0; a < c.shape.nodes; ++a)
    at += c.shape.N[a] * x[a];
  const FacetGap<double> gap = facet_gap<double>(c.face, y, at, c.xi);
  return facet_tangent(c.shape.nodes, c.shape.N, fem::face_nodes(c.face), gap, c.weight, c.penalty,
                       c.multiplier - c.penalty * (gap.gap - c.offset), k);
}

} // namespace detail

/// Whether the tangent of the rule has columns of the anchor's face.
inline KOKKOS_FUNCTION bool reads_anchor_face(PointRule rule) {
  return rule == PointRule::inclined_slip;
}

/// Adds the derivative of point_force(point_traction(...)) by the nodes to k, ((n1+n2+n3)*3)^2, row
/// by row; nodes: x (n1) primary, y (n2) of c.face, z (n3) of c.anchor_face. n3 = 0 when the anchor
/// lies on c.face (anchor_is_face, y and z are the same nodes) or the rule does not read z; the
/// rows of z stay as they are. c.xi must be the partner to rounding. False, adding nothing, where
/// the derivative does not exist: at a centre of curvature of the secondary, for a ray along the
/// face, and for slip without a direction.
inline KOKKOS_FUNCTION bool point_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y,
                                          const Vec3* z, bool anchor_is_face, double* k) {
  if (c.rule == PointRule::open)
    return true;
  if (c.rule == PointRule::frictionless && !c.ray)
    return detail::symmetric_tangent(c, x, y, k);
  const int n1 = c.shape.nodes, n2 = fem::face_nodes(c.face);
  PrimaryColumns p;
  primary_columns(c.shape, x, p);
  detail::TractionColumns t;
  t.columns = n1 + n2;
  if (reads_anchor_face(c.rule) && !anchor_is_face)
    t.columns += fem::face_nodes(c.anchor_face);
  const double weight = c.ray ? c.weight * p.at.area : c.weight;
  const auto finish = [&](const fem::FacePoint<double>& face) {
    for (int a = 0; c.ray && a < n1; ++a) // current area: D W = W a_c
      add_dyad(t.block[a], t.traction, p.gradient[a]);
    detail::scatter_columns(c, weight, face, t, k);
    return true;
  };
  if (c.rule == PointRule::anchored) {
    fem::FacePoint<double> anchor;
    detail::anchored_columns(c, p, y, anchor, t);
    return finish(anchor);
  }
  if (c.rule == PointRule::inclined_slip) {
    fem::FacePoint<double> face;
    Vec3 row_xi[2][detail::TractionColumns::max_columns];
    t.row_xi[0] = row_xi[0];
    t.row_xi[1] = row_xi[1];
    return detail::inclined_columns(c, p, y, anchor_is_face ? y : z, face, t, row_xi) &&
           finish(face);
  }
  PartnerColumns s;
  if (!partner_columns(c, p, y, s))
    return false;
  t.row_xi[0] = s.row_xi[0];
  t.row_xi[1] = s.row_xi[1];
  if (c.rule == PointRule::frictionless)
    return detail::law_columns(c, s, nullptr, false, t) && finish(s.face);
  TrialColumns trial;
  bool slips = c.rule == PointRule::incremental_slip;
  if (c.rule == PointRule::literal_slip) {
    literal_columns(c, p, s, trial);
    slips = norm(trial.w) > c.friction * (c.multiplier - c.penalty * (s.gap - c.offset));
  } else {
    incremental_columns(c, p, s, trial);
  }
  return detail::law_columns(c, s, &trial, slips, t) && finish(s.face);
}

} // namespace abut::contact
