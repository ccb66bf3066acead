// SPDX-License-Identifier: BSD-3-Clause
// Which rule holds at a point: open, stick or slip, by the return map of its friction.
#include "constants.hpp"
#include "dual_law.hpp"
#include "point_search.hpp"
#include "prediction.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace abut::contact {

namespace {

Vec3 tangential(const Vec3& v, const Vec3& normal) {
  return v - dot(normal, v) * normal;
}

} // namespace

ContactPoint Interaction::contact_point(Local face, int point, const Vec3* y_previous) const {
  const Local index = point_index(face, point);
  const PointState& state = points_[index];
  ContactPoint c;
  c.rule = state.rule;
  c.ray = options_.uses_ray();
  c.shape = shape(face, point);
  c.weight = share_ * (c.ray ? weight_[index] : area_[index]);
  c.penalty = state.penalty;
  c.friction = friction_;
  c.offset = state.offset;
  c.multiplier = state.multiplier;
  c.carried = state.history.carried;
  c.line = state.line;
  c.face = state.facing >= 0 ? facing_.type(state.facing) : fem::FaceType::quad4;
  c.xi[0] = state.xi[0];
  c.xi[1] = state.xi[1];
  c.anchor_face = state.anchor >= 0 ? facing_.type(state.anchor) : c.face;
  c.anchor_xi[0] = state.history.anchor_xi[0];
  c.anchor_xi[1] = state.history.anchor_xi[1];
  c.first = !state.converged.in_contact;
  c.previous_gap = state.converged.gap - state.offset;
  c.x_previous = primary_nodes_previous(face);
  c.y_previous = y_previous;
  return c;
}

void Interaction::evaluate_points() {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  Kokkos::parallel_for("abut::contact::evaluate",
                       Kokkos::RangePolicy<Execution>(0, primary_.num_faces()), [&](Local f) {
                         for (int p = 0; p < face_points(f); ++p) {
                           PointState& state = points_[point_index(f, p)];
                           const Status before = state.status();
                           evaluate(f, p);
                           state.flips = new_step_ ? 0 : state.flips + (state.status() != before);
                         }
                       });
}

double Interaction::present_offset(const PointState& state) const {
  const double fade =
      options_.initial_overlap == InitialOverlap::resolve ? std::max(0.0, 1.0 - time_ / end_) : 1.0;
  return options_.offset - fade * state.overlap;
}

/// A tied point or one that sticks needs no search; the others look for their partner.
void Interaction::evaluate(Local face, int point) {
  PointState& state = points_[point_index(face, point)];
  const auto at = primary_point(shape(face, point), primary_nodes(face));
  state.offset = present_offset(state);
  state.anchor = state.history.anchor >= 0 ? facing_.find(state.history.anchor) : -1;
  const bool anchors =
      options_.tied || (friction_ > 0.0 && options_.map() != FrictionMap::incremental);
  if (anchors && state.anchor >= 0 && evaluate_anchored(face, point, at))
    return;
  if (options_.tied) {
    state.facing = -1;
    state.gap = options_.reach * size_[face];
    set_traction(face, point, PointRule::open);
    return;
  }
  evaluate_partner(face, point, at);
}

/// Stick against the anchor, or slip along the inclined ray. False: the formulation's own search
/// must decide.
bool Interaction::evaluate_anchored(Local face, int point, const PrimaryPoint<double>& at) {
  PointState& state = points_[point_index(face, point)];
  state.penalty = penalty_of(face, state.anchor);
  state.multiplier = state.history.multiplier;
  const ContactPoint c = contact_point(face, point, nullptr);
  Vec3 z[fem::max_face_nodes];
  facing_.coordinates(state.anchor, z);
  const Vec3 trial = anchored_trial(c, at, z);
  const double pressure = -dot(at.normal, trial);
  const Vec3 w = tangential(trial, at.normal);
  const bool beyond = norm(w) > friction_ * pressure;
  const bool sticks =
      options_.tied || !switched(face, state.anchor, state, w, at.normal, pressure).slips;
  state.settled = options_.tied || sticks != beyond;
  if (sticks && (options_.tied || pressure > 0.0 || options_.tension)) {
    state.facing = state.anchor;
    state.xi[0] = state.history.anchor_xi[0];
    state.xi[1] = state.history.anchor_xi[1];
    set_traction(face, point, PointRule::anchored);
    return true;
  }
  return options_.map() == FrictionMap::inclined_ray && norm(w) > 0.0 &&
         evaluate_inclined(face, point, at, trial);
}

bool Interaction::evaluate_inclined(Local face, int point, const PrimaryPoint<double>& at,
                                    const Vec3& trial) {
  PointState& state = points_[point_index(face, point)];
  Query q = query(face, point, at);
  q.line = true;
  inclined_ray(contact_point(face, point, nullptr), at, trial, q.origin, q.direction);
  if (q.last < 0) {
    q.last = state.anchor;
    std::copy_n(state.history.anchor_xi, 2, q.last_xi);
  }
  const Partner hit = find(q);
  if (hit.face < 0)
    return false;
  Vec3 y[fem::max_face_nodes];
  facing_.coordinates(hit.face, y);
  fem::FacePoint<double> on;
  fem::face_point(facing_.type(hit.face), y, hit.xi, on);
  state.near = state.facing = hit.face;
  for (int i = 0; i < 2; ++i)
    state.near_xi[i] = state.xi[i] = hit.xi[i];
  state.gap = hit.gap;
  const bool presses = dot(on.x - q.origin, q.direction) > 0.0;
  set_traction(face, point, presses ? PointRule::inclined_slip : PointRule::open);
  return true;
}

