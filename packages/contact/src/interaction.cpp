// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/face_map.hpp"
#include "abut/search/closest_point.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <limits>

namespace abut::contact {

using search::Box;

namespace {

constexpr double pattern_pad = 0.5; ///< pairs this close, in face sizes, get room in the matrix
constexpr int summary_levels = 6;   ///< up to 2^6 boxes tell other ranks where this one's faces are
constexpr double touching = 1e-8;   ///< gap that counts as none in the tangent, in face sizes
constexpr double round_off = 1e-9;  ///< beside a face by no more than this is on it
constexpr double as_near = 0.01;    ///< difference of distances that decides nothing, in face sizes
constexpr double hold_margin =
    0.1;                  ///< a point that swings between two faces stays on one up to here
constexpr int swings = 2; ///< returns to the face just left that count as swinging
constexpr double outward_share = -1e-2; ///< cosine between normals below which faces oppose

double smallest_positive(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::max();
  for (double v : values)
    if (v > 0.0)
      least = std::min(least, v);
  return least;
}

} // namespace

Interaction::Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                         ContactOptions options, PhaseTimers& timers)
    : comm_(comm), primary_(std::move(primary)), secondary_(std::move(secondary)),
      options_(std::move(options)), timers_(timers), facing_(comm, secondary_, options_.reach),
      size_(face_sizes(primary_)) {
  const std::string where = "contact." + options_.name + ": ";
  for (const mesh::Surface* s : {&primary_, &secondary_})
    if (comm_.sum(Global(s->num_faces())) == 0)
      throw InputError(where + "surface '" + s->name + "' has no faces");
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

  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const fem::FaceType type = primary_.type[f];
    if (!rules_.count(type)) {
      rules_[type] =
          fem::face_rule(type, options_.points ? options_.points : fem::default_points(type));
      auto& table = shapes_[type];
      for (const auto& xi : rules_[type].xi) {
        double N[fem::max_face_nodes];
        fem::dispatch_face(type, [&](auto s) { decltype(s)::values(xi.data(), N); });
        table.insert(table.end(), N, N + fem::face_nodes(type));
      }
    }
    const fem::Rule<2>& r = rules_[type];
    Vec3 x[fem::max_face_nodes];
    primary_coordinates(f, true, x);
    for (int p = 0; p < r.size(); ++p) {
      fem::FacePoint<double> point;
      fem::face_point(type, x, r.xi[p].data(), point);
      weight_.push_back(r.weight[p] * norm(cross(point.tangent[0], point.tangent[1])));
    }
    first_point_.push_back(first_point_.back() + r.size());
  }
  points_.resize(weight_.size());
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

const fem::Rule<2>& Interaction::rule(Local face) const {
  return rules_.at(primary_.type[face]);
}

const std::vector<double>& Interaction::shape(Local face) const {
  return shapes_.at(primary_.type[face]);
}

void Interaction::primary_coordinates(Local face, bool reference, Vec3* x) const {
  const std::vector<double>& from = reference ? primary_.x : x_primary_;
  for (Local a = primary_.offset[face]; a < primary_.offset[face + 1]; ++a, ++x)
    for (int i = 0; i < 3; ++i)
      (*x)[i] = from[std::size_t(primary_.nodes[a]) * 3 + i];
}

void Interaction::current_coordinates(const NodalFields& fields) {
  const auto move = [&](const mesh::Surface& s, std::vector<double>& x) {
    x = s.x;
    for (std::size_t n = 0; n < s.node.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i)
        x[3 * n + i] += fields.u[std::size_t(s.field_index[n]) * fields.fields + i];
  };
  move(primary_, x_primary_);
  move(secondary_, x_secondary_);
}

void Interaction::collect_if_moved() {
  const auto motion = [&](const std::vector<double>& now, const std::vector<double>& then) {
    double most = 0.0;
    for (std::size_t n = 0; n + 2 < now.size(); n += 3) {
      double d = 0.0;
      for (std::size_t i = n; i < n + 3; ++i)
        d += (now[i] - then[i]) * (now[i] - then[i]);
      most = std::max(most, d);
    }
    return std::sqrt(most);
  };
  if (collected_ && comm_.max(motion(x_primary_, x_primary_collected_)) +
                            comm_.max(motion(x_secondary_, x_secondary_collected_)) <=
                        slack_) {
    facing_.update(x_secondary_);
    return;
  }
  collected_ = true;
  x_primary_collected_ = x_primary_;
  x_secondary_collected_ = x_secondary_;
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    Vec3 x[fem::max_face_nodes];
    primary_coordinates(f, false, x);
    Box<3> b = Box<3>::empty();
    for (int a = 0; a < fem::face_nodes(primary_.type[f]); ++a)
      b.add(x[a].v);
    b.inflate(options_.reach * size_[f] + slack_);
    boxes.push_back(b);
  }
  search::Bvh<3> tree;
  tree.build(boxes);
  facing_.collect(x_secondary_, tree.summary(summary_levels));
  for (PointState& p : points_)
    p.facing = p.left = -1; // face numbers are new
}

