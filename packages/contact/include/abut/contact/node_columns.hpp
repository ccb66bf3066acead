// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_tangent.hpp"

/// The tangent of the nodal law: of a point whose traction is given, and how the nodes' gaps and
/// trial tractions move with the points. docs/theory/multipliers.md
namespace abut::contact {

/// Adds the derivative of point_force for the traction t = p c + w with constant p = c.multiplier
/// and w to k, as point_tangent does; c.penalty must be 0. False where it does not exist.
inline KOKKOS_FUNCTION bool given_traction_tangent(const ContactPoint& c, const Vec3& w,
                                                   const Vec3* x, const Vec3* y, double* k) {
  PrimaryColumns p;
  primary_columns(c.shape, x, p);
  PartnerColumns s;
  if (!partner_columns(c, p, y, s))
    return false;
  detail::TractionColumns t;
  t.columns = c.shape.nodes + fem::face_nodes(c.face);
  t.row_xi[0] = s.row_xi[0];
  t.row_xi[1] = s.row_xi[1];
  TrialColumns given;
  given.w = w;
  for (int q = 0; q < t.columns; ++q)
    given.block[q] = Mat3::zero();
  detail::law_columns(c, s, &given, false, t);
  for (int a = 0; c.ray && a < c.shape.nodes; ++a) // current area: D W = W a_c
    add_dyad(t.block[a], t.traction, p.gradient[a]);
  detail::scatter_columns(c, c.ray ? c.weight * p.at.area : c.weight, s.face, t, k);
  return true;
}

/// What a mesh node has to do with one node of the law: where its tractions push, and how its gap
/// and trial traction move.
struct NodeRow {
  Vec3 force = Vec3::zero(); ///< - d residual / d pressure [length^2]
  Vec3 gap = Vec3::zero();   ///< A d gap / d u [length^2]
  double spread = 0.0;       ///< - d residual / d shear [length^2]
  Mat3 trial = Mat3::zero(); ///< d trial / d u with the gap held [pressure/length]
};

inline KOKKOS_FUNCTION void add(NodeRow& to, const NodeRow& row) {
  to.force += row.force;
  to.gap += row.gap;
  to.spread += row.spread;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      to.trial[i][j] += row.trial[i][j];
}

/// A point's share in the means of its nodes, by the columns (n1 + n2) of the point.
struct PointRows {
  int n1 = 0, columns = 0;
  double weight = 0.0; ///< of the force, measure [length^2]
  PrimaryColumns primary;
  PartnerColumns partner;
  Mat3 normal[PartnerColumns::max_columns]; ///< D c
  Mat3 slip[PartnerColumns::max_columns];   ///< D r of objective_slip
};

/// False where the derivatives do not exist.
inline KOKKOS_FUNCTION bool point_rows(const ContactPoint& c, const Vec3* x, const Vec3* y,
                                       bool friction, PointRows& r) {
  primary_columns(c.shape, x, r.primary);
  PartnerColumns& s = r.partner;
  if (!partner_columns(c, r.primary, y, s))
    return false;
  r.n1 = c.shape.nodes;
  r.columns = r.n1 + fem::face_nodes(c.face);
  r.weight = c.ray ? c.weight * r.primary.at.area : c.weight;
  if (!friction)
    return true;
  SlipColumns slip;
  objective_slip_columns(c, s, slip);
  for (int q = 0; q < r.columns; ++q) {
    r.normal[q] = r.slip[q] = Mat3::zero();
    for (int k = 0; k < 2; ++k) {
      add_dyad(r.normal[q], -s.dual[k], s.turn[k][q]);
      add_dyad(r.slip[q], slip.moved[k], s.row_xi[k][q]);
    }
    if (q < r.n1)
      continue;
    const double* dN = s.face.dN[q - r.n1];
    for (int i = 0; i < 3; ++i)
      r.slip[q][i][i] += slip.component[0] * dN[0] + slip.component[1] * dN[1];
  }
  return true;
}

/// State of a node of the law that the rows of its trial traction need.
struct NodeFrame {
  double area = 0.0, normal_sum = 0.0, stiffness = 0.0; ///< A, |sum w c|, eps theta
  Vec3 normal, trial;
  double out_of_plane = 0.0; ///< n . z, z before projection
};

/// Row of column node q for a corner with the function psi at the point; mean: the averaging
/// function, psi or N, times the reference area: the weight in what follows. carried: the corner's
/// stored shear multiplier, turned: its derivatives, read with friction. With z = (1/A) sum w (R
/// lambda - eps theta r), m = sum w c, n = m/|m|,
///   D trial = P Dz - (n (x) trial + (n . z) I) P Dm/|m|,  P = I - n (x) n.
inline KOKKOS_FUNCTION NodeRow node_row(const ContactPoint& c, const PointRows& r, int q,
                                        double psi, double mean, bool friction,
                                        const NodeFrame& node, const TurnedColumns* turned) {
  NodeRow row;
  const double N = q < r.n1 ? c.shape.N[q] : -r.partner.face.N[q - r.n1];
  row.spread = r.weight * psi * N;
  row.force = row.spread * r.partner.c;
  row.gap = mean * r.partner.row_gap[q];
  if (!friction)
    return row;
  Mat3 d = Mat3::zero();
  if (q < r.n1)
    turned->add(c.shape, q, d);
  const double share = mean / node.area;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      d[i][j] = share * (d[i][j] - node.stiffness * r.slip[q][i][j]);
  Mat3 turn = Mat3::zero(); // D n
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      turn[i][j] = mean / node.normal_sum * r.normal[q][i][j];
  const Vec3& n = node.normal;
  add_dyad(turn, -n, row_times(n, turn));
  add_dyad(d, -n, row_times(n, d));
  add_dyad(d, -n, row_times(node.trial, turn));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      row.trial[i][j] = d[i][j] - node.out_of_plane * turn[i][j];
  return row;
}

} // namespace abut::contact
