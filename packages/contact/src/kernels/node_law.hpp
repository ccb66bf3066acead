// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history/point_arrays.hpp"
#include "kinematics/primary_surface.hpp"
#include "law/point_terms.hpp"
#include "spaces/nodal_arrays.hpp"

/// The law at the nodes: from readings at points to readings at nodes and back. Sums run over the
/// places of each node, so that no two threads write one value.
namespace abut::contact {

/// Integral of each node's function over its points with a partner.
struct CoverNodes {
  PrimaryView primary;
  PointArrays points;
  NodalArrays nodes;
  View<double> covered; ///< (N)

  KOKKOS_INLINE_FUNCTION void operator()(Local n) const {
    double sum = 0.0;
    for (Local k = nodes.first_incidence(n); k < nodes.first_incidence(n + 1); ++k) {
      const Local place = nodes.incidence(k), point = place / max_corners;
      if (points.reading(point).covered)
        sum += primary.area(point) * nodes.hat(place);
    }
    covered(n) = sum;
  }
};

/// Adds the functions N of a face's corners that are merged to the others, in equal shares, so that
/// no numbering decides. All stay where all are merged.
KOKKOS_INLINE_FUNCTION void hand_on(const Local* corner, int corners, const View<char>& merged,
                                    double* N) {
  double given = 0.0;
  int keep = 0;
  for (int a = 0; a < corners; ++a)
    if (merged(corner[a]))
      given += N[a];
    else
      ++keep;
  for (int a = 0; keep > 0 && a < corners; ++a)
    N[a] = merged(corner[a]) ? 0.0 : N[a] + given / keep;
}

/// The functions of this configuration. On faces where some points have no partner N takes the
/// place of psi.
struct CoverFaces {
  PrimaryView primary;
  PointArrays points;
  NodalArrays nodes;

  KOKKOS_INLINE_FUNCTION void operator()(Local f) const {
    const int corners = nodes.corners(f);
    double take[max_corners][max_corners] = {};
    for (int a = 0; a < corners; ++a) {
      take[a][a] = 1.0;
      hand_on(&nodes.corner(f * max_corners), corners, nodes.merged, take[a]);
      for (int b = 0; b < max_corners; ++b)
        nodes.take((f * max_corners + a) * max_corners + b) = take[a][b];
    }
    const Local first = primary.first_point(f), end = primary.first_point(f + 1);
    bool whole = true;
    for (Local q = first; q < end; ++q)
      whole = whole && points.reading(q).covered;
    const View<double>& base = whole ? nodes.dual : nodes.hat;
    for (Local q = first; q < end; ++q)
      for (int b = 0; b < corners; ++b) {
        const Local i = q * max_corners;
        double psi = 0.0, field = 0.0;
        for (int a = 0; a < corners; ++a) {
          psi += take[a][b] * base(i + a);
          field += take[a][b] * nodes.hat(i + a);
        }
        nodes.psi(i + b) = psi;
        nodes.field(i + b) = field;
      }
  }
};

/// Columns of the nodal sums; those behind the normal only with friction.
enum NodeSum {
  sum_area,
  sum_gap,
  sum_penalty,
  sum_normal,
  sum_slip = 6,
  sum_carried = 9,
  node_sums = 12
};

/// Weighted sums of what the points read.
struct GatherNodes {
  PrimaryView primary;
  PointArrays points;
  NodalArrays nodes;
  View<double> sums; ///< (N,width)
  int width;
  bool friction;

