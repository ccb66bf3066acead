// SPDX-License-Identifier: BSD-3-Clause
// What points remember: the start and the end of a step.
#include "abut/core/error.hpp"
#include "constants.hpp"
#include "dual_law.hpp"
#include "point_search.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

/// First search, in the configuration that the run starts from.
void Interaction::start() {
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      start_point(f, p);
      PointState& state = points_[point_index(f, p)];
      state.converged = state.history;
    }
}

/// Points that touch or overlap at the start are in contact already, so that their friction has an
/// anchor from the first step on.
void Interaction::start_point(Local f, int p) {
  PointState& state = points_[point_index(f, p)];
  const auto at = primary_point(shape(f, p), primary_nodes(f));
  const Partner best = nearest(f, p, at);
  if (best.face < 0)
    return;
  PointHistory& history = state.history;
  history.gap = best.gap;
  if (options_.initial_overlap != InitialOverlap::keep)
    state.overlap = std::max(0.0, options_.offset - best.gap);
  const double gap = best.gap - options_.offset;
  history.in_contact = options_.tied ? std::fabs(gap) <= options_.tie_distance * size_[f]
                                     : gap <= touching_gap * size_[f];
  if (!history.in_contact)
    return;
  history.anchor = facing_.face_id(best.face);
  history.anchor_xi[0] = best.xi[0];
  history.anchor_xi[1] = best.xi[1];
  if (!options_.tied)
    return;
  // The distance at the start strains nothing: lambda cancels it.
  Vec3 y[fem::max_face_nodes];
  facing_.coordinates(best.face, y);
  fem::FacePoint<double> on;
  fem::face_point(facing_.type(best.face), y, best.xi, on);
  const Vec3 lambda = -penalty_of(f, best.face) * (on.x - at.x - options_.offset * at.normal);
  history.multiplier = -dot(at.normal, lambda);
  history.carried = store_traction(at, lambda + history.multiplier * at.normal);
}

/// Part of the step's slip that no spring stores, tangent to the contact [length].
Vec3 Interaction::plastic_slip(Local f, int p, const PrimaryPoint<double>& at) const {
  const PointState& state = points_[point_index(f, p)];
  Vec3 y[fem::max_face_nodes], z[fem::max_face_nodes];
  facing_.coordinates(state.facing, y);
  if (state.rule == PointRule::inclined_slip) {
    facing_.coordinates(state.anchor, z);
    const ContactPoint c = contact_point(f, p, nullptr);
    fem::FacePoint<double> anchor, hit;
    fem::face_point(c.anchor_face, z, c.anchor_xi, anchor);
    fem::face_point(c.face, y, c.xi, hit);
    return anchor.x - hit.x;
  }
  facing_.previous_coordinates(state.facing, z);
  const ContactPoint c = contact_point(f, p, z);
  const Vec3 slip =
      contact_share(c, effective_gap(state)) * objective_slip(c, contact_partner(c, at, y));
  const Vec3 shear = state.traction - state.pressure * state.normal;
  return slip + (1.0 / state.penalty) * (shear - turned_traction(state.history.carried, at));
}

/// The trial state of the step becomes history. What each map carries on: the anchored maps their
/// anchor, moved where the point slipped; the incremental one its tangential traction.
void Interaction::advance_history(Local f, int p) {
  PointState& state = points_[point_index(f, p)];
  PointHistory& history = state.history;
  history.gap = state.facing >= 0 ? state.gap : options_.reach * size_[f];
  history.in_contact = state.active();
  if (!state.active()) {
    if (!options_.tied) {
      history.anchor = -1;
      history.carried = {};
    }
    return;
  }
  const double slid = history.sliding;
  history.sliding = 0.0;
  if (state.rule == PointRule::anchored)
    return;
  const auto at = primary_point(shape(f, p), primary_nodes(f));
  const Vec3 shear = state.traction - state.pressure * state.normal;
  const bool has_friction = state.rule != PointRule::frictionless;
  if (has_friction && state.status() == Status::slip) {
    const Vec3 slip = plastic_slip(f, p, at);
    const double way = norm(slip - dot(state.normal, slip) * state.normal);
    history.path += way;
    history.sliding = share_ * measure(f, p) * norm(shear);
    history.dissipated += way * (slid > 0.0 ? 0.5 * (slid + history.sliding) : history.sliding);
  }
  if (options_.map() != FrictionMap::incremental) {
    history.anchor = facing_.face_id(state.facing);
    history.anchor_xi[0] = state.xi[0];
    history.anchor_xi[1] = state.xi[1];
  }
  if (!has_friction)
    history.carried = {};
  else if (state.rule == PointRule::incremental_stick || state.rule == PointRule::incremental_slip)
    history.carried = store_traction(at, shear);
}

void Interaction::accept() {
  bool contact = false;
  choose_factor();
  const bool augments = options_.augments_at_end();
  if (dual_) {
    accept_nodes();
  } else if (augments) {
    Augmentation unused;
    propose(unused);
  }
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    for (int p = 0; p < face_points(f); ++p) {
      PointState& state = points_[point_index(f, p)];
      if (!dual_)
        advance_history(f, p);
      if (!dual_ && augments)
        take_multiplier(f, p, options_.tied || options_.map() != FrictionMap::incremental);
      state.history.shear =
          state.pressed() ? state.traction - state.pressure * state.normal : Vec3::zero();
      state.converged = state.history;
      contact = contact || state.converged.in_contact;
      state.returns = state.losses = 0;
      state.left = -1;
    }
    if (options_.update_penalty) {
      double now = 0.0, then = 0.0;
      for (int p = 0; p < face_points(f); ++p) {
        now += current_area(f, p);
        then += area_[point_index(f, p)];
      }
      stretch_[f] = then > 0.0 ? now / then : 1.0;
    }
  }
  established_ = comm_.any(contact);
  new_step_ = true;
  x_primary_previous_ = x_primary_;
  x_secondary_previous_ = x_secondary_;
  facing_.accept();
  watch_.clear();
  anderson_.clear();
  searches_ = 0;
}

void Interaction::reject() {
  if (dual_)
    dual_->reject();
  for (PointState& p : points_) {
    p.history = p.converged;
    p.last = {p.converged.in_contact, false, {}};
    p.returns = p.losses = 0;
    p.near = p.facing = p.left = -1; // the retry must not see where the failure led
  }
  watch_.clear();
  anderson_.clear();
  searches_ = 0;
  new_step_ = true;
  frozen_ = false;
}

} // namespace abut::contact
