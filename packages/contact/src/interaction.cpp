// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"

#include "abut/contact/side_choice.hpp"
#include "abut/core/error.hpp"
#include "constants.hpp"
#include "dual_law.hpp"
#include "node_cells.hpp"

#include <algorithm>
#include <limits>

namespace abut::contact {

using search::Box;

namespace {

constexpr double pattern_pad = 0.5; ///< pairs this close, in face sizes, get room in the matrix
constexpr int summary_levels = 6;   ///< up to 2^6 boxes tell other ranks where this one's faces are

double smallest_positive(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::max();
  for (double v : values)
    if (v > 0.0)
      least = std::min(least, v);
  return least;
}

double largest_motion(const double* now, const double* then, std::size_t nodes) {
  double most = 0.0;
  for (std::size_t n = 0; n < nodes; ++n, now += 3, then += 3) {
    double d = 0.0;
    for (int i = 0; i < 3; ++i)
      d += (now[i] - then[i]) * (now[i] - then[i]);
    most = std::max(most, d);
  }
  return std::sqrt(most);
}

/// f of the automatic penalty where the deck gives none: soft with smoothed multipliers, whose
/// points are as accurate as their springs are soft; stiff with dual ones, which it only brings in
/// faster.
double first_factor(const ContactOptions& options) {
  if (options.penalty_factor > 0.0)
    return options.penalty_factor;
  if (options.enforcement == Enforcement::penalty || options.multipliers == Multipliers::per_point)
    return 10.0;
  return options.multipliers == Multipliers::smoothed ? 3.0 : 30.0;
}

/// Options with the space of the multipliers chosen.
ContactOptions resolved(ContactOptions options, const SideComparison& sides) {
  if (options.multipliers == Multipliers::automatic) {
    const bool dual = options.enforcement == Enforcement::augmented_lagrangian &&
                      options.goes_dual() && sides.suits_dual();
    options.multipliers = dual ? Multipliers::dual : Multipliers::smoothed;
  }
  return options;
}

} // namespace

Interaction::Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                         ContactOptions options, PhaseTimers& timers, double share)
    : comm_(comm), primary_(std::move(primary)), secondary_(std::move(secondary)),
      sides_(compare_sides(comm, primary_, secondary_)),
      options_(resolved(std::move(options), sides_)), timers_(timers), share_(share),
      self_(options_.primary == options_.secondary && !options_.primary.empty()),
      friction_(options_.friction), facing_(comm, secondary_, options_.reach),
      corners_(comm, primary_), factor_(first_factor(options_)), size_(face_sizes(primary_)),
      watch_(comm), anderson_(comm) {
  const std::string where = "contact." + options_.name + ": ";
  for (const mesh::Surface* s : {&primary_, &secondary_})
    if (comm_.sum(Global(s->num_faces())) == 0)
      throw InputError(where + "surface '" + s->name + "' has no faces");
  if (!options_.uses_ray() && (options_.friction_map == FrictionMap::inclined_ray ||
                               options_.friction_map == FrictionMap::literal))
    throw InputError(where + "this friction_map works along rays: it needs 'formulation: "
                             "sliding_elastic'");
  move_origin();
  softest_modulus_ = comm_.min(
      std::min(smallest_positive(primary_.modulus), smallest_positive(secondary_.modulus)));
  if (softest_modulus_ == std::numeric_limits<double>::max()) {
    softest_modulus_ = 0.0;
    if (options_.penalty <= 0.0)
      throw InputError(where + "both surfaces are rigid: give 'penalty' [pressure/length]");
  }
  double total = 0.0;
  for (double s : size_)
    total += s;
  for (double s : face_sizes(secondary_))
    total += s;
  slack_ = comm_.sum(total) /
           double(comm_.sum(Global(primary_.num_faces()) + Global(secondary_.num_faces())));
  smallest_size_ = size_.empty() ? std::numeric_limits<double>::max()
                                 : *std::min_element(size_.begin(), size_.end());
  smallest_size_ = comm_.min(smallest_size_);
  make_points();
  make_dual();
}

void Interaction::set_normal_law(NormalLaw law) {
  if (law && dual_)
    throw InputError("contact." + options_.name +
                     ": a normal law goes with 'multipliers: smoothed' or 'per_point'");
  normal_law_ = std::move(law);
}

void Interaction::set_schedules(std::function<double(double)> penalty,
                                std::function<double(double)> friction) {
  penalty_schedule_ = std::move(penalty);
  friction_schedule_ = std::move(friction);
}

