// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/bodies.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/rigid/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace abut::rigid {

namespace {

constexpr double largest_step = 6.0; ///< rad; the map of increments is singular at a whole turn

Vec3 at(const std::vector<double>& x, std::size_t i) {
  return {{x[3 * i], x[3 * i + 1], x[3 * i + 2]}};
}

void put(std::vector<double>& to, std::size_t i, const Mat3& m) {
  for (int f = 0; f < 3; ++f)
    for (int g = 0; g < 3; ++g)
      to[9 * i + static_cast<std::size_t>(3 * f + g)] = m[f][g];
}

Mat3 scaled(double s, Mat3 m) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m[i][j] *= s;
  return m;
}

} // namespace

Bodies::Bodies(const unknowns::DofMap& dofs, std::vector<Body> bodies)
    : dofs_(dofs), bodies_(std::move(bodies)), length_(bodies_.size(), 0.0),
      accepted_rotation_(bodies_.size(), Mat3::identity()),
      accepted_vector_(bodies_.size(), Vec3::zero()),
      accepted_unknowns_(bodies_.size(), Vec3::zero()), placements_(bodies_.size()) {
  ABUT_REQUIRE(dofs.num_bodies() == static_cast<int>(bodies_.size()),
               "the map of unknowns knows other rigid bodies");
  for (Local n = 0; !bodies_.empty() && n < dofs.mesh().num_owned; ++n) {
    const int b = dofs.body_of_node(n);
    if (b >= 0)
      length_[b] = std::max(
          length_[b], norm(at(dofs.mesh().x, std::size_t(n)) - bodies_[std::size_t(b)].center));
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    length_[b] = dofs.mesh().comm.max(length_[b]);
    if (length_[b] == 0.0)
      length_[b] = 1.0;
    const bool unknown = dofs.row_of_body(static_cast<int>(b)) >= 0;
    ABUT_REQUIRE(unknown == bodies_[b].has_unknowns(), "the map has other unknowns than the body");
    have_unknowns_ = have_unknowns_ || unknown;
  }
  clear_forces();
}

bool Bodies::symmetric() const {
  for (const Body& body : bodies_)
    for (std::size_t i = 3; i < 6; ++i)
      if (!body.prescribed[i])
        return false;
  return true;
}

bool Bodies::owns(std::size_t b) const {
  const Global row = dofs_.row_of_body(static_cast<int>(b)) - dofs_.first_row();
  return dofs_.row_of_body(static_cast<int>(b)) >= 0 && row >= 0 && row < dofs_.num_rows();
}

std::size_t Bodies::first_owned_row(std::size_t b) const {
  return static_cast<std::size_t>(dofs_.row_of_body(static_cast<int>(b)) - dofs_.first_row()) * 3;
}

std::vector<unknowns::RowConstraint> Bodies::constraints() const {
  std::vector<unknowns::RowConstraint> result;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t i = 0; owns(b) && i < 6; ++i) {
      const Body::Function& value = bodies_[b].prescribed[i];
      const double scale = i < 3 ? 1.0 : length_[b];
      const auto row = static_cast<Local>(first_owned_row(b) + i);
      if (value)
        result.push_back({row, [value, scale](double t) { return scale * value(t); }});
      for (const Hold& hold : bodies_[b].holds)
        if (hold.component == static_cast<int>(i))
          result.push_back({row, [hold, scale](double t) { return scale * hold.value(t); },
                            hold.window, hold.relative});
    }
  return result;
}

/// (bodies,6) entries of x in the rows of the bodies, on all ranks.
std::vector<double> Bodies::all_unknowns(const Vector& x) const {
  std::vector<double> unknowns(6 * bodies_.size(), 0.0);
  if (have_unknowns_) {
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (std::size_t i = 0; owns(b) && i < 6; ++i)
        unknowns[6 * b + i] = view(first_owned_row(b) + i, 0);
    dofs_.mesh().comm.sum(unknowns.data(), static_cast<int>(unknowns.size()));
  }
  return unknowns;
}

std::vector<Placement> Bodies::place(const Vector& x, double t) const {
  const std::vector<double> unknowns = all_unknowns(x);
  std::vector<Placement> result(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Placement& p = result[b];
    if (!bodies_[b].has_unknowns()) {
      for (int i = 0; i < 3; ++i) {
        p.displacement[i] = bodies_[b].prescribed[std::size_t(i)](t);
        p.step_rotation[i] = bodies_[b].prescribed[std::size_t(i + 3)](t);
      }
      p.rotation = rotation(p.step_rotation);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const double* mine = &unknowns[6 * b];
      p.displacement[i] = mine[i];
      p.step_rotation[i] = (mine[i + 3] - accepted_unknowns_[b][i]) / length_[b];
    }
    std::copy_n(&unknowns[6 * b], 6, p.unknowns.begin());
    p.rotation = rotation(p.step_rotation) * accepted_rotation_[b];
  }
  return result;
}

