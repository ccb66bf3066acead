// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/facet_gap.hpp"
#include "abut/contact/facing_surface.hpp"
#include "abut/contact/options.hpp"
#include "abut/core/contribution.hpp"
#include "abut/core/log.hpp"
#include "abut/fem/quadrature.hpp"

#include <array>
#include <map>

namespace abut::contact {

/// What one contact interface carries, over all ranks.
struct ContactSummary {
  Global active_points = 0;
  std::array<double, 3> force{};   ///< on the primary surface [force]
  double max_pressure = 0.0;       ///< of the nodal pressure; Cauchy [pressure]
  double max_point_pressure = 0.0; ///< of the points' pressure; Cauchy [pressure]
  double max_penetration = 0.0;    ///< [length]
  double max_penetration_over_face_size = 0.0;
  double min_gap = 0.0, max_gap = 0.0; ///< over points with a partner [length]
  Global points = 0, paired_points = 0;
  double area = 0.0; ///< reference area of active points [length^2]
};

/// What the next augmentation would do.
struct Augmentation {
  double change = 0.0;    ///< relative change of the multipliers, L2 [1]
  double gap = 0.0;       ///< largest penetration over face size [1]
  bool converged = false; ///< both tolerances hold
  bool stalled = false;   ///< the penetration has not fallen over several augmentations
};

/// A point that is in contact or touches.
struct ClosedPoint {
  Local primary_node;    ///< a surface node of its primary face
  Global secondary_node; ///< a mesh node of its secondary face
  Vec3 x, normal;        ///< position [length], secondary normal
};

/// Weighted sums at the nodes of the primary faces of a rank; divide by weight after summing over
/// ranks. One entry for each surface node of the primary surface.
struct NodalSums {
  std::vector<double> weight, pressure, gap,
      status;                   ///< status: 0 open, 1 slip, 2 stick (sum of weights)
  std::vector<double> traction; ///< (nodes, 3)
};

/// One integration point of a primary face: history and what the present configuration gives it.
struct PointState {
  double multiplier = 0.0;           ///< trial; per reference area [pressure]
  double converged_multiplier = 0.0; ///< at the last converged step
  Local facing = -1;                 ///< secondary face in FacingSurface, -1: no partner in reach
  Local left = -1;                   ///< secondary face that was the partner before
  int returns = 0;                   ///< times the point went back to it in this step
  double xi[2] = {0.0, 0.0};         ///< projection on it
  double gap = 0.0;                  ///< > 0 open [length]
  double penalty = 0.0;              ///< [pressure/length]
  double pressure = 0.0;             ///< per reference area [pressure]
  bool active = false;               ///< in contact, or touching without pressure
};

/// Frictionless facet-on-facet contact of two surfaces (theory: eq. 564-596), penalty or augmented
/// Lagrangian. Points are Gauss points of the primary faces, (I,P) with I faces and P points each.
/// Usable on its own: it takes surfaces, options and a communicator, and gives residual and tangent
/// blocks over global node numbers. Kokkos must be initialised while it lives.
class Interaction : public Contribution {
public:
  /// Throws InputError when neither surface is deformable and no penalty is given, or a surface is
  /// empty. Collective.
  Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
              ContactOptions options, PhaseTimers& timers);
  Interaction(const Interaction&) = delete;
  Interaction& operator=(const Interaction&) = delete;

  const char* name() const override { return options_.name.c_str(); }
  Phase phase() const override { return Phase::contact; }
  void prepare(const NodalFields& fields) override;
  const Connectivity& connectivity() const override { return pairs_; }
  long connectivity_version() const override { return version_; }
  const Connectivity& candidates() const override;
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;
  void accept() override;
  void reject() override;

  /// How far the multipliers are from <lambda - eps gap> in the last prepared configuration.
  /// Collective.
  Augmentation augmentation() const;
  /// lambda <- <lambda - eps gap> at every point. Collective. Prepare again before the next
  /// residual.
  void augment();

  ContactSummary summary() const; ///< Collective.
  NodalSums nodal_sums() const;
  std::vector<ClosedPoint> closed_points() const; ///< of this rank
  const mesh::Surface& primary() const { return primary_; }
  const ContactOptions& options() const { return options_; }
  const std::vector<PointState>& points() const { return points_; } ///< (I,P)
  double softest_modulus() const { return softest_modulus_; }

  /// Whether opposed normals were found for the points that have a partner within one face size
  /// when facing is ignored: share of such points whose normals point the same way. Collective.
  double wrong_facing_share() const;

private:
  struct Pair {
    Local face, facing;
    std::vector<Local> points; ///< active
  };
  struct Frame { ///< one point in the current configuration
    Vec3 x, normal;
  };
  void move_origin();
  Frame frame(Local face, int point) const;
  void current_coordinates(const NodalFields& fields);
  void collect_if_moved();
  void project_points();
  void project(Local face, int point);
  void build_pairs();
  double penalty_of(Local face, Local facing) const;
  const fem::Rule<2>& rule(Local face) const;
  const std::vector<double>& shape(Local face) const; ///< (P, nodes)
  Local point_index(Local face, int p) const { return first_point_[face] + p; }
  int face_points(Local face) const { return first_point_[face + 1] - first_point_[face]; }
  void primary_coordinates(Local face, bool reference, Vec3* x) const;
  double current_area_ratio(Local face, int point) const;

  Comm comm_;
  mesh::Surface primary_, secondary_; ///< coordinates relative to origin_
  Vec3 origin_ = Vec3::zero();
  ContactOptions options_;
  PhaseTimers& timers_;
  FacingSurface facing_;
  double softest_modulus_ = 0.0;
  double slack_ = 0.0;       ///< motion after which faces are collected anew [length]
  std::vector<double> size_; ///< (primary faces) [length]
  std::map<fem::FaceType, fem::Rule<2>> rules_;
  std::map<fem::FaceType, std::vector<double>> shapes_;
  std::vector<Local> first_point_{0};
  std::vector<PointState> points_;
  std::vector<double> weight_; ///< (I,P) quadrature weight times reference area [length^2]
  std::vector<double> x_primary_, x_secondary_; ///< current (nodes, 3)
  bool collected_ = false;                      ///< on all ranks together
  std::vector<double> x_primary_collected_, x_secondary_collected_;
  std::vector<Pair> pair_list_;
  Connectivity pairs_;
  mutable Connectivity candidates_;
  long version_ = 0;
  std::vector<double> last_gaps_; ///< largest penetration before each augmentation of the step
};

} // namespace abut::contact