/// Far from the mesh's own origin a gap would drown in the rounding of the current positions.
void Interaction::move_origin() {
  for (int i = 0; i < 3; ++i) {
    double low = std::numeric_limits<double>::max();
    for (const mesh::Surface* s : {&primary_, &secondary_})
      for (std::size_t n = 0; n < s->node.size(); ++n)
        low = std::min(low, s->x[3 * n + std::size_t(i)]);
    origin_[i] = comm_.min(low);
    for (mesh::Surface* s : {&primary_, &secondary_})
      for (std::size_t n = 0; n < s->node.size(); ++n)
        s->x[3 * n + std::size_t(i)] -= origin_[i];
  }
}

void Interaction::make_points() {
  const bool nodal = options_.formulation == Formulation::node_on_facet;
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const fem::FaceType type = primary_.type[f];
    const auto nodes = static_cast<std::size_t>(fem::face_nodes(type));
    Table& table = tables_[type];
    if (table.rule.size() == 0) {
      table.rule = nodal ? fem::nodal_rule(type)
                         : fem::face_rule(type, options_.points ? options_.points
                                                                : fem::default_points(type));
      for (const auto& xi : table.rule.xi) {
        double N[fem::max_face_nodes], dN[fem::max_face_nodes][2];
        fem::dispatch_face(type, [&](auto s) {
          decltype(s)::values(xi.data(), N);
          decltype(s)::derivatives(xi.data(), dN);
        });
        table.N.insert(table.N.end(), N, N + nodes);
        table.dN.insert(table.dN.end(), dN[0], dN[0] + 2 * nodes);
      }
    }
    table_.push_back(&table);
    first_node_.push_back(x_primary_.size());
    for (Local a = primary_.offset[f]; a < primary_.offset[f + 1]; ++a) {
      const double* x = &primary_.x[std::size_t(primary_.nodes[a]) * 3];
      x_primary_.push_back({{x[0], x[1], x[2]}});
    }
    for (int p = 0; p < table.rule.size(); ++p) {
      weight_.push_back(table.rule.weight[p]);
      area_.push_back(weight_.back() * primary_point(shape(f, p), primary_nodes(f)).area);
    }
    first_point_.push_back(first_point_.back() + table.rule.size());
  }
  points_.resize(weight_.size());
  stretch_.assign(size_.size(), 1.0);
  full_.assign(std::size_t(primary_.num_nodes()), 0.0);
  double N[CornerSpace::max_corners];
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      corners_.values(f, table_[f]->rule.xi[std::size_t(p)].data(), N);
      for (int a = 0; a < corners_.corners(f); ++a)
        full_[std::size_t(corners_.nodes(f)[a])] += N[a] * area_[point_index(f, p)];
    }
  corners_.sum(full_);
}

PointShape Interaction::shape(Local face, int point) const {
  const Table& table = *table_[face];
  const int nodes = fem::face_nodes(primary_.type[face]);
  const double* dN = &table.dN[std::size_t(point) * 2 * nodes];
  return {nodes, &table.N[std::size_t(point) * nodes], reinterpret_cast<const double(*)[2]>(dN)};
}

void Interaction::current_coordinates(const NodalFields& fields) {
  const auto move = [&](const mesh::Surface& s, std::size_t n, double* x) {
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = s.x[3 * n + i] + fields.u[std::size_t(s.field_index[n]) * fields.fields + i];
  };
  for (std::size_t a = 0; a < primary_.nodes.size(); ++a)
    move(primary_, std::size_t(primary_.nodes[a]), x_primary_[a].v);
  x_secondary_.resize(secondary_.x.size());
  for (std::size_t n = 0; n < secondary_.node.size(); ++n)
    move(secondary_, n, &x_secondary_[3 * n]);
}

void Interaction::collect_if_moved() {
  const auto motion_of_primary = [&](const std::vector<Vec3>& then) {
    return x_primary_.empty() ? 0.0 : largest_motion(x_primary_[0].v, then[0].v, x_primary_.size());
  };
  const auto motion_of_secondary = [&](const std::vector<double>& then) {
    return largest_motion(x_secondary_.data(), then.data(), x_secondary_.size() / 3);
  };
  motion_ = comm_.max(motion_of_primary(x_primary_previous_)) +
            comm_.max(motion_of_secondary(x_secondary_previous_));
  if (motion_ <= options_.reach * smallest_size_)
    motion_ = 0.0;
  if (collected_ && motion_ <= collected_motion_ &&
      comm_.max(motion_of_primary(x_primary_collected_)) +
              comm_.max(motion_of_secondary(x_secondary_collected_)) <=
          slack_) {
    facing_.update(x_secondary_);
    return;
  }
  collected_motion_ = motion_;
  std::vector<Global> near;
  for (const PointState& p : points_)
    near.push_back(p.near >= 0 ? facing_.face_id(p.near) : -1);
  collected_ = true;
  x_primary_collected_ = x_primary_;
  x_secondary_collected_ = x_secondary_;
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    Box<3> b = Box<3>::empty();
    for (int a = 0; a < fem::face_nodes(primary_.type[f]); ++a)
      b.add(primary_nodes(f)[a].v);
    b.inflate(std::max(options_.reach * size_[f], motion_) + slack_);
    boxes.push_back(b);
  }
  search::Bvh<3> tree;
  tree.build(boxes);
  facing_.collect(x_secondary_, x_secondary_previous_, tree.summary(summary_levels));
  for (std::size_t i = 0; i < points_.size(); ++i) { // face numbers are new
    points_[i].near = near[i] >= 0 ? facing_.find(near[i]) : -1;
    points_[i].facing = points_[i].left = -1;
  }
}

