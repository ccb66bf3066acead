// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history/point_arrays.hpp"
#include "law/point_terms.hpp"
#include "spaces/corner_space.hpp"
#include "spaces/nodal_arrays.hpp"

namespace abut::contact {

/// The space in which Signorini's law and Coulomb's hold at the corner nodes of the primary
/// surface: gap and slip are averaged with functions psi that are biorthogonal to the corner
/// functions N, and the tractions of the nodes act at the points through the same psi.
/// docs/theory/multipliers.md
///
///   gap_I = sum w psi_I gap / A_I,  A_I = sum w psi_I,  p_I = <lambda_I - eps_I gap_I>,
///   p(q) = sum_I psi_I(q) p_I
///
/// With WeightedGap::hat N takes the place of psi in the averages. Sums run over points that have a
/// partner, w is the reference area. On faces where some points have none N takes the place of psi,
/// and a node with little cover hands its function on to the other corners of each of its faces.
class NodalSpace {
public:
  /// soft_modulus: of the spring that decides between stick and slip, 0: the return map decides
  /// [pressure]. corners must outlive the space. Collective.
  NodalSpace(const Comm& comm, const CornerSpace& corners, const PrimaryView& primary,
             WeightedGap weighted_gap, double soft_modulus, bool friction);

  /// (N) those that cannot move along the normal hand their functions on.
  void set_prescribed(const std::vector<char>& prescribed);

  /// Means of the points' readings at the nodes, the law there, and tractions at the points.
  /// Collective.
  void evaluate(const PrimaryView& primary, const PointArrays& points, const PointTerms& terms);
  /// The gaps of the readings become those of the last converged step, and decide where those of
  /// the nodes count from. An overlap of the points themselves would not do: its average leaves
  /// gaps that are closed where nothing overlaps. Collective.
  void start(const PrimaryView& primary, const PointArrays& points, const Settings& settings,
             const StartTerms& terms);
  /// What the nodes have of it, interpolated at a point.
  SiteStart start_at(Local face, Local point) const;
  /// Newton goes on from this iterate.
  void take_iterate(bool new_step);
  /// Multipliers have changed: statuses stay until the next iterate is taken.
  void freeze();

  /// pressures: (N) that become the multipliers.
  void set_multipliers(const std::vector<double>& pressures);
  /// The shear of the nodes becomes their multiplier, stored where each point turns it.
  void store_shear(const PrimaryView& primary);
  void set_shear(Local node, const Vec3& shear) { arrays_.state(node).site.shear = shear; }
  void accept();
  void reject();

  const NodalArrays& arrays() const { return arrays_; }
  const CornerSpace& corners() const { return corners_; }
  /// Whether the node takes part and this rank speaks for it.
  bool counts(Local node) const {
    return arrays_.state(node).area > 0.0 && corners_.owner(node) == comm_.rank();
  }
  bool settled() const; ///< the status of every node is that of the return map
  /// Length slipped by a node in the step, and friction work per area.
  double slipped(Local node) const;
  double dissipated(Local node) const;
  /// Value at node a of the face (corners, middle nodes, center) of the field that has
  /// `value(site)` at the nodes that take part.
  template <class F> auto face_value(Local face, int a, F value) const;
  /// The same at a point.
  template <class F> auto interpolate(Local face, Local point, F value) const {
    auto sum = arrays_.field_at(point, 0) * value(arrays_.state(arrays_.node(face, 0)));
    for (int b = 1; b < arrays_.corners(face); ++b)
      sum += arrays_.field_at(point, b) * value(arrays_.state(arrays_.node(face, b)));
    return sum;
  }

private:
  void make_functions(const PrimaryView& primary);
  void measure_nodes(const PrimaryView& primary, double soft_modulus);
  View<double> gather(const PrimaryView& primary, const PointArrays& points, int width);
  int width() const { return friction_ ? 12 : 6; }

  Comm comm_;
  const CornerSpace& corners_;
  NodalArrays arrays_;
  bool friction_;
};

template <class F> auto NodalSpace::face_value(Local face, int a, F value) const {
  const int n = arrays_.corners(face);
  const auto at_corner = [&](int c) {
    const double* take = &arrays_.take((face * max_corners + c) * max_corners);
    auto sum = take[0] * value(arrays_.state(arrays_.node(face, 0)));
    for (int b = 1; b < n; ++b)
      sum += take[b] * value(arrays_.state(arrays_.node(face, b)));
    return sum;
  };
  if (a < n)
    return at_corner(a);
  if (a < 2 * n)
    return 0.5 * (at_corner(a - n) + at_corner((a - n + 1) % n));
  return 0.25 * (at_corner(0) + at_corner(1) + at_corner(2) + at_corner(3));
}

} // namespace abut::contact