Interaction::Frame Interaction::frame(Local face, int point) const {
  Vec3 x[fem::max_face_nodes];
  primary_coordinates(face, false, x);
  fem::FacePoint<double> p;
  fem::face_point(primary_.type[face], x, rule(face).xi[point].data(), p);
  const Vec3 area = cross(p.tangent[0], p.tangent[1]);
  return {p.x, (1.0 / norm(area)) * area};
}

void Interaction::prepare(const NodalFields& fields) {
  const PhaseTimers::Scope scope(timers_, Phase::search);
  current_coordinates(fields);
  collect_if_moved();
  project_points();
  build_pairs();
}

void Interaction::project_points() {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  Kokkos::parallel_for("abut::contact::project",
                       Kokkos::RangePolicy<Execution>(0, primary_.num_faces()), [&](Local f) {
                         for (int p = 0; p < face_points(f); ++p)
                           project(f, p);
                       });
}

namespace {

/// A partner of a point while the search runs.
struct Partner {
  Local face = -1;
  double distance, gap, xi[2];

  /// Nearer, or as near with the lower face number: one partner on any number of ranks.
  bool beaten_by(double other_distance, Local other) const {
    return face < 0 || other_distance < distance || (other_distance == distance && other < face);
  }
};

} // namespace

/// Finds the nearest facing face on which the point projects. A projection within the margin beside
/// a face (the point lies above a concave edge, or just off the rim) counts only when no face with
/// a projection inside is about as near. Normals jump from face to face, so that a balance right at
/// an edge would be missed from both sides: a point that swings between two faces stays on one.
void Interaction::project(Local face, int p) {
  PointState& state = points_[point_index(face, p)];
  const Frame at = frame(face, p);
  const Local last = state.facing;
  const bool swinging = last >= 0 && state.returns >= swings;
  const double own_reach = options_.reach * size_[face];
  double limit = std::max(own_reach, options_.reach * facing_.largest_size());
  Partner inner, beside;
  const auto visit = [&](Local candidate) {
    const fem::FaceType type = facing_.type(candidate);
    Vec3 y[fem::max_face_nodes];
    facing_.coordinates(candidate, y);
    double start[2];
    fem::dispatch_face(type, [&](auto s) { decltype(s)::center(start); });
    if (candidate == last)
      start[0] = state.xi[0], start[1] = state.xi[1];
    const search::Projection found = search::project(type, y, at.x, start);
    if (!found.converged)
      return;
    const double unit = fem::is_triangle(type) ? 1.0 : 2.0; // length of a side in parameters
    const auto within = [&](double margin) {
      return fem::dispatch_face(
          type, [&](auto s) { return decltype(s)::inside(found.xi, margin * unit); });
    };
    const bool hold = swinging && candidate == last;
    if (!within(hold ? hold_margin : options_.projection_margin))
      return;
    const auto q = facet_gap<double>(type, y, at.x, found.xi);
    const double distance = std::fabs(q.gap);
    if (dot(q.normal, at.normal) > outward_share)
      return;
    if (distance > std::max(own_reach, options_.reach * facing_.size(candidate)))
      return;
    const bool is_inner = hold || within(round_off);
    Partner& partner = is_inner ? inner : beside;
    if (partner.beaten_by(distance, candidate))
      partner = {candidate, distance, q.gap, {found.xi[0], found.xi[1]}};
    if (is_inner)
      limit = std::min(limit, distance);
  };
  if (last >= 0)
    visit(last); // most likely still the nearest: it bounds the search
  const bool is_held = swinging && inner.face == last;
  if (!is_held)
    facing_.tree().traverse(
        [&](const Box<3>& box) { return box.distance2(at.x.v) <= limit * limit; },
        [&](Local candidate) {
          if (candidate != last)
            visit(candidate);
        });
  const bool prefer_inner =
      inner.face >= 0 &&
      (beside.face < 0 || inner.distance <= 2.0 * beside.distance + as_near * size_[face]);
  const Partner& best = prefer_inner ? inner : beside;
  if (last >= 0 && best.face >= 0 && best.face != last) {
    if (best.face == state.left)
      ++state.returns;
    state.left = last;
  }
  state.facing = best.face;
  if (best.face < 0) {
    state.gap = own_reach;
    state.pressure = 0.0;
    state.active = false;
    return;
  }
  state.xi[0] = best.xi[0];
  state.xi[1] = best.xi[1];
  state.gap = best.gap;
  state.penalty = penalty_of(face, best.face);
  state.pressure = contact_pressure(state.multiplier, state.penalty, state.gap);
  // At the kink itself the stiff side of the derivative is taken: bodies that just touch hold.
  state.active = state.multiplier - state.penalty * (state.gap - touching * size_[face]) > 0.0;
}

/// eps = f E A/V: E of the softer body, A/V of the primary elements, or of the secondary ones when
/// the primary is rigid (theory: eq. 595, 596).
double Interaction::penalty_of(Local face, Local facing) const {
  if (options_.penalty > 0.0)
    return options_.penalty;
  const double inverse_depth =
      primary_.modulus[face] > 0.0 ? primary_.inverse_depth[face] : facing_.inverse_depth(facing);
  return options_.penalty_factor * softest_modulus_ * inverse_depth;
}

