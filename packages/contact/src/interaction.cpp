// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "history/steps.hpp"
#include "interaction_parts.hpp"
#include "kernels/node_tangent.hpp"
#include "kernels/pair_forces.hpp"
#include "kernels/read_points.hpp"
#include "multipliers/sites.hpp"
#include "report/report.hpp"
#include "spaces/prescribed.hpp"

#include <algorithm>

namespace abut::contact {

Interaction::Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                         ContactOptions options, PhaseTimers& timers, double share)
    : parts_(std::make_unique<Parts>(comm, std::move(primary), std::move(secondary), options,
                                     timers, share)) {}

Interaction::~Interaction() = default;

void Interaction::set_schedules(std::function<double(double)> penalty,
                                std::function<double(double)> friction,
                                std::function<double(double)> interference) {
  parts_->penalty_schedule = std::move(penalty);
  parts_->friction_schedule = std::move(friction);
  parts_->interference_schedule = std::move(interference);
  ++parts_->state_version;
}

void Interaction::set_normal_law(NormalLaw law) {
  if (law && parts_->data.nodal)
    throw InputError("contact." + settings().name +
                     ": a normal law goes with 'multipliers: smoothed' or 'per_point'");
  parts_->normal_law = std::move(law);
  ++parts_->state_version;
}

void Interaction::set_update(MultiplierUpdate update) {
  parts_->augmenter.set_update(std::move(update));
}

void Interaction::set_exact_tangent(bool exact) {
  parts_->exact_tangent = exact;
}

void Interaction::set_end(double t) {
  parts_->end = t;
}

void Interaction::set_prescribed(const std::vector<char>& directions) {
  InterfaceData& data = parts_->data;
  data.held = held_nodes(data.surface(), data.corners, directions);
  if (data.nodal && settings().formulation != Formulation::node_on_facet)
    data.nodal->set_prescribed(data.held);
}

void Interaction::hold_by_nearest() {
  parts_->hold.ask_for();
  ++parts_->state_version;
}

bool Interaction::acts() const {
  return parts_->data.acts;
}
const char* Interaction::name() const {
  return settings().name.c_str();
}
const Connectivity& Interaction::connectivity() const {
  return parts_->connectivity;
}
long Interaction::connectivity_version() const {
  return parts_->connectivity_version;
}
long Interaction::state_version() const {
  return parts_->state_version;
}
const mesh::Surface& Interaction::primary() const {
  return parts_->data.surface();
}
const Settings& Interaction::settings() const {
  return parts_->data.settings;
}

void Interaction::Parts::set_terms(double time) {
  const Settings& o = data.settings;
  PointTerms& terms = data.terms;
  const double scale = penalty_schedule ? penalty_schedule(time) : 1.0;
  const bool given = o.penalty_source == PenaltySource::given;
  terms.law.friction = o.friction * (friction_schedule ? friction_schedule(time) : 1.0);
  terms.law.predicting = solve == SolveKind::prediction && established;
  terms.softest = solve == SolveKind::approach || seeks_hold() ? o.modulus : 0.0;
  // Means over nodes jump where points change faces, and their functions have both signs: far from
  // balance that leads in circles.
  terms.at_nodes = data.nodal && !from_afar() && !seeks_hold();
  terms.anchored_map =
      o.anchors() || (terms.law.friction > 0.0 && o.friction_map != FrictionMap::incremental);
  terms.user_law = bool(normal_law);
  terms.penalty = given ? scale * o.penalty : 0.0;
  terms.stiffness = given ? 0.0 : scale * data.factor * o.modulus;
  const double whole = std::min(o.window.until.value_or(end), end);
  const double left =
      std::max(0.0, std::min(1.0, 1.0 - (time - o.window.from) / (whole - o.window.from)));
  terms.start.fade = o.initial_overlap == InitialOverlap::adjust    ? 1.0
                     : o.initial_overlap == InitialOverlap::resolve ? left
                                                                    : 0.0;
  terms.start.interference =
      o.interference * (interference_schedule ? interference_schedule(time) : 1.0 - left);
  terms.search_hold = step_iterates >= o.segment_updates ? frozen_margin : 0.0;
}

