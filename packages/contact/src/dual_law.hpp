// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/corner_space.hpp"
#include "abut/contact/friction_switch.hpp"
#include "abut/contact/interaction.hpp"

#include <array>

namespace abut::contact {

/// What the nodal law reads at a point.
struct DualPoint {
  bool covered = false; ///< it has a partner
  double gap = 0.0;     ///< less the offset [length]
  double penalty = 0.0; ///< [pressure/length]
  Vec3 normal = Vec3::zero();
  Vec3 slip = Vec3::zero();                             ///< in the step [length]
  std::array<Vec3, CornerSpace::max_corners> carried{}; ///< shear multipliers of the face's
                                                        ///< corners, turned with the point
};

/// What a node remembers; written by augmentations and at the end of a step only.
struct DualHistory {
  double multiplier = 0.0;   ///< [pressure]
  bool in_contact = false;   ///< at the last converged step
  double gap = 0.0;          ///< then, less the offset [length]
  Vec3 shear = Vec3::zero(); ///< tangential traction then [pressure]
  double sliding = 0.0;      ///< its size if the node slipped, else 0 [pressure]
};

/// A corner node of the primary surface, the same on every rank that has it.
struct DualNode {
  DualHistory history, converged;
  double full = 0.0; ///< integral of its corner function [length^2]
  double soft = 0.0; ///< stiffness that decides between stick and slip; 0: the penalty's own
                     ///< [pressure/length]
  double size = 0.0; ///< of its faces [length]

  double covered = 0.0; ///< part of `full` that has a partner [length^2]
  double area = 0.0;    ///< A, weight of its function at covered points; 0: takes no part
  double penalty = 0.0, gap = 0.0; ///< weighted means
  double normal_sum = 0.0;         ///< length of sum w psi c
  Vec3 normal = Vec3::zero(), slip = Vec3::zero(), carried = Vec3::zero();

  PointRule rule = PointRule::open;      ///< frictionless, or stick or slip of the incremental map
  bool touching = false;                 ///< no pressure, but stiff
  double share = 1.0, share_slope = 0.0; ///< of the step's slip, contact_share
  double pressure = 0.0;
  double out_of_plane = 0.0; ///< normal part of the trial traction before projection [pressure]
  Vec3 trial = Vec3::zero(), traction = Vec3::zero(); ///< tangential [pressure]
  SlipLine line;                                      ///< in slip, the law made linear
  bool settled = true;                                ///< the traction is the return map's
  ShearIterate last;                                  ///< of the last Newton iterate

  bool active() const { return rule != PointRule::open; }
  bool pressed() const { return active() && !touching; }
};

/// Signorini's law and Coulomb's at the corner nodes of the primary surface: gap and slip are
/// averaged with functions psi that are biorthogonal to the corner functions N, and the tractions
/// of the nodes act at the points through the same psi. docs/theory/multipliers.md
///
///   gap_I = sum w psi_I gap / A_I,  A_I = sum w psi_I,  p_I = <lambda_I - eps_I gap_I>,
///   p(q) = sum_I psi_I(q) p_I
///
/// Sums run over points that have a partner, w is the reference area. On faces where some points
/// have none N takes the place of psi, and a node with little cover hands its function on to the
/// other corners of each of its faces.
class DualLaw {
public:
  static constexpr int max_corners = CornerSpace::max_corners;

  /// first_point: (faces+1), xi: (I,P) places of the points, area: (I,P) their reference areas,
  /// size: (faces), soft: (faces) stiffness that decides between stick and slip on the way of
  /// Newton, 0: the return map decides [pressure/length]. surface and corners must outlive the law.
  /// Collective.
  DualLaw(const Comm& comm, const mesh::Surface& surface, const CornerSpace& corners,
          std::vector<Local> first_point, const std::vector<std::array<double, 2>>& xi,
          std::vector<double> area, const std::vector<double>& size,
          const std::vector<double>& soft, bool friction);

  /// (surface nodes) those that cannot move along the normal hand their functions on.
  void set_prescribed(std::vector<char> held) { prescribed_ = std::move(held); }

