// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/friction_switch.hpp"
#include "abut/contact/primary_point.hpp"
#include "abut/fem/face_map.hpp"
#include "abut/search/closest_point.hpp"
#include "abut/search/ray.hpp"

/// What one integration point does to the nodes of its two faces, for all formulations and friction
/// maps, on any scalar. The status is given: the search and the return map have decided it.
///
/// The contact normal c points from the secondary to the primary: the outward normal of the
/// secondary face at the closest point (node_on_facet, facet_on_facet), or minus the normal of the
/// primary at the point (sliding_elastic). gap = (x1 - x2) . c > 0 is open, the traction on the
/// primary is t = p c + t_T with p >= 0, and t_T opposes the slip of the primary.
namespace abut::contact {

/// What holds at a point now.
enum class PointRule : signed char {
  open,
  frictionless,      ///< t = p c
  incremental_stick, ///< t = p c + w, w = lambda_T - eps theta r
  incremental_slip,  ///< t = p (c + mu w/|w|), or linear in w along a given SlipLine
  anchored,      ///< t = lambda + eps (x2(anchor) - x1 + offset c): stick of the other maps, tied
  inclined_slip, ///< t = eps q m along the ray m = c + mu w/|w| (sliding_elastic)
  literal_slip,  ///< t = p (c - mu r/max(|r|, mu p/eps)), r as the theory prints it
};

/// One point, all but the present positions of its nodes.
struct ContactPoint {
  PointRule rule = PointRule::open;
  bool ray = false;    ///< sliding_elastic: ray along the primary normal, current area
  PointShape shape;    ///< of the primary face
  double weight = 0.0; ///< ray: of the quadrature; else times the reference area [length^2]
  double penalty = 0.0, friction = 0.0;
  double offset = 0.0;     ///< gap that counts as zero [length]
  double multiplier = 0.0; ///< of the pressure; negative in tension of tied points [pressure]
  StoredTraction carried;  ///< tangential multiplier or converged traction
  SlipLine line;           ///< of incremental_slip
  fem::FaceType face = fem::FaceType::quad4; ///< that carries the force
  double xi[2] = {0.0, 0.0};                 ///< partner of the point on it
  fem::FaceType anchor_face = fem::FaceType::quad4;
  double anchor_xi[2] = {0.0, 0.0};
  bool first = false;               ///< no contact at the last converged step
  double previous_gap = 0.0;        ///< then, less the offset [length]
  const Vec3* x_previous = nullptr; ///< (n1) primary nodes at the last converged step
  const Vec3* y_previous = nullptr; ///< (n2) nodes of `face` then
};

/// The partner on the secondary face and how it moves with the nodes.
template <class T> struct ContactPartner {
  T xi[2];
  fem::FacePoint<T> at;
  Vec<T, 3> c;
  T gap;
};

/// Traction of a point, where it acts and its measure.
template <class T> struct PointTraction {
  Vec<T, 3> traction; ///< on the primary [pressure]
  T weight;           ///< [length^2]
  T N[fem::max_face_nodes];
  T pressure, gap;
  Vec<T, 3> c; ///< contact normal
};

namespace detail {

template <class T> KOKKOS_INLINE_FUNCTION Vec<T, 3> plain(const Vec3& v) {
  return {{T(v[0]), T(v[1]), T(v[2])}};
}

constexpr int corrections = 2; // with xi at the solution, the first carries the derivatives

/// Partner along the line origin + q direction; q starts at the projection of c.xi.
template <class T>
KOKKOS_INLINE_FUNCTION void meet(const ContactPoint& c, const Vec<T, 3>* y, const Vec<T, 3>& origin,
                                 const Vec<T, 3>& direction, T xi[2], T& q, fem::FacePoint<T>& at) {
  xi[0] = c.xi[0];
  xi[1] = c.xi[1];
  fem::face_point(c.face, y, xi, at);
  q = dot(direction, at.x - origin) / dot(direction, direction);
  for (int k = 0; k < corrections; ++k) {
    T step[3];
    if (!search::ray_step(at, origin, direction, q, step))
      return;
    xi[0] += step[0];
    xi[1] += step[1];
    q += step[2];
    fem::face_point(c.face, y, xi, at);
  }
}

} // namespace detail

/// Closest point or ray hit of a primary point on the face with nodes y.
template <class T>
KOKKOS_INLINE_FUNCTION ContactPartner<T>
contact_partner(const ContactPoint& c, const PrimaryPoint<T>& p, const Vec<T, 3>* y) {
  ContactPartner<T> partner;
  if (c.ray) {
    T q;
    partner.c = -p.normal;
    detail::meet(c, y, p.x, partner.c, partner.xi, q, partner.at);
    partner.gap = -q;
    return partner;
  }
  partner.xi[0] = c.xi[0];
  partner.xi[1] = c.xi[1];
  fem::face_point(c.face, y, partner.xi, partner.at);
  for (int k = 0; k < detail::corrections; ++k) {
    T step[2];
    search::projection_step(partner.at, p.x, step);
    partner.xi[0] += step[0];
    partner.xi[1] += step[1];
    fem::face_point(c.face, y, partner.xi, partner.at);
  }
  const Vec<T, 3> area = cross(partner.at.tangent[0], partner.at.tangent[1]);
  partner.c = (T(1.0) / norm(area)) * area;
  partner.gap = dot(partner.c, p.x - partner.at.x);
  return partner;
}

/// Slip of the primary since the last converged step, tangent to the secondary face and objective:
/// measured between the previous positions of the present partners, then carried to the present.
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> objective_slip(const ContactPoint& c, const ContactPartner<T>& s) {
  fem::FacePoint<T> then;
  fem::face_point(c.face, c.y_previous, s.xi, then);
  const PrimaryPoint<double> before = primary_point(c.shape, c.x_previous);
  const Vec<T, 3> d = then.x - detail::plain<T>(before.x);
  const Vec<T, 3>& g1 = then.tangent[0];
  const Vec<T, 3>& g2 = then.tangent[1];
  T slip[2];
  if (c.ray) {
    const Vec<T, 3> n = detail::plain<T>(before.normal);
    const T slope = dot(cross(g1, g2), n);
    slip[0] = dot(cross(g2, n), d) / slope;
    slip[1] = dot(cross(n, g1), d) / slope;
  } else {
    const T m00 = dot(g1, g1), m01 = dot(g1, g2), m11 = dot(g2, g2), det = m00 * m11 - m01 * m01;
    const T r0 = dot(g1, d), r1 = dot(g2, d);
    slip[0] = (m11 * r0 - m01 * r1) / det;
    slip[1] = (m00 * r1 - m01 * r0) / det;
  }
  return slip[0] * s.at.tangent[0] + slip[1] * s.at.tangent[1];
}

/// Share of a step's slip that happened in contact, for a point that was open before it: g/(g -
/// g_previous) of the net gap (less the offset), and none where a multiplier alone presses. So the
/// share fades as augmentation closes the gap: contact then begins at the end of the step, and the
/// way before it is not undone. One at a point without pressure: those that just touch are held.
template <class T> KOKKOS_INLINE_FUNCTION T contact_share(const ContactPoint& c, const T& net_gap) {
  if (!c.first || c.previous_gap <= 0.0 || c.multiplier - c.penalty * value_of(net_gap) <= 0.0)
    return T(1.0);
  if (value_of(net_gap) >= 0.0)
    return T(0.0);
  return net_gap / (net_gap - c.previous_gap);
}

/// Its derivative by the gap.
inline KOKKOS_FUNCTION double contact_share_slope(const ContactPoint& c, double net_gap) {
  if (!c.first || c.previous_gap <= 0.0 || net_gap >= 0.0 ||
      c.multiplier - c.penalty * net_gap <= 0.0)
    return 0.0;
  const double way = net_gap - c.previous_gap;
  return -c.previous_gap / (way * way);
}

/// Trial tangential traction of the incremental map: w = P (lambda_T - eps theta r).
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> incremental_trial(const ContactPoint& c, const PrimaryPoint<T>& p,
                                                   const ContactPartner<T>& s) {
  const Vec<T, 3> z = turned_traction(c.carried, p) -
                      (c.penalty * contact_share(c, T(s.gap - c.offset))) * objective_slip(c, s);
  return z - dot(s.c, z) * s.c;
}

/// Multiplier as a vector, for the maps that work with the primary normal.
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> vector_multiplier(const ContactPoint& c,
                                                   const PrimaryPoint<T>& p) {
  return turned_traction(c.carried, p) - c.multiplier * p.normal;
}

/// Trial traction against the anchor: t = lambda + eps (x2(anchor) - x1 - offset n), n the primary
/// normal. z: nodes of the anchor's face.
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> anchored_trial(const ContactPoint& c, const PrimaryPoint<T>& p,
                                                const Vec<T, 3>* z) {
  const T xi[2] = {T(c.anchor_xi[0]), T(c.anchor_xi[1])};
  fem::FacePoint<T> anchor;
  fem::face_point(c.anchor_face, z, xi, anchor);
  return vector_multiplier(c, p) + c.penalty * (anchor.x - p.x - c.offset * p.normal);
}

/// Slip as the theory prints it: P_n (g c + dx1 - dx2), with the change of the normal in c.
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> literal_slip(const ContactPoint& c, const PrimaryPoint<T>& p,
                                              const ContactPartner<T>& s) {
  const PrimaryPoint<double> before = primary_point(c.shape, c.x_previous);
  fem::FacePoint<T> then;
  fem::face_point(c.face, c.y_previous, s.xi, then);
  Vec<T, 3> change[2];
  for (int a = 0; a < 2; ++a)
    change[a] = p.tangent[a] - detail::plain<T>(before.tangent[a]);
  const Vec<T, 3> m = cross(change[0], p.tangent[1]) + cross(p.tangent[0], change[1]);
  const Vec<T, 3> r = (s.gap / p.area) * m + (p.x - detail::plain<T>(before.x)) - (s.at.x - then.x);
  return r - dot(p.normal, r) * p.normal;
}

/// Where the inclined ray starts and its direction m = c + mu w/|w|, from the trial traction.
template <class T>
KOKKOS_INLINE_FUNCTION void inclined_ray(const ContactPoint& c, const PrimaryPoint<T>& p,
                                         const Vec<T, 3>& trial, Vec<T, 3>& origin,
                                         Vec<T, 3>& direction) {
  const Vec<T, 3> w = trial - dot(p.normal, trial) * p.normal;
  direction = T(c.friction / norm(w)) * w - p.normal;
  origin = p.x - (1.0 / c.penalty) * vector_multiplier(c, p) + c.offset * p.normal;
}

namespace detail {

template <class T>
KOKKOS_INLINE_FUNCTION void anchored_traction(const ContactPoint& c, const PrimaryPoint<T>& p,
                                              const Vec<T, 3>* y, PointTraction<T>& result) {
  const T xi[2] = {T(c.anchor_xi[0]), T(c.anchor_xi[1])};
  fem::FacePoint<T> anchor;
  fem::face_point(c.face, y, xi, anchor);
  result.traction = anchored_trial(c, p, y);
  result.c = -p.normal;
  result.pressure = dot(result.c, result.traction);
  result.gap = dot(p.normal, anchor.x - p.x);
  for (int b = 0; b < fem::face_nodes(c.face); ++b)
    result.N[b] = anchor.N[b];
}

template <class T>
KOKKOS_INLINE_FUNCTION void inclined_traction(const ContactPoint& c, const PrimaryPoint<T>& p,
                                              const Vec<T, 3>* y, const Vec<T, 3>* z,
                                              PointTraction<T>& result) {
  Vec<T, 3> origin, direction;
  inclined_ray(c, p, anchored_trial(c, p, z), origin, direction);
  T xi[2], q;
  fem::FacePoint<T> at;
  meet(c, y, origin, direction, xi, q, at);
  result.c = -p.normal;
  result.pressure = c.penalty * q;
  result.traction = result.pressure * direction;
  result.gap = dot(p.normal, at.x - p.x);
  for (int b = 0; b < fem::face_nodes(c.face); ++b)
    result.N[b] = at.N[b];
}

template <class T>
KOKKOS_INLINE_FUNCTION void partner_traction(const ContactPoint& c, const PrimaryPoint<T>& p,
                                             const Vec<T, 3>* y, PointTraction<T>& result) {
  const ContactPartner<T> s = contact_partner(c, p, y);
  result.c = s.c;
  result.gap = s.gap;
  result.pressure = c.multiplier - c.penalty * (s.gap - c.offset);
  result.traction = result.pressure * s.c;
  for (int b = 0; b < fem::face_nodes(c.face); ++b)
    result.N[b] = s.at.N[b];
  if (c.rule == PointRule::frictionless)
    return;
  if (c.rule == PointRule::literal_slip) {
    const Vec<T, 3> r = literal_slip(c, p, s);
    const T length = norm(r);
    const T elastic = (c.friction / c.penalty) * result.pressure; // slip at which the cone is met
    result.traction -=
        (value_of(length) > value_of(elastic) ? T(c.friction * result.pressure / length)
                                              : T(c.penalty)) *
        r;
    return;
  }
  const Vec<T, 3> w = incremental_trial(c, p, s);
  if (c.rule == PointRule::incremental_stick) {
    result.traction += w;
  } else if (c.line.given()) {
    result.traction += slip_traction(c.line, T(c.friction * result.pressure), w);
  } else {
    result.traction += T(c.friction * result.pressure / norm(w)) * w;
  }
}

} // namespace detail

/// Traction of a point that is not open. x: (n1) primary nodes, y: (n2) nodes of c.face, z: nodes
/// of the anchor's face, read by inclined_slip only. For anchored points c.face is the anchor's.
template <class T>
KOKKOS_INLINE_FUNCTION PointTraction<T> point_traction(const ContactPoint& c, const Vec<T, 3>* x,
                                                       const Vec<T, 3>* y, const Vec<T, 3>* z) {
  const PrimaryPoint<T> p = primary_point(c.shape, x);
  PointTraction<T> result;
  result.weight = T(c.weight);
  if (c.ray)
    result.weight *= p.area;
  if (c.rule == PointRule::anchored)
    detail::anchored_traction(c, p, y, result);
  else if (c.rule == PointRule::inclined_slip)
    detail::inclined_traction(c, p, y, z, result);
  else
    detail::partner_traction(c, p, y, result);
  return result;
}

/// Adds the internal-side residual of a force on the primary to r, (n1+n2, 3): minus its share on
/// the primary, plus its share N (n2) on the secondary nodes.
template <class T>
KOKKOS_INLINE_FUNCTION void add_force(const PointShape& shape, int n2, const T* N,
                                      const Vec<T, 3>& force, T* r) {
  for (int i = 0; i < 3; ++i) {
    for (int a = 0; a < shape.nodes; ++a)
      r[3 * a + i] -= shape.N[a] * force[i];
    for (int b = 0; b < n2; ++b)
      r[3 * (shape.nodes + b) + i] += N[b] * force[i];
  }
}

/// Adds the point's internal-side residual to r: (n1+n2, 3).
template <class T>
KOKKOS_INLINE_FUNCTION void point_force(const ContactPoint& c, const PointTraction<T>& point,
                                        T* r) {
  add_force(c.shape, fem::face_nodes(c.face), point.N, Vec<T, 3>(point.weight * point.traction), r);
}

} // namespace abut::contact
