// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_force.hpp"
#include "abut/core/types.hpp"

namespace abut::contact {

enum class Status : signed char { open, slip, stick };

/// What a point remembers. Newton reads it; only an augmentation and the end of a step write it.
struct PointHistory {
  double multiplier = 0.0; ///< of the pressure; negative in tension of tied points [pressure]
  StoredTraction carried;  ///< tangential multiplier or converged traction
  Global anchor = -1;      ///< id of the secondary face that holds the anchor; -1: none
  double anchor_xi[2] = {0.0, 0.0};
  StoredTraction rest;     ///< way to the anchor that strains nothing, offset taken off [length]
  bool in_contact = false; ///< at the last converged step
  bool torn = false;       ///< a sticky point that has come off in this step
  double gap = 0.0;        ///< then [length]
  Vec3 shear{{0, 0, 0}};   ///< traction along the contact then [pressure]
  double path = 0.0;       ///< length of the way slipped in contact so far [length]
  double sliding = 0.0;    ///< shear force of the last step if it slipped then, else 0 [force]
  double dissipated = 0.0; ///< friction work so far [energy]
};

/// One integration point of a primary face: history and what the present configuration gives it.
struct PointState {
  PointHistory history;   ///< trial
  PointHistory converged; ///< at the last converged step

  Local facing = -1;         ///< secondary face in FacingSurface that carries the force, -1: none
  Local anchor = -1;         ///< face of the anchor in FacingSurface, when there is one
  double xi[2] = {0.0, 0.0}; ///< partner on the face
  Local near = -1;           ///< face of the nearest partner: where the next search starts
  double near_xi[2] = {0.0, 0.0};
  Local left = -1; ///< face that was the nearest before
  int returns = 0; ///< times the point went back to it in this solve
  int losses = 0;  ///< times it was pressed and went over the rim, in this solve

  PointRule rule = PointRule::open;
  double gap = 0.0;         ///< > 0 open, offset not taken off [length]
  double offset = 0.0;      ///< gap that counts as zero now [length]
  double overlap = 0.0;     ///< of the meshes at the start [length]
  double penalty = 0.0;     ///< [pressure/length]
  double multiplier = 0.0;  ///< so that pressure = multiplier - penalty (gap - offset)
  double pressure = 0.0;    ///< per area of the formulation's measure; < 0 only in tension
  Vec3 traction{{0, 0, 0}}; ///< on the primary, of the same measure [pressure]
  Vec3 normal{{0, 0, 0}};   ///< contact normal, from the secondary to the primary
  SlipLine line;            ///< of incremental_slip
  bool settled = true;      ///< the shear is the return map's
  ShearIterate last;        ///< of the last Newton iterate
  int flips = 0;            ///< changes of status in this step
  bool touching = false;    ///< no pressure, but stiff: bodies that just touch hold

  /// Whether the point has a row in the tangent.
  bool active() const { return rule != PointRule::open; }
  /// Whether it exerts a force.
  bool pressed() const { return active() && !touching; }
  Status status() const {
    switch (rule) {
    case PointRule::open:
      return Status::open;
    case PointRule::incremental_stick:
    case PointRule::anchored:
      return touching ? Status::open : Status::stick;
    default:
      return touching ? Status::open : Status::slip;
    }
  }
};

} // namespace abut::contact