/// Active points grouped by (primary face, secondary face).
void Interaction::build_pairs() {
  std::vector<Pair> list;
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const std::size_t first = list.size();
    for (int p = 0; p < face_points(f); ++p) {
      const Local index = point_index(f, p);
      if (!points_[index].active)
        continue;
      const Local facing = points_[index].facing;
      auto it = std::find_if(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
                             [&](const Pair& pair) { return pair.facing == facing; });
      if (it == list.end())
        it = list.insert(list.end(), Pair{f, facing, {}});
      it->points.push_back(p);
    }
  }
  Connectivity cells;
  for (const Pair& pair : list) {
    Global nodes[2 * fem::max_face_nodes];
    int n = 0;
    for (Local a = primary_.offset[pair.face]; a < primary_.offset[pair.face + 1]; ++a)
      nodes[n++] = primary_.node[primary_.nodes[a]];
    facing_.global_nodes(pair.facing, nodes + n);
    cells.add(nodes, n + facing_.nodes(pair.facing));
  }
  pair_list_ = std::move(list);
  if (cells.nodes == pairs_.nodes && cells.offsets == pairs_.offsets)
    return;
  pairs_ = std::move(cells);
  ++version_;
}

const Connectivity& Interaction::candidates() const {
  candidates_.clear();
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    Vec3 x[fem::max_face_nodes];
    primary_coordinates(f, false, x);
    Box<3> b = Box<3>::empty();
    for (int a = 0; a < fem::face_nodes(primary_.type[f]); ++a)
      b.add(x[a].v);
    b.inflate(pattern_pad * size_[f]);
    Global nodes[2 * fem::max_face_nodes];
    int n = 0;
    for (Local a = primary_.offset[f]; a < primary_.offset[f + 1]; ++a)
      nodes[n++] = primary_.node[primary_.nodes[a]];
    facing_.tree().traverse([&](const Box<3>& box) { return box.overlaps(b); },
                            [&](Local candidate) {
                              facing_.global_nodes(candidate, nodes + n);
                              candidates_.add(nodes, n + facing_.nodes(candidate));
                            });
  }
  return candidates_;
}

void Interaction::residual(const NodalFields&, const ResidualScatter& scatter) {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  Kokkos::parallel_for(
      "abut::contact::residual",
      Kokkos::RangePolicy<Execution>(0, static_cast<Local>(pair_list_.size())), [&](Local i) {
        const Pair& pair = pair_list_[i];
        const int n1 = fem::face_nodes(primary_.type[pair.face]), n2 = facing_.nodes(pair.facing);
        Vec3 y[fem::max_face_nodes];
        facing_.coordinates(pair.facing, y);
        double r[2 * fem::max_face_nodes * 3] = {};
        for (Local p : pair.points) {
          const PointState& state = points_[point_index(pair.face, p)];
          const auto q =
              facet_gap<double>(facing_.type(pair.facing), y, frame(pair.face, p).x, state.xi);
          facet_force(n1, &shape(pair.face)[std::size_t(p) * n1], n2, q,
                      weight_[point_index(pair.face, p)], state.pressure, r);
        }
        scatter.add(i, r);
      });
}

void Interaction::tangent(const NodalFields&, const TangentScatter& scatter) {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  int singular = 0;
  Kokkos::parallel_reduce(
      "abut::contact::tangent",
      Kokkos::RangePolicy<Execution>(0, static_cast<Local>(pair_list_.size())),
      [&](Local i, int& failed) {
        const Pair& pair = pair_list_[i];
        const int n1 = fem::face_nodes(primary_.type[pair.face]), n2 = facing_.nodes(pair.facing);
        Vec3 y[fem::max_face_nodes];
        facing_.coordinates(pair.facing, y);
        constexpr int max_size = 2 * fem::max_face_nodes * 3;
        double k[max_size * max_size];
        std::fill_n(k, 9 * (n1 + n2) * (n1 + n2), 0.0);
        for (Local p : pair.points) {
          const PointState& state = points_[point_index(pair.face, p)];
          const auto q =
              facet_gap<double>(facing_.type(pair.facing), y, frame(pair.face, p).x, state.xi);
          if (!facet_tangent(n1, &shape(pair.face)[std::size_t(p) * n1], n2, q,
                             weight_[point_index(pair.face, p)], state.penalty, state.pressure, k))
            ++failed;
        }
        scatter.add(i, k);
      },
      singular);
  if (singular > 0)
    throw SolveError("contact." + options_.name + ": " + std::to_string(singular) +
                     " points lie at the centre of curvature of '" + secondary_.name + "'");
}

void Interaction::accept() {
  for (PointState& p : points_) {
    p.converged_multiplier = p.multiplier;
    p.returns = 0;
    p.left = -1;
  }
  last_gaps_.clear();
}

void Interaction::reject() {
  for (PointState& p : points_) {
    p.multiplier = p.converged_multiplier;
    p.returns = 0;
    p.facing = p.left = -1; // the retry must not see where the failure led
  }
  last_gaps_.clear();
}

} // namespace abut::contact