void Interaction::evaluate_partner(Local face, int point, const PrimaryPoint<double>& at) {
  PointState& state = points_[point_index(face, point)];
  const bool was_open = !state.pressed();
  state.settled = true;
  const Partner best = lasting_partner(face, point, at);
  state.facing = best.face;
  if (best.face < 0) {
    state.gap = options_.reach * size_[face];
    set_traction(face, point, PointRule::open);
    return;
  }
  state.xi[0] = best.xi[0];
  state.xi[1] = best.xi[1];
  state.gap = best.gap;
  const bool pulls = normal_response(face, state);
  const double pressure = state.multiplier - state.penalty * effective_gap(state);
  // At the kink itself the stiff side of the derivative is taken: bodies that just touch hold.
  const double margin = state.penalty * touching_gap * size_[face];
  if ((pressure <= -margin && !pulls) || (frozen_ && was_open && !state.touching) ||
      (predicting_ && stays_open(state.converged, size_[face]))) {
    set_traction(face, point, PointRule::open);
    return;
  }
  Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
  facing_.coordinates(best.face, y);
  facing_.previous_coordinates(best.face, y_previous);
  const ContactPoint c = contact_point(face, point, y_previous);
  const bool touching = pressure <= 0.0 && !pulls;
  PointRule rule = PointRule::frictionless;
  if (friction_ > 0.0 && touching)
    rule = PointRule::incremental_stick;
  else if (friction_ > 0.0 && pressure > 0.0 &&
           (!normal_law_ || state.penalty == penalty_of(face, best.face)))
    rule = sliding_rule(face, state, c, at, y);
  set_traction(face, point, rule);
  if (touching) {
    state.touching = true;
    state.pressure = 0.0;
    state.traction = Vec3::zero();
  }
}

/// Straight line through the law at the present gap: its value and slope are all that a solve
/// needs. True when the point may pull.
bool Interaction::normal_response(Local face, PointState& state) const {
  state.penalty = penalty_of(face, state.facing);
  state.multiplier = state.history.multiplier;
  if (!normal_law_)
    return options_.tension && state.converged.in_contact;
  const double gap = effective_gap(state);
  const NormalResponse response = normal_law_(gap, state.penalty);
  state.penalty = response.stiffness;
  state.multiplier = response.pressure + response.stiffness * gap;
  return response.pressure < 0.0 || response.stiffness < 0.0;
}

/// Radial return on the cone of the present pressure; the literal map only slips here.
PointRule Interaction::sliding_rule(Local face, PointState& state, const ContactPoint& c,
                                    const PrimaryPoint<double>& at, const Vec3* y) const {
  if (options_.map() == FrictionMap::literal)
    return PointRule::literal_slip;
  const auto partner = contact_partner(c, at, y);
  const double pressure = c.multiplier - c.penalty * (partner.gap - c.offset);
  const Vec3 trial = incremental_trial(c, at, partner);
  const ShearChoice choice = switched(face, state.facing, state, trial, partner.c, pressure);
  state.line = choice.line;
  state.settled = choice.settled;
  return choice.slips ? PointRule::incremental_slip : PointRule::incremental_stick;
}

/// Stick or slip under the present trial shear; a frozen point stays with what it does.
ShearChoice Interaction::switched(Local face, Local facing, const PointState& state,
                                  const Vec3& trial, const Vec3& normal, double pressure) const {
  double share = 1.0;
  if (options_.friction_switching == FrictionSwitching::primal_dual)
    share = std::min(1.0, soft_switching * softest_modulus_ * inverse_depth(face, facing) /
                              state.penalty);
  std::optional<bool> held;
  if (frozen_ && state.rule != PointRule::open && state.rule != PointRule::frictionless)
    held = state.rule != PointRule::incremental_stick && state.rule != PointRule::anchored;
  return choose_shear(state.last, trial, normal, friction_ * std::max(0.0, pressure), share, held);
}

/// What switching starts from in the next configuration.
void Interaction::keep_iterate() {
  if (friction_ == 0.0)
    return;
  if (dual_)
    return dual_->keep_iterate();
  for (PointState& state : points_) {
    state.last = {state.pressed(), state.status() == Status::slip, state.line};
    if (state.rule != PointRule::inclined_slip)
      continue;
    const Vec3 shear = state.traction - state.pressure * state.normal;
    const double size = norm(shear);
    state.last.line = {size > 0.0 ? (1.0 / size) * shear : Vec3::zero(), 0.0};
  }
}

bool Interaction::settled() const {
  if (dual_)
    return dual_->settled();
  return std::all_of(points_.begin(), points_.end(),
                     [](const PointState& p) { return !p.pressed() || p.settled; });
}

/// Traction, pressure and gap of the point under the rule.
void Interaction::set_traction(Local face, int point, PointRule rule) {
  PointState& state = points_[point_index(face, point)];
  state.rule = rule;
  state.touching = false;
  if (rule != PointRule::incremental_slip)
    state.line = {};
  if (rule == PointRule::open) {
    state.pressure = 0.0;
    state.traction = Vec3::zero();
    return;
  }
  Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes], z[fem::max_face_nodes];
  facing_.coordinates(state.facing, y);
  facing_.previous_coordinates(state.facing, y_previous);
  if (state.anchor >= 0)
    facing_.coordinates(state.anchor, z);
  const ContactPoint c = contact_point(face, point, y_previous);
  const auto t = point_traction<double>(c, primary_nodes(face), y, z);
  state.traction = t.traction;
  state.pressure = t.pressure;
  state.gap = t.gap;
  state.normal = t.c;
}

} // namespace abut::contact
