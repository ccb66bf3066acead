// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/resolve.hpp"
#include "abut/core/contribution.hpp"
#include "kinematics/facet_rise.hpp"
#include "kinematics/partner_search.hpp"

namespace abut::contact {

/// Where both surfaces are, now and at the last converged step, and which secondary faces this
/// rank's points may meet.
class Configuration {
public:
  /// Coordinates are kept relative to the corner of both surfaces: far from the mesh's own origin a
  /// gap would drown in the rounding of the positions. Collective.
  Configuration(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                const Settings& settings, double mean_face_size);
  Configuration(const Configuration&) = delete;

  PrimarySurface& primary() { return primary_; }
  const PrimarySurface& primary() const { return primary_; }
  const mesh::Surface& secondary() const { return secondary_; }
  const PrimaryView& points() const { return primary_.view(); }
  const FacingView& facing() const { return facing_.view(); }
  const FacingSurface& facing_surface() const { return facing_; }
  bool self_contact() const { return self_; }
  const Vec3& origin() const { return origin_; }

  /// Present position of a node of a secondary face of this rank, less the origin.
  Vec3 secondary_position(Local face, int a) const {
    const double* x = &x_secondary_[3 * std::size_t(secondary_.nodes[secondary_.offset[face] + a])];
    return {{x[0], x[1], x[2]}};
  }

  /// By how much less than their faces the round surfaces stand apart at a point with this partner;
  /// without one, what the primary's own rise makes of it.
  double rise_between(Local point, const Partner& partner) const {
    const double own =
        rise_at(&primary_rise_[2 * std::size_t(points().face(point))], points().xi(point));
    return partner.face < 0 ? own
                            : own + rise_at(&facing().face_rise(2 * partner.face), partner.xi);
  }

  /// Moves both surfaces to where the fields have them; the first time it is where they start.
  void move(const NodalFields& fields);
  /// A run goes on from where the fields have both surfaces: that is the last converged step.
  void start_at(const NodalFields& fields);
  /// Brings the facing surface to the present configuration. Collective.
  void follow();
  /// Calls `work` in the configuration of the last converged step.
  void at_last_step(const std::function<void()>& work);
  /// The present configuration becomes that of the last converged step.
  void accept();
  /// The search in the present configuration, after follow().
  PartnerSearch search() const;
  /// Pairs this close, in face sizes, as lists of mesh nodes, with the primary face of each.
  void near_pairs(Connectivity& cells, std::vector<Local>& face) const;
  /// Share of the points with a face of the other surface within one face size whose normals point
  /// the same way. Collective.
  double wrong_facing_share() const;

private:
  void collect();

  Comm comm_;
  Vec3 origin_;
  PrimarySurface primary_;
  std::vector<double> primary_rise_; ///< (faces, 2)
  mesh::Surface secondary_;          ///< relative to origin_
  FacingSurface facing_;
  bool self_, line_;
  double reach_, margin_;
  double slack_;         ///< motion after which faces are collected anew [length]
  double smallest_size_; ///< of all primary faces [length]
  std::vector<double> x_secondary_, x_secondary_previous_; ///< (nodes, 3)
  bool placed_ = false;                                    ///< there is a configuration
  bool collected_ = false;                                 ///< on all ranks together
  double motion_ = 0.0;                                    ///< see PartnerSearch
  double collected_motion_ = 0.0;                          ///< of the last collection
  std::vector<Vec3> x_primary_collected_;
  std::vector<double> x_secondary_collected_;
};

} // namespace abut::contact
