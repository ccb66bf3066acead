// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/nodal_space.hpp"

#include "kernels/node_law.hpp"
#include "kernels/take_iterate.hpp"
#include "spaces/dual_weights.hpp"

#include <cmath>

namespace abut::contact {

NodalSpace::NodalSpace(const Comm& comm, const CornerSpace& corners, const PrimaryView& primary,
                       WeightedGap weighted_gap, double soft_modulus, bool friction)
    : comm_(comm), corners_(corners), friction_(friction) {
  const std::size_t faces = std::size_t(primary.faces()), points = std::size_t(primary.points()),
                    nodes = std::size_t(corners.nodes());
  NodalArrays& a = arrays_;
  a.corner = make_view<Local>("abut::contact::corner", faces * max_corners, -1);
  for (Local f = 0; f < primary.faces(); ++f)
    for (int b = 0; b < corners.corners(f); ++b)
      a.corner(f * max_corners + b) = corners.nodes(f)[b];
  a.full = make_view<double>("abut::contact::full", nodes);
  a.size = make_view<double>("abut::contact::node_size", nodes);
  a.soft = make_view<double>("abut::contact::node_soft", nodes);
  a.prescribed = make_view<char>("abut::contact::prescribed", nodes);
  a.merged = make_view<char>("abut::contact::merged", nodes);
  a.hat = make_view<double>("abut::contact::hat", points * max_corners);
  a.dual = make_view<double>("abut::contact::psi_whole", points * max_corners);
  a.psi = make_view<double>("abut::contact::psi", points * max_corners);
  a.field = make_view<double>("abut::contact::field", points * max_corners);
  a.average = weighted_gap == WeightedGap::hat ? a.field : a.psi;
  a.take = make_view<double>("abut::contact::take", faces * max_corners * max_corners);
  const std::size_t carried = friction ? points * max_corners : 0;
  a.carried = make_view<StoredTraction>("abut::contact::carried", carried);
  a.carried_converged = make_view<StoredTraction>("abut::contact::carried_converged", carried);
  a.history = make_view<NodeHistory>("abut::contact::node_history", nodes);
  a.converged = make_view<NodeHistory>("abut::contact::node_converged", nodes);
  a.iterate = make_view<SiteIterate>("abut::contact::node_iterate", nodes);
  a.state = make_view<NodeState>("abut::contact::node_state", nodes);
  make_functions(primary);
  measure_nodes(primary, soft_modulus);
}

/// Corner functions at the points, alone on each face, and the places that each node has.
void NodalSpace::make_functions(const PrimaryView& primary) {
  std::vector<std::vector<Local>> places(std::size_t(corners_.nodes()));
  for (Local f = 0; f < primary.faces(); ++f) {
    const int n = corners_.corners(f);
    const Local first = primary.first_point(f), points = primary.first_point(f + 1) - first;
    std::vector<double> N(std::size_t(points * n)), area;
    for (Local q = 0; q < points; ++q) {
      corners_.values(f, primary.xi(first + q), &N[std::size_t(q * n)]);
      area.push_back(primary.area(first + q));
    }
    double C[max_corners * max_corners];
    dual_coefficients(n, points, N.data(), area.data(), C);
    for (Local q = 0; q < points; ++q)
      for (int a = 0; a < n; ++a) {
        const Local place = (first + q) * max_corners + a;
        arrays_.hat(place) = N[std::size_t(q * n + a)];
        for (int b = 0; b < n; ++b)
          arrays_.dual(place) += C[a * n + b] * N[std::size_t(q * n + b)];
        places[std::size_t(corners_.nodes(f)[a])].push_back(place);
      }
  }
  std::vector<Local> first{0}, list;
  for (const auto& of_node : places) {
    list.insert(list.end(), of_node.begin(), of_node.end());
    first.push_back(static_cast<Local>(list.size()));
  }
  arrays_.first_incidence = make_view("abut::contact::first_incidence", first);
  arrays_.incidence = make_view("abut::contact::incidence", list);
  Kokkos::deep_copy(arrays_.psi, arrays_.hat);
  Kokkos::deep_copy(arrays_.field, arrays_.hat);
}

/// Integrals of the functions, and means of what faces have.
void NodalSpace::measure_nodes(const PrimaryView& primary, double soft_modulus) {
  std::vector<double> sums(3 * std::size_t(corners_.nodes()), 0.0);
  for (Local p = 0; p < primary.points(); ++p) {
    const Local f = primary.face(p);
    const double depth =
        primary.modulus(f) > 0.0 ? primary.inverse_depth(f) : 1.0 / primary.size(f);
    for (int a = 0; a < arrays_.corners(f); ++a) {
      const double weight = primary.area(p) * arrays_.hat(p * max_corners + a);
      double* sum = &sums[3 * std::size_t(arrays_.node(f, a))];
      sum[0] += weight;
      sum[1] += weight * primary.size(f);
      sum[2] += weight * soft_modulus * depth;
    }
  }
  corners_.sum(sums, 3);
  for (Local n = 0; n < corners_.nodes(); ++n) {
    const double* sum = &sums[3 * std::size_t(n)];
    arrays_.full(n) = sum[0];
    arrays_.size(n) = sum[0] > 0.0 ? sum[1] / sum[0] : 0.0;
    arrays_.soft(n) = sum[0] > 0.0 ? sum[2] / sum[0] : 0.0;
  }
}

void NodalSpace::set_prescribed(const std::vector<char>& prescribed) {
  if (!prescribed.empty())
    std::copy(prescribed.begin(), prescribed.end(), arrays_.prescribed.data());
}

View<double> NodalSpace::gather(const PrimaryView& primary, const PointArrays& points, int width) {
  const Local nodes = arrays_.nodes();
  View<double> covered("abut::contact::covered", std::size_t(nodes));
  Kokkos::parallel_for("abut::contact::cover_nodes", Range(0, nodes),
                       CoverNodes{primary, points, arrays_, covered});
  corners_.sum(covered.data());
  for (Local n = 0; n < nodes; ++n) {
    arrays_.state(n).covered = covered(n);
    arrays_.merged(n) = covered(n) < sliver * arrays_.full(n) || arrays_.prescribed(n);
  }
  Kokkos::parallel_for("abut::contact::cover_faces", Range(0, primary.faces()),
                       CoverFaces{primary, points, arrays_});
  View<double> sums("abut::contact::node_sums", std::size_t(nodes * width));
  Kokkos::parallel_for("abut::contact::gather_nodes", Range(0, nodes),
                       GatherNodes{primary, points, arrays_, sums, width, width > sum_slip});
  corners_.sum(sums.data(), width);
  return sums;
}

void NodalSpace::evaluate(const PrimaryView& primary, const PointArrays& points,
                          const PointTerms& terms) {
  const View<double> sums = gather(primary, points, width());
  Kokkos::parallel_for("abut::contact::decide_nodes", Range(0, arrays_.nodes()),
                       DecideNodes{arrays_, sums, width(), friction_, terms.law, terms.start});
  Kokkos::parallel_for("abut::contact::spread_nodes", Range(0, primary.points()),
                       SpreadNodes{primary, points, arrays_});
}

void NodalSpace::start(const PrimaryView& primary, const PointArrays& points,
                       const Settings& settings, const StartTerms& terms) {
  const View<double> sums = gather(primary, points, sum_slip);
  for (Local n = 0; n < arrays_.nodes(); ++n) {
    NodeState& state = arrays_.state(n);
    NodeHistory& history = arrays_.history(n);
    history.start = {};
    read_node(arrays_, n, &sums(n * sum_slip), false, terms, state);
    history.gap = state.reading.gap;
    if (state.area > 0.0)
      history.start = settings.start_of(history.gap + settings.offset);
    history.in_contact = state.area > 0.0 && history.gap + terms.eased(history.start) <=
                                                 touching_gap * state.reading.size;
    arrays_.converged(n) = history;
  }
}

SiteStart NodalSpace::start_at(Local face, Local point) const {
  SiteStart sum;
  for (int a = 0; a < arrays_.corners(face); ++a) {
    const SiteStart& node = arrays_.history(arrays_.node(face, a)).start;
    const double weight = arrays_.field_at(point, a);
    sum.overlap += weight * node.overlap;
    sum.shift += weight * node.shift;
    sum.fit += weight * node.fit;
  }
  return sum;
}

void NodalSpace::take_iterate(bool new_step) {
  for (Local n = 0; n < arrays_.nodes(); ++n)
    leave(arrays_.site(n), new_step, arrays_.iterate(n));
}

void NodalSpace::freeze() {
  for (Local n = 0; n < arrays_.nodes(); ++n) {
    leave(arrays_.site(n), false, arrays_.iterate(n));
    arrays_.iterate(n).frozen = true;
  }
}

void NodalSpace::set_multipliers(const std::vector<double>& pressures) {
  for (Local n = 0; n < arrays_.nodes(); ++n)
    arrays_.history(n).multiplier = pressures[std::size_t(n)];
}

void NodalSpace::store_shear(const PrimaryView& primary) {
  if (!friction_)
    return;
  for (Local p = 0; p < primary.points(); ++p) {
    const auto at = primary.at(p);
    for (int a = 0; a < arrays_.corners(primary.face(p)); ++a)
      arrays_.carried(p * max_corners + a) =
          store_traction(at, arrays_.site(arrays_.node(primary.face(p), a)).shear);
  }
}

bool NodalSpace::settled() const {
  for (Local n = 0; n < arrays_.nodes(); ++n)
    if (arrays_.site(n).pressed() && !arrays_.site(n).settled)
      return false;
  return true;
}

double NodalSpace::slipped(Local node) const {
  const NodeState& n = arrays_.state(node);
  const SiteReading& r = n.reading;
  if (n.site.rule != PointRule::incremental_slip || !(r.penalty > 0.0))
    return 0.0;
  const Vec3 slip = n.site.share * r.slip + (1.0 / r.penalty) * (n.site.shear - r.carried);
  return norm(slip - dot(r.normal, slip) * r.normal);
}

double NodalSpace::dissipated(Local node) const {
  const double now = norm(arrays_.site(node).shear), then = arrays_.history(node).sliding;
  return slipped(node) * (then > 0.0 ? 0.5 * (then + now) : now);
}

void NodalSpace::accept() {
  for (Local n = 0; n < arrays_.nodes(); ++n) {
    const NodeState& state = arrays_.state(n);
    NodeHistory& history = arrays_.history(n);
    history.gap = state.reading.gap - state.reading.eased;
    history.in_contact = state.site.active();
    history.sliding = state.site.rule == PointRule::incremental_slip ? norm(state.site.shear) : 0.0;
    arrays_.converged(n) = history;
  }
  Kokkos::deep_copy(arrays_.carried_converged, arrays_.carried);
}

void NodalSpace::reject() {
  for (Local n = 0; n < arrays_.nodes(); ++n) {
    arrays_.history(n) = arrays_.converged(n);
    arrays_.iterate(n) = {};
    arrays_.iterate(n).last.pressed = arrays_.converged(n).in_contact;
  }
  Kokkos::deep_copy(arrays_.carried, arrays_.carried_converged);
}

} // namespace abut::contact