void Interaction::prepare(const NodalFields& fields) {
  Parts& p = *parts_;
  const PhaseTimers::Scope scope(p.timers, Phase::search);
  p.set_terms(fields.time);
  p.data.place.move(fields);
  p.augmenter.forget_proposal();
  p.data.acts = settings().window.holds(fields.time);
  if (!p.data.acts)
    return p.rest();
  if (!p.started)
    begin_history(p.data);
  p.started = true;
  p.data.place.follow();
  p.evaluate_sites();
  p.build_pairs();
}

void Interaction::Parts::rest() {
  hold.rest();
  Kokkos::deep_copy(data.points.state, PointState());
  Kokkos::deep_copy(data.points.reading, SiteReading());
  if (data.nodal)
    data.nodal->evaluate(data.primary(), data.points, data.terms);
  build_pairs();
}

namespace {

/// Straight line through a law of the host's own at the present gap: its value and slope are all
/// that a solve needs.
void apply_law(const NormalLaw& law, const PointArrays& points) {
  for (Local i = 0; i < points.size(); ++i) {
    SiteReading& r = points.reading(i);
    if (!r.covered)
      continue;
    const NormalResponse response = law(r.gap, r.penalty);
    r.pulls = response.pressure < 0.0 || response.stiffness < 0.0;
    r.slides = response.stiffness == r.penalty; // tangential springs are those of the penalty
    r.penalty = response.stiffness;
    r.multiplier = response.pressure + response.stiffness * r.gap;
  }
}

} // namespace

void Interaction::Parts::evaluate_sites() {
  const Local points = data.points.size();
  Kokkos::parallel_for("abut::contact::read_points", Range(0, points),
                       ReadPoints{data.place.search(), data.points, data.terms});
  if (normal_law)
    apply_law(normal_law, data.points);
  data.terms.law.hair = 0.0;
  if (may_hold())
    hold.look(data, seeks_hold());
  if (data.terms.at_nodes)
    data.nodal->evaluate(data.primary(), data.points, data.terms);
  else
    Kokkos::parallel_for("abut::contact::decide_points", Range(0, points),
                         DecidePoints{data.primary(), data.facing(), data.points, data.terms});
}

void Interaction::Parts::add_node_rows(const NodeRowArrays& rows) const {
  Kokkos::parallel_for("abut::contact::node_rows", Range(0, pairs.size()),
                       AddNodeRows{data.primary(), data.facing(), data.points, pairs,
                                   data.nodal->arrays(), rows, data.terms});
}

void Interaction::Parts::build_pairs() {
  Connectivity cells;
  pairs = make_pairs(data.primary(), data.facing(), data.points, cells);
  if (data.terms.at_nodes)
    node_cells.build(
        data.comm, data.surface(), data.corners, data.nodal->arrays(), pairs,
        [this](const NodeRowArrays& rows) { add_node_rows(rows); }, cells);
  if (cells.nodes == connectivity.nodes && cells.offsets == connectivity.offsets)
    return;
  connectivity = std::move(cells);
  ++connectivity_version;
}

const Connectivity& Interaction::candidates() const {
  const InterfaceData& data = parts_->data;
  Connectivity& cells = parts_->candidates;
  cells.clear();
  if (!data.acts)
    return cells;
  std::vector<Local> face; // (candidates)
  data.place.near_pairs(cells, face);
  if (!data.nodal)
    return cells;
  // Room for the cells of nodes whose faces come near the other surface.
  std::vector<std::vector<Global>> columns(std::size_t(data.corners.nodes()));
  for (std::size_t i = 0; i < face.size(); ++i)
    for (int a = 0; a < data.corners.corners(face[i]); ++a) {
      auto& list = columns[data.corners.nodes(face[i])[a]];
      list.insert(list.end(), cells.nodes.begin() + cells.offsets[i],
                  cells.nodes.begin() + cells.offsets[i + 1]);
    }
  join_columns(data.comm, data.surface(), data.corners, columns);
  for (const std::vector<Global>& list : columns)
    if (!list.empty())
      cells.add(list.data(), static_cast<Local>(list.size()));
  return cells;
}

bool Interaction::symmetric() const {
  const Settings& o = settings();
  if (o.tangent == Tangent::symmetric)
    return true;
  return !o.ray() && !o.anchors() && !o.nonsymmetric_nodes() && o.friction == 0.0;
}

