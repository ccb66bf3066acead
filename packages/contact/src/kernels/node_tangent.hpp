// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "kernels/contact_point.hpp"
#include "spaces/node_cells.hpp"

/// The tangent of the law at the nodes: rows of the points in the nodes' means, then one dense
/// block for each node. docs/theory/multipliers.md
namespace abut::contact {

/// Adds what the points of a pair have to do with the nodes of their face, at the positions that
/// `rows` has for them.
struct AddNodeRows {
  PrimaryView primary;
  FacingView facing;
  PointArrays points;
  PairArrays pairs;
  NodalArrays nodes;
  NodeRowArrays rows;
  PointTerms terms;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    const Local face = pairs.face(i);
    if (!wanted(i))
      return;
    Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
    facing.coordinates(pairs.facing(i), y);
    facing.previous_coordinates(pairs.facing(i), y_previous);
    PointRows r;
    for (Local k = pairs.first_point(i); k < pairs.first_point(i + 1); ++k) {
      const Local p = pairs.point(k);
      const ContactPoint c = given_point(primary, facing, points, terms, p, y_previous);
      if (!point_rows(c, primary.now(face), y, terms.law.friction > 0.0, r))
        continue; // the tangent of the pair tells of it
      for (int a = 0; a < nodes.corners(face); ++a)
        if ((nodes.psi_at(p, a) != 0.0 || nodes.average_at(p, a) != 0.0) && position(i, 0, a) >= 0)
          add_point(i, p, a, c, r);
    }
  }

private:
  KOKKOS_INLINE_FUNCTION Local position(Local i, int q, int a) const {
    return rows.position((pairs.first_column(i) + q) * max_corners + a);
  }
  KOKKOS_INLINE_FUNCTION bool wanted(Local i) const {
    for (int a = 0; a < max_corners; ++a)
      if (position(i, 0, a) >= 0)
        return true;
    return false;
  }

  KOKKOS_INLINE_FUNCTION void add_point(Local i, Local p, int a, const ContactPoint& c,
                                        const PointRows& r) const {
    const bool friction = terms.law.friction > 0.0;
    const double psi = nodes.psi_at(p, a), mean = primary.area(p) * nodes.average_at(p, a);
    const NodeState& n = nodes.state(nodes.node(pairs.face(i), a));
    const NodeFrame frame{n.area,           n.normal_sum, n.reading.penalty * n.site.share,
                          n.reading.normal, n.site.trial, n.site.out_of_plane};
    const StoredTraction stored = friction ? nodes.carried(p * max_corners + a) : StoredTraction();
    const TurnedColumns turned(stored, r.primary, turned_traction(stored, r.primary.at));
    for (int q = 0; q < r.columns; ++q)
      add_row(rows.row(position(i, q, a)), node_row(c, r, q, psi, mean, friction, frame, &turned));
  }

  /// Points of several pairs have one node.
  KOKKOS_INLINE_FUNCTION static void add_row(NodeRow& to, const NodeRow& row) {
    Kokkos::atomic_add(&to.spread, row.spread);
    for (int j = 0; j < 3; ++j) {
      Kokkos::atomic_add(&to.force[j], row.force[j]);
      Kokkos::atomic_add(&to.gap[j], row.gap[j]);
      for (int k = 0; k < 3; ++k)
        Kokkos::atomic_add(&to.trial[j][k], row.trial[j][k]);
    }
  }
};

/// D t of a node's tangential traction: that of the trial in stick, along the cone in slip.
KOKKOS_INLINE_FUNCTION Mat3 shear_column(const NodeState& n, double friction, const NodeRow& row) {
  const SiteReading& r = n.reading;
  const SiteState& s = n.site;
  Mat3 d = row.trial;
  add_dyad(d, (-r.penalty * s.share_slope / n.area) * (r.slip - dot(r.normal, r.slip) * r.normal),
           row.gap);
  if (s.rule != PointRule::incremental_slip)
    return d;
  add_dyad(d, -s.line.direction, row_times(s.line.direction, d));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      d[i][j] *= s.line.turning;
  add_dyad(d, (-friction * r.penalty / n.area) * s.line.direction, row.gap);
  return d;
}

/// Adds the dense block of a node, 3 x 3 at a time.
struct ScatterNodes {
  NodalArrays nodes;
  NodeRowArrays rows;
  TangentScatter scatter;
  Local first_cell; ///< of the nodes in the scatter
  double friction;
  bool symmetric;

  KOKKOS_INLINE_FUNCTION void operator()(Local c) const {
    const NodeState& n = nodes.state(rows.node(c));
    const Local first = rows.first(c), count = rows.first(c + 1) - first;
    for (Local b = 0; b < count; ++b) {
      const Mat3 shear_b = shear(n, rows.row(first + b));
      for (Local a = 0; a < count; ++a) {
        Mat3 k = block(n, rows.row(first + a), rows.row(first + b), shear_b);
        if (symmetric) {
          const NodeRow& row_a = rows.row(first + a);
          const Mat3 other = block(n, rows.row(first + b), row_a, shear(n, row_a));
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              k[i][j] = 0.5 * (k[i][j] + other[j][i]);
        }
        scatter.add_block(first_cell + c, a, b, k.m[0], 3, 3);
      }
    }
  }

private:
  KOKKOS_INLINE_FUNCTION Mat3 shear(const NodeState& n, const NodeRow& row) const {
    return friction > 0.0 ? shear_column(n, friction, row) : Mat3::zero();
  }
  KOKKOS_INLINE_FUNCTION static Mat3 block(const NodeState& n, const NodeRow& a, const NodeRow& b,
                                           const Mat3& shear) {
    const double stiffness = n.reading.penalty / n.area;
    Mat3 k;
    for (int r = 0; r < 3; ++r)
      for (int s = 0; s < 3; ++s)
        k[r][s] = stiffness * a.force[r] * b.gap[s] - a.spread * shear[r][s];
    return k;
  }
};

} // namespace abut::contact