  /// Weighted means at the nodes. Collective.
  void gather(const std::vector<DualPoint>& points);
  /// The present gaps become those of the last converged step.
  void start();
  bool is_new() const { return is_new_; } ///< start has not been called
  /// Pressures, status and tractions of the nodes from their means.
  /// predicting: see NodalFields; frozen: no open node closes, no sticking or slipping one changes.
  void decide(double friction, bool frozen, bool predicting);
  /// The tractions that switching starts from in the next configuration.
  void keep_iterate();
  bool settled() const; ///< the status of every node is that of the return map

  Local first_point(Local face) const { return first_point_[face]; }
  int corners(Local face) const { return space_.corners(face); }
  const Local* corner_nodes(Local face) const { return space_.nodes(face); }
  const DualNode& node(Local surface_node) const { return nodes_[surface_node]; }
  const CornerSpace& space() const { return space_; }
  /// Whether the node takes part and this rank speaks for it.
  bool counts(Local node) const {
    return nodes_[node].area > 0.0 && space_.owner(node) == comm_.rank();
  }
  /// Functions of the face's corners at a point (index over all points): psi, which averages and
  /// exerts, and N, which interpolates; both with the shares of merged nodes. (corners)
  const double* psi(Local point) const { return &psi_[std::size_t(point) * max_corners]; }
  const double* field(Local point) const { return &field_[std::size_t(point) * max_corners]; }
  double area(Local point) const { return area_[point]; }
  /// Value at node a of the face (corners, middle nodes, center) of the field that has
  /// `value(node)` at the nodes that take part.
  template <class F> auto face_value(Local face, int a, F value) const;
  /// The same at a point of the face.
  template <class F> auto interpolate(Local face, int point, F value) const {
    const double* N = field(first_point_[face] + point);
    auto sum = N[0] * value(nodes_[corner_nodes(face)[0]]);
    for (int b = 1; b < corners(face); ++b)
      sum += N[b] * value(nodes_[corner_nodes(face)[b]]);
    return sum;
  }

  /// Shear multiplier of corner a of the point's face, stored on the point's axes.
  StoredTraction& carried(Local point, int a) {
    return carried_[std::size_t(point) * max_corners + std::size_t(a)];
  }
  const StoredTraction& carried(Local point, int a) const {
    return carried_[std::size_t(point) * max_corners + std::size_t(a)];
  }

  /// Largest penetration and motion in stick, change of the multipliers in L2; tells `watch` where.
  /// both_ways: a gap across which a node still presses counts too. Collective.
  Augmentation augmentation(PlateauWatch& watch, bool both_ways) const;
  /// pressures: (surface nodes) that become the multipliers, unless `update` changes them.
  void augment(const MultiplierUpdate& update, const std::vector<double>& pressures);
  /// Length slipped by a node in the step, and friction work per area.
  double slipped(const DualNode& node) const;
  double dissipated(const DualNode& node) const;
  void accept();
  void reject();

private:
  void cover(const std::vector<DualPoint>& points);
  void decide(DualNode& node, double friction, bool frozen, bool predicting) const;

  Comm comm_;
  const mesh::Surface& surface_;
  const CornerSpace& space_;
  std::vector<Local> first_point_;
  std::vector<double> area_;          ///< (I,P) [length^2]
  std::vector<double> corner_, dual_; ///< (I,P,max_corners) of the face alone: N and psi
  std::vector<double> psi_, field_;   ///< (I,P,max_corners) with cover and merging
  std::vector<double> take_;          ///< (I,max_corners,max_corners) share of N_a that b has
  std::vector<StoredTraction> carried_, carried_converged_; ///< (I,P,max_corners)
  std::vector<DualNode> nodes_;
  std::vector<char> prescribed_;
  bool friction_;
  bool is_new_ = true;
};

template <class F> auto DualLaw::face_value(Local face, int a, F value) const {
  const int n = corners(face);
  const auto at_corner = [&](int c) {
    const double* take = &take_[(std::size_t(face) * max_corners + std::size_t(c)) * max_corners];
    auto sum = take[0] * value(nodes_[corner_nodes(face)[0]]);
    for (int b = 1; b < n; ++b)
      sum += take[b] * value(nodes_[corner_nodes(face)[b]]);
    return sum;
  };
  if (a < n)
    return at_corner(a);
  if (a < 2 * n)
    return 0.5 * (at_corner(a - n) + at_corner((a - n + 1) % n));
  return 0.25 * (at_corner(0) + at_corner(1) + at_corner(2) + at_corner(3));
}

} // namespace abut::contact