/// A gap is a difference of positions: it is known to a few units in their last place.
double Interaction::round_off_force2() const {
  constexpr double last_place = 1e-15;
  const InterfaceData& data = parts_->data;
  double sum = 0.0;
  for (Local i = 0; i < data.points.size(); ++i) {
    const PointState& state = data.points.state(i);
    if (!state.site.active())
      continue;
    const double known = last_place * norm(data.primary().now(data.primary().face(i))[0]);
    const double force = data.measure(i) * state.penalty * known;
    sum += force * force;
  }
  return sum;
}

bool Interaction::settled() const {
  const InterfaceData& data = parts_->data;
  if (data.terms.at_nodes)
    return data.nodal->settled();
  for (Local i = 0; i < data.points.size(); ++i)
    if (data.points.state(i).site.pressed() && !data.points.state(i).site.settled)
      return false;
  return true;
}

/// In contact that was there before the step, pressures beyond the modulus may be those of a body
/// that is confined, and the contact's edge has a short way to go.
bool Interaction::overloaded() const {
  const InterfaceData& data = parts_->data;
  const double modulus = settings().modulus;
  if (modulus <= 0.0 || parts_->established)
    return false;
  if (parts_->may_hold() && parts_->hold.is_apart())
    return true;
  if (data.terms.at_nodes) {
    const NodalArrays& nodes = data.nodal->arrays();
    for (Local n = 0; n < nodes.nodes(); ++n)
      if (nodes.site(n).pressure > modulus)
        return true;
    return false;
  }
  for (Local i = 0; i < data.points.size(); ++i)
    if (data.points.state(i).site.pressure > modulus)
      return true;
  return false;
}

bool Interaction::lands() const {
  return parts_->data.nodal && parts_->data.acts;
}

void Interaction::residual(const NodalFields&, const ResidualScatter& scatter) {
  const InterfaceData& data = parts_->data;
  Kokkos::parallel_for(
      "abut::contact::residual", Range(0, parts_->pairs.size()),
      PairResidual{data.primary(), data.facing(), data.points, parts_->pairs, data.terms, scatter});
}

void Interaction::tangent(const NodalFields&, const TangentScatter& scatter) {
  const InterfaceData& data = parts_->data;
  const Settings& o = settings();
  int singular = 0;
  Kokkos::parallel_reduce(
      "abut::contact::tangent", Range(0, parts_->pairs.size()),
      PairTangent{data.primary(), data.facing(), data.points, parts_->pairs, data.terms, scatter,
                  !parts_->exact_tangent && parts_->iterates < early_iterates,
                  o.tangent == Tangent::automatic, o.tangent == Tangent::symmetric},
      singular);
  if (data.terms.at_nodes) {
    parts_->node_cells.refill([this](const NodeRowArrays& r) { parts_->add_node_rows(r); });
    const NodeRowArrays& rows = parts_->node_cells.rows();
    Kokkos::parallel_for("abut::contact::node_tangent", Range(0, rows.size()),
                         ScatterNodes{data.nodal->arrays(), rows, scatter, parts_->pairs.size(),
                                      data.terms.law.friction, o.tangent == Tangent::symmetric});
  }
  if (singular > 0)
    throw SolveError("contact." + o.name + ": " + std::to_string(singular) +
                     " points lie at the centre of curvature of '" + data.place.secondary().name +
                     "', or their ray runs along it");
}

ContactSummary Interaction::summary() const {
  return summarize(parts_->data);
}
NodalSums Interaction::nodal_sums(Side side) const {
  return side == Side::primary ? primary_sums(parts_->data) : secondary_sums(parts_->data);
}
PointLists Interaction::points() const {
  return PointLists(*this);
}
std::vector<PointRecord> PointLists::records() const {
  return contact::records(parts_.data);
}
std::vector<ClosedPoint> PointLists::closed() const {
  return contact::closed_points(parts_.data, parts_.pairs);
}
std::vector<Site> PointLists::sites() const {
  const Sites sites(parts_.data);
  std::vector<Site> list;
  for (Local i = 0; i < sites.size(); ++i)
    list.push_back(sites[i]);
  return list;
}
double PointLists::friction() const {
  return parts_.data.terms.law.friction;
}
double Interaction::wrong_facing_share() const {
  return parts_->data.place.wrong_facing_share();
}

} // namespace abut::contact