void Interaction::prepare(const NodalFields& fields) {
  const PhaseTimers::Scope scope(timers_, Phase::search);
  time_ = fields.time;
  predicting_ = fields.prediction && established_;
  penalty_scale_ = penalty_schedule_ ? penalty_schedule_(time_) : 1.0;
  friction_ = options_.friction * (friction_schedule_ ? friction_schedule_(time_) : 1.0);
  current_coordinates(fields);
  if (!started_) {
    x_primary_previous_ = x_primary_;
    x_secondary_previous_ = x_secondary_;
  }
  collect_if_moved();
  if (!started_)
    start();
  started_ = true;
  ++searches_;
  proposed_ = false;
  if (dual_)
    evaluate_nodes();
  else
    evaluate_points();
  frozen_ = new_step_ = false;
  build_pairs();
}

/// A/V of the primary element, or of the secondary one when the primary is rigid.
double Interaction::inverse_depth(Local face, Local facing) const {
  return primary_.modulus[face] > 0.0 ? primary_.inverse_depth[face]
                                      : facing_.inverse_depth(facing);
}

/// eps = f E A/V with E of the softer body (theory: eq. 595, 596).
double Interaction::penalty_of(Local face, Local facing) const {
  if (options_.penalty > 0.0)
    return penalty_scale_ * options_.penalty;
  return penalty_scale_ * factor_ * softest_modulus_ * inverse_depth(face, facing) * stretch_[face];
}

/// Active points grouped by primary face, the face that carries the force and the anchor's face.
void Interaction::build_pairs() {
  std::vector<Pair> list;
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const std::size_t first = list.size();
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      if (!state.active())
        continue;
      const Local anchor = state.rule == PointRule::inclined_slip && state.anchor != state.facing
                               ? state.anchor
                               : -1;
      auto it = std::find_if(
          list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
          [&](const Pair& pair) { return pair.facing == state.facing && pair.anchor == anchor; });
      if (it == list.end())
        it = list.insert(list.end(), Pair{f, state.facing, anchor, {}});
      it->points.push_back(p);
    }
  }
  Connectivity cells;
  for (const Pair& pair : list) {
    Global nodes[3 * fem::max_face_nodes];
    int n = 0;
    for (Local a = primary_.offset[pair.face]; a < primary_.offset[pair.face + 1]; ++a)
      nodes[n++] = primary_.node[primary_.nodes[a]];
    for (const Local secondary : {pair.facing, pair.anchor}) {
      if (secondary < 0)
        continue;
      facing_.global_nodes(secondary, nodes + n);
      n += facing_.nodes(secondary);
    }
    cells.add(nodes, n);
  }
  pair_list_ = std::move(list);
  if (dual_)
    add_node_cells(cells);
  if (cells.nodes == pairs_.nodes && cells.offsets == pairs_.offsets)
    return;
  pairs_ = std::move(cells);
  ++version_;
}

const Connectivity& Interaction::candidates() const {
  candidates_.clear();
  std::vector<Local> face; // (candidates)
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    Box<3> b = Box<3>::empty();
    for (int a = 0; a < fem::face_nodes(primary_.type[f]); ++a)
      b.add(primary_nodes(f)[a].v);
    b.inflate(pattern_pad * size_[f]);
    Global nodes[2 * fem::max_face_nodes];
    int n = 0;
    for (Local a = primary_.offset[f]; a < primary_.offset[f + 1]; ++a)
      nodes[n++] = primary_.node[primary_.nodes[a]];
    facing_.tree().traverse([&](const Box<3>& box) { return box.overlaps(b); },
                            [&](Local candidate) {
                              if (own_neighbour(f, candidate))
                                return;
                              facing_.global_nodes(candidate, nodes + n);
                              candidates_.add(nodes, n + facing_.nodes(candidate));
                              face.push_back(f);
                            });
  }
  if (dual_)
    add_node_candidates(candidates_, face);
  return candidates_;
}

} // namespace abut::contact