void Bodies::displace(const std::vector<Placement>& placements, double* u) const {
  for (Local n = 0; !bodies_.empty() && n < dofs_.mesh().num_local(); ++n) {
    const int b = dofs_.body_of_node(n);
    if (b < 0)
      continue;
    const Placement& p = placements[std::size_t(b)];
    const Vec3 arm = at(dofs_.mesh().x, std::size_t(n)) - bodies_[std::size_t(b)].center;
    const Vec3 moved = p.rotation * arm - arm + p.displacement;
    for (int i = 0; i < 3; ++i)
      u[3 * std::size_t(n) + std::size_t(i)] = moved[i];
  }
}

void Bodies::move(std::vector<Placement> placements) {
  placements_ = std::move(placements);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].has_unknowns() && !(norm(placements_[b].step_rotation) <= largest_step))
      throw SolveError("rigid body '" + bodies_[b].name +
                       "' turns almost a whole turn in one step");
}

bool Bodies::stands_at(const std::vector<Placement>& placements) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (placements[b].unknowns != placements_[b].unknowns)
      return false; // not a number is never equal
  return true;
}

void Bodies::put_centers(double* x) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t i = 0; owns(b) && i < 6; ++i)
      x[first_owned_row(b) + i] = bodies_[b].center[static_cast<int>(i % 3)];
}

void Bodies::accept() {
  for (Inertia& inertia : inertia_)
    inertia.accept();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!bodies_[b].has_unknowns())
      continue;
    Placement& p = placements_[b];
    accepted_rotation_[b] = p.rotation;
    accepted_vector_[b] = rotation_vector(p.rotation, accepted_vector_[b]);
    for (int i = 0; i < 3; ++i)
      accepted_unknowns_[b][i] = p.unknowns[std::size_t(i + 3)];
    p.step_rotation = Vec3::zero();
  }
}

void Bodies::exchange_state(StateArchive& archive) {
  archive.numbers("rigid_bodies", [&](auto& v) {
    v(accepted_rotation_, accepted_vector_, accepted_unknowns_);
    for (Inertia& inertia : inertia_)
      inertia.list_state(v);
  });
}

void Bodies::follow(const unknowns::BlockPattern& pattern) {
  pattern_ = &pattern;
  const unknowns::PatternRigidNodes& nodes = pattern.rigid_nodes();
  arm_.resize(3 * nodes.body.size());
  lever_.resize(9 * nodes.body.size());
  turn_.resize(9 * nodes.body.size());
  std::vector<Mat3> tangent;
  for (const Placement& p : placements_)
    tangent.push_back(rotation_tangent(p.step_rotation));
  for (std::size_t n = 0; n < nodes.body.size(); ++n) {
    const auto b = static_cast<std::size_t>(nodes.body[n]);
    const Vec3 arm = placements_[b].rotation * (at(nodes.x, n) - bodies_[b].center);
    const Mat3 s = skew(arm);
    for (int i = 0; i < 3; ++i)
      arm_[3 * n + static_cast<std::size_t>(i)] = arm[i];
    put(lever_, n, scaled(1.0 / length_[b], s));
    put(turn_, n, scaled(-1.0 / length_[b], s * tangent[b]));
  }
}

RigidScatter Bodies::scatter(const unknowns::CellPositions& positions) {
  if (bodies_.empty())
    return {};
  RigidScatter s;
  s.body = pattern_->rigid_nodes().body.data();
  s.row = pattern_->body_rows().data();
  s.arm = arm_.data();
  s.lever = lever_.data();
  s.turn = turn_.data();
  s.block = positions.rigid_block.data();
  s.force = force_.data();
  return s;
}

/// The force, or the moment, as it acts at t.
Vec3 Bodies::load(std::size_t b, bool moment, double t) const {
  const Body& body = bodies_[b];
  Vec3 now = moment ? body.moment : body.force;
  for (int i = 0; i < 3; ++i)
    if (const auto& factor = body.load_factor[std::size_t(moment ? 3 + i : i)])
      now[i] *= factor(t);
  return body.follower ? placements_[b].rotation * now : now;
}