  KOKKOS_INLINE_FUNCTION void operator()(Local n) const {
    double* sum = &sums(n * width);
    for (int c = 0; c < width; ++c)
      sum[c] = 0.0;
    for (Local k = nodes.first_incidence(n); k < nodes.first_incidence(n + 1); ++k) {
      const Local place = nodes.incidence(k), point = place / max_corners;
      const SiteReading& r = points.reading(point);
      if (!r.covered)
        continue;
      const double weight = primary.area(point) * nodes.average(place);
      sum[sum_area] += weight;
      sum[sum_gap] += weight * (r.gap - r.eased); // what is eased at a node is its own
      // Positive weights: the penalty of a face that meets several must not turn negative.
      sum[sum_penalty] += primary.area(point) * nodes.field(place) * r.penalty;
      for (int i = 0; i < 3; ++i)
        sum[sum_normal + i] += weight * r.normal[i];
      if (!friction)
        continue;
      const Vec3 carried = turned_traction(nodes.carried(place), primary.at(point));
      for (int i = 0; i < 3; ++i) {
        sum[sum_slip + i] += weight * r.slip[i];
        sum[sum_carried + i] += weight * carried[i];
      }
    }
  }
};

/// Means of a node from its sums.
KOKKOS_INLINE_FUNCTION void read_node(const NodalArrays& nodes, Local n, const double* sum,
                                      bool friction, const StartTerms& start, NodeState& state) {
  state.reading = {};
  state.reading.size = nodes.size(n);
  state.reading.soft = nodes.soft(n);
  state.area = state.normal_sum = 0.0;
  if (!(sum[sum_area] > 0.0))
    return;
  const auto vector = [&](int c) { return Vec3{{sum[c], sum[c + 1], sum[c + 2]}}; };
  SiteReading& r = state.reading;
  state.area = sum[sum_area];
  r.covered = true;
  r.eased = start.eased(nodes.history(n).start);
  r.gap = sum[sum_gap] / state.area + r.eased;
  r.penalty = sum[sum_penalty] / state.area;
  const Vec3 normal = vector(sum_normal);
  state.normal_sum = norm(normal);
  r.normal = state.normal_sum > 0.0 ? (1.0 / state.normal_sum) * normal : Vec3::zero();
  if (friction) {
    r.slip = (1.0 / state.area) * vector(sum_slip);
    r.carried = (1.0 / state.area) * vector(sum_carried);
  }
}

/// The law at the nodes, from the sums of all ranks.
struct DecideNodes {
  NodalArrays nodes;
  View<double> sums; ///< (N,width)
  int width;
  bool friction; ///< the sums have columns of slip
  LawTerms law;
  StartTerms start;

  KOKKOS_INLINE_FUNCTION void operator()(Local n) const {
    NodeState& state = nodes.state(n);
    read_node(nodes, n, &sums(n * width), friction, start, state);
    state.reading.multiplier = nodes.history(n).multiplier;
    const SitePast past{nodes.converged(n).in_contact,
                        nodes.converged(n).gap + state.reading.eased};
    state.site = decide(state.reading, past, nodes.iterate(n), law);
  }
};

/// Traction of the nodes at the points; a point's status is that of the node with most weight
/// there.
struct SpreadNodes {
  PrimaryView primary;
  PointArrays points;
  NodalArrays nodes;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    PointState& s = points.state(i);
    const Local face = primary.face(i);
    s.site = {};
    s.site.touching = true;
    s.multiplier = 0.0;
    double most = 0.0;
    for (int a = 0; s.facing >= 0 && a < nodes.corners(face); ++a) {
      const Local n = nodes.node(face, a);
      const SiteState& node = nodes.site(n);
      const double psi = nodes.psi_at(i, a), field = nodes.field_at(i, a);
      if (!node.active() || psi == 0.0)
        continue;
      s.site.touching = s.site.touching && node.touching;
      s.site.pressure += psi * node.pressure;
      s.multiplier += psi * nodes.history(n).multiplier;
      s.site.shear += psi * node.shear;
      if (s.site.rule == PointRule::open || field > most) {
        s.site.rule = node.rule;
        most = field;
      }
    }
    s.site.touching = s.site.touching && s.site.active();
    s.traction = s.site.pressure * s.normal + s.site.shear;
  }
};

} // namespace abut::contact