void Bodies::add_loads(double t, double* residual) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!owns(b))
      continue;
    const Vec3 force = load(b, false, t), moment = load(b, true, t);
    double* out = residual + first_owned_row(b);
    for (int i = 0; i < 3; ++i) {
      out[i] -= force[i];
      out[3 + i] -= moment[i] / length_[b];
    }
  }
}

double Bodies::load_stiffness() const {
  double largest = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    largest = std::max(largest, (norm(bodies_[b].force) + norm(bodies_[b].moment) / length_[b]) /
                                    length_[b]);
  return largest;
}

void Bodies::sum_forces() {
  if (!bodies_.empty())
    dofs_.mesh().comm.sum(force_.data(), static_cast<int>(force_.size()));
}

void Bodies::add_stiffness(double t, double inertia_weight, const unknowns::BlockPattern& pattern,
                           double* values) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!owns(b))
      continue;
    const Mat3 tangent = rotation_tangent(placements_[b].step_rotation);
    // A force f on an arm a: (w x a) x f = (a f^T - (a . f) I) w for a small rotation w.
    double s[9];
    for (std::size_t i = 0; i < 9; ++i)
      s[i] = force_[12 * b + 3 + i] + inertia_weight * force_[12 * (bodies_.size() + b) + 3 + i];
    const double trace = s[0] + s[4] + s[8];
    Mat3 of_moment, of_force = Mat3::zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        of_moment[i][j] = s[3 * i + j] - (i == j ? trace : 0.0);
    if (bodies_[b].follower) { // d(-F) = -w x F
      of_force = skew(load(b, false, t));
      const Mat3 turned = skew(load(b, true, t));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          of_moment[i][j] += turned[i][j];
    }
    add_block(pattern, b, 0, 1, 1.0, of_force * tangent, values);
    add_block(pattern, b, 1, 1, 1.0, of_moment * tangent, values);
  }
}

/// Whether a component follows a function at t.
bool Bodies::is_held(std::size_t b, std::size_t component, double t) const {
  const std::vector<Hold>& holds = bodies_[b].holds;
  return bodies_[b].prescribed[component] ||
         std::any_of(holds.begin(), holds.end(), [&](const Hold& hold) {
           return hold.component == static_cast<int>(component) && hold.window.holds(t);
         });
}

Mat3 Bodies::turn(std::size_t b) const {
  return scaled(1.0 / length_[b], rotation_tangent(placements_[b].step_rotation));
}

/// Adds a derivative of force (row 0) or moment (1) by displacement (column 0) or rotation (1).
void Bodies::add_block(const unknowns::BlockPattern& pattern, std::size_t b, int row, int column,
                       double scale, const Mat3& k, double* values) const {
  for (const int turns : {row, column})
    scale /= turns == 1 ? length_[b] : 1.0;
  const Local at = pattern.body_rows()[2 * b + static_cast<std::size_t>(row)];
  double* out = values + pattern.body_block(static_cast<int>(b), row, column);
  for (int i = 0; i < 3; ++i, out += pattern.row_length()[at])
    for (int j = 0; j < 3; ++j)
      out[j] += scale * k[i][j];
}

std::vector<BodyState> Bodies::states(double t, const std::vector<double>& others) const {
  std::vector<BodyState> result(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    BodyState& state = result[b];
    const Placement& p = placements_[b];
    state.displacement = p.displacement;
    state.rotation = bodies_[b].has_unknowns() ? rotation_vector(p.rotation, accepted_vector_[b])
                                               : p.step_rotation;
    const Vec3 force = load(b, false, t), moment = load(b, true, t);
    double f[12];
    for (std::size_t i = 0; i < 12; ++i)
      f[i] = force_[12 * b + i] + force_[12 * (bodies_.size() + b) + i];
    const double* s = f + 3; // sum of arm f^T, whose skew part is the moment
    const Vec3 own_force = inertia_.empty() ? Vec3::zero() : inertia_[b].force();
    const Vec3 own_moment = inertia_.empty() ? Vec3::zero() : inertia_[b].moment();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const std::size_t push = 6 * b + std::size_t(i);
      if (is_held(b, std::size_t(i), t))
        state.force[i] = f[i] + others[push] + own_force[i] - force[i];
      if (is_held(b, std::size_t(i + 3), t))
        state.moment[i] =
            s[3 * j + k] - s[3 * k + j] + others[push + 3] + own_moment[i] - moment[i];
    }
  }
  return result;
}

} // namespace abut::rigid
