// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/joints.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/rigid/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace abut::rigid {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double no_new_row = 1e-5; ///< of a constraint's row to what others hold already

/// Of a joint's first or second body, its force (kind 0) or moment (1), in a PairVector.
std::size_t pair_index(int which, int kind) {
  return static_cast<std::size_t>(2 * which + kind);
}

} // namespace

Joints::Joints(const unknowns::DofMap& dofs, const Bodies& bodies, std::vector<Joint> joints)
    : dofs_(dofs), bodies_(bodies), joints_(std::move(joints)), length_(joints_.size(), 0.0),
      role_(6 * joints_.size(), Role::free), accepted_angle_(joints_.size(), 0.0),
      accepted_turn_(joints_.size(), Mat3::identity()),
      accepted_rotation_(joints_.size(), {Mat3::identity(), Mat3::identity()}),
      multipliers_(6 * joints_.size(), 0.0), sides_(joints_.size()), angle_(joints_.size(), 0.0),
      deviation_(6 * joints_.size(), 0.0) {
  ABUT_REQUIRE(dofs.num_links() == static_cast<int>(joints_.size()),
               "the map of unknowns knows other joints");
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    if (!(norm(joint.axis) > 0.0))
      throw InputError("joint '" + joint.name + "' has an axis without a direction");
    frame_.push_back(joint_frame(joint.axis));
    for (const int b : joint.body)
      if (b >= 0)
        length_[j] = std::max(length_[j], bodies.length(static_cast<std::size_t>(b)));
    if (length_[j] == 0.0)
      length_[j] = 1.0;
    for (std::size_t i = 0; i < 6; ++i)
      if (joint.held[i])
        role(j, i) = Role::held;
    for (const std::size_t k : {0u, 1u})
      if (joint.load[k] && !joint.held[3 * k + 2])
        role(j, 3 * k + 2) = Role::loaded;
  }
  find_implied();
}

bool Joints::have_unknowns() const {
  return std::count(role_.begin(), role_.end(), Role::held) > 0;
}

bool Joints::owns(std::size_t j) const {
  const Global row = dofs_.row_of_link(static_cast<int>(j)) - dofs_.first_row();
  return dofs_.row_of_link(static_cast<int>(j)) >= 0 && row >= 0 && row < dofs_.num_rows();
}

std::size_t Joints::first_owned_row(std::size_t j) const {
  return static_cast<std::size_t>(dofs_.row_of_link(static_cast<int>(j)) - dofs_.first_row()) * 3;
}

/// A component's slope by all components of bodies that are unknowns, in the reference
/// configuration; lengths and angles in one unit.
std::vector<double> Joints::reference_row(std::size_t j, std::size_t i) const {
  JointSide side[2];
  for (int which = 0; which < 2; ++which) {
    const int b = joints_[j].body[std::size_t(which)];
    side[which] = {b < 0 ? Vec3::zero() : bodies_.body(std::size_t(b)).center, joints_[j].origin,
                   frame_[j]};
  }
  const PairVector slope = joint_slope(side[0], side[1], i);
  std::vector<double> row(6 * bodies_.size(), 0.0);
  for (int which = 0; which < 2; ++which) {
    const int b = joints_[j].body[std::size_t(which)];
    for (std::size_t k = 0; b >= 0 && k < 6; ++k) {
      if (bodies_.body(std::size_t(b)).prescribed[k])
        continue;
      const double length = k < 3 ? 1.0 : bodies_.length(std::size_t(b));
      row[6 * std::size_t(b) + k] +=
          (i < 3 ? 1.0 : length_[j]) / length * slope[pair_index(which, k < 3 ? 0 : 1)][int(k % 3)];
    }
  }
  return row;
}

/// Prescribed motion comes last, so that it is what is left out only where it contradicts.
void Joints::find_implied() {
  std::vector<std::vector<double>> base; // orthonormal
  const auto size = [](const std::vector<double>& row) {
    double sum = 0.0;
    for (const double v : row)
      sum += v * v;
    return std::sqrt(sum);
  };
  const auto try_component = [&](std::size_t j, std::size_t i) {
    std::vector<double> row = reference_row(j, i);
    const double before = std::max(1.0, size(row));
    for (int twice = 0; twice < 2; ++twice)
      for (const std::vector<double>& other : base) {
        double share = 0.0;
        for (std::size_t k = 0; k < row.size(); ++k)
          share += other[k] * row[k];
        for (std::size_t k = 0; k < row.size(); ++k)
          row[k] -= share * other[k];
      }
    const double left = size(row);
    if (left <= no_new_row * before) {
      role(j, i) = Role::implied;
      return;
    }
    for (double& v : row)
      v /= left;
    base.push_back(std::move(row));
  };
  const auto moves = [&](std::size_t j, std::size_t i) {
    return (i % 3 == 2 && joints_[j].motion[i / 3]) || (i >= 3 && joints_[j].turn);
  };
  for (const int pass : {0, 1, 2}) // translations, rotations, prescribed motion
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (std::size_t i = 0; i < 6; ++i)
        if (joints_[j].held[i] && (moves(j, i) ? 2 : i < 3 ? 0 : 1) == pass)
          try_component(j, i);
}

std::vector<unknowns::RowConstraint> Joints::constraints() const {
  std::vector<unknowns::RowConstraint> result;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; owns(j) && i < 6; ++i) {
      const auto row = static_cast<Local>(first_owned_row(j) + i);
      if (role(j, i) == Role::loaded)
        result.push_back(
            {row, [this, j, i](double t) { return -joints_[j].load[i / 3](t) / scale(j, i); }});
      else if (role(j, i) != Role::held)
        result.push_back({row, [](double) { return 0.0; }});
    }
  return result;
}

double Joints::load_stiffness() const {
  double largest = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (const std::size_t k : {0u, 1u})
      if (role(j, 3 * k + 2) == Role::loaded)
        largest = std::max(largest, std::fabs(joints_[j].load[k](time_)) /
                                        std::pow(length_[j], k == 0 ? 1 : 2));
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (joints_[j].couple)
      largest = std::max(largest, norm(joints_[j].couple(time_)) / std::pow(length_[j], 2));
  return largest;
}

std::vector<double> Joints::multipliers(const Vector& x) const {
  std::vector<double> values(6 * joints_.size(), 0.0);
  if (values.empty())
    return values;
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; owns(j) && i < 6; ++i)
      values[6 * j + i] = view(first_owned_row(j) + i, 0);
  dofs_.mesh().comm.sum(values.data(), static_cast<int>(values.size()));
  return values;
}

JointSide Joints::side(std::size_t j, int which) const {
  const Joint& joint = joints_[j];
  const int b = joint.body[std::size_t(which)];
  const Vec3& origin = joint.is_spring() && which == 1 ? joint.end : joint.origin;
  if (b < 0)
    return {Vec3::zero(), origin, frame_[j]};
  const Vec3& reference = bodies_.body(std::size_t(b)).center;
  const Placement& p = bodies_.placement(std::size_t(b));
  JointSide s;
  s.center = reference + p.displacement;
  s.point = s.center + p.rotation * (origin - reference);
  for (std::size_t k = 0; k < 3; ++k)
    s.frame[k] = p.rotation * frame_[j][k];
  return s;
}

Mat3 Joints::rotation_of(std::size_t j, int which) const {
  const int b = joints_[j].body[std::size_t(which)];
  return b < 0 ? Mat3::identity() : bodies_.placement(std::size_t(b)).rotation;
}

/// The prescribed rotation of the whole frame.
Mat3 Joints::turned(std::size_t j) const {
  return joints_[j].turn ? rotation(joints_[j].turn(time_)) : Mat3::identity();
}

/// Where a held component should stand.
double Joints::wanted(std::size_t j, std::size_t i) const {
  const bool moves = i % 3 == 2 && joints_[j].motion[i / 3];
  return moves ? joints_[j].motion[i / 3](time_) : 0.0;
}

void Joints::move(std::vector<double> multipliers, double t) {
  multipliers_ = std::move(multipliers);
  time_ = t;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Sides& s = sides_[j] = {side(j, 0), side(j, 1)};
    if (joints_[j].turn) {
      const Mat3 turn = turned(j);
      if (norm(rotation_vector(turn * transpose(accepted_turn_[j]), Vec3::zero())) >= 0.5 * pi)
        throw SolveError("joint '" + joints_[j].name +
                         "' turns by a quarter turn or more in one step");
      for (std::size_t k = 0; k < 3; ++k)
        s.a.frame[k] = rotation_of(j, 0) * (turn * frame_[j][k]);
    }
    const double last = accepted_angle_[j];
    const double step = joint_value(s.a, s.b, Joint::about) - last;
    angle_[j] = last + step - 2.0 * pi * std::round(step / (2.0 * pi));
    for (std::size_t i = 0; i < 6; ++i) {
      double& deviation = deviation_[6 * j + i];
      deviation = 0.0;
      if (role(j, i) != Role::held && role(j, i) != Role::implied)
        continue;
      const double to = wanted(j, i);
      if (i == Joint::about && !(std::fabs(to - last) < pi))
        throw SolveError("joint '" + joints_[j].name +
                         "' turns by half a turn or more in one step");
      deviation = (i == Joint::about ? angle_[j] : joint_value(s.a, s.b, i)) - to;
    }
  }
}

void Joints::accept() {
  accepted_angle_ = angle_;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    accepted_turn_[j] = turned(j);
    accepted_rotation_[j] = {rotation_of(j, 0), rotation_of(j, 1)};
  }
}

void Joints::exchange_state(StateArchive& archive) {
  archive.numbers("joints", [&](auto& v) {
    v(stiffness_, accepted_angle_, accepted_turn_, accepted_rotation_);
  });
}

void Joints::put_origins(double* x) const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; owns(j) && i < 6; ++i)
      x[first_owned_row(j) + i] = joints_[j].origin[static_cast<int>(i % 3)];
}

PairVector Joints::pair_force(std::size_t j) const {
  const Sides& s = sides_[j];
  if (joints_[j].is_spring())
    return Spring{joints_[j].stiffness, joints_[j].free_length}.force(s.a, s.b);
  PairVector sum{Vec3::zero(), Vec3::zero(), Vec3::zero(), Vec3::zero()};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!acts(j, i))
      continue;
    const PairVector slope = joint_slope(s.a, s.b, i);
    for (std::size_t k = 0; k < 4; ++k)
      sum[k] += factor(j, i) * slope[k];
  }
  if (joints_[j].couple) {
    const Vec3 moment = joints_[j].couple(time_);
    sum[1] += moment;
    sum[3] -= moment;
  }
  return sum;
}

PairMatrix Joints::pair_tangent(std::size_t j) const {
  const Sides& s = sides_[j];
  if (joints_[j].is_spring())
    return Spring{joints_[j].stiffness, joints_[j].free_length}.tangent(s.a, s.b);
  std::array<double, 6> factors;
  for (std::size_t i = 0; i < 6; ++i)
    factors[i] = factor(j, i);
  return joint_curvature(s.a, s.b, factors);
}

std::vector<double> Joints::body_forces() const {
  std::vector<double> sums(6 * bodies_.size(), 0.0);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const PairVector f = pair_force(j);
    for (int which = 0; which < 2; ++which) {
      const int b = joints_[j].body[std::size_t(which)];
      for (std::size_t k = 0; b >= 0 && k < 6; ++k)
        sums[6 * std::size_t(b) + k] += f[pair_index(which, k < 3 ? 0 : 1)][int(k % 3)];
    }
  }
  return sums;
}

void Joints::add_forces(double* residual) const {
  const std::vector<double> sums = body_forces();
  for (std::size_t b = 0; !joints_.empty() && b < bodies_.size(); ++b)
    for (std::size_t k = 0; bodies_.owns(b) && k < 6; ++k)
      residual[bodies_.first_owned_row(b) + k] +=
          sums[6 * b + k] / (k < 3 ? 1.0 : bodies_.length(b));
}

void Joints::add_equations(double* residual) const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; owns(j) && i < 6; ++i)
      if (role(j, i) == Role::held)
        residual[first_owned_row(j) + i] += scale(j, i) * deviation_[6 * j + i];
}

void Joints::add_tangent(const unknowns::BlockPattern& pattern, double* values) const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    add_pair(j, pattern, values);
    if (!joints_[j].is_spring())
      add_slopes(j, pattern, values);
  }
}

/// How the forces change with the bodies.
void Joints::add_pair(std::size_t j, const unknowns::BlockPattern& pattern, double* values) const {
  const PairMatrix k = pair_tangent(j);
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c) {
      const int row = joints_[j].body[r / 2], column = joints_[j].body[c / 2];
      if (row < 0 || column < 0 || !bodies_.owns(std::size_t(row)) || dofs_.row_of_body(column) < 0)
        continue;
      const Mat3 block = c % 2 ? k[r][c] * bodies_.turn(std::size_t(column)) : k[r][c];
      const double length = r % 2 ? bodies_.length(std::size_t(row)) : 1.0;
      pattern.add(dofs_.row_of_body(row) + Global(r % 2), dofs_.row_of_body(column) + Global(c % 2),
                  1.0 / length, block, values);
    }
}

/// Columns of the multipliers in the bodies' rows, and the equations' rows.
void Joints::add_slopes(std::size_t j, const unknowns::BlockPattern& pattern,
                        double* values) const {
  const Sides& s = sides_[j];
  const Global link = dofs_.row_of_link(static_cast<int>(j));
  for (std::size_t kind = 0; kind < 2; ++kind)
    for (std::size_t body = 0; body < 4; ++body) {
      const int b = joints_[j].body[body / 2];
      if (b < 0 || dofs_.row_of_body(b) < 0)
        continue;
      Mat3 column = Mat3::zero(), row = Mat3::zero();
      for (std::size_t i = 3 * kind; i < 3 * kind + 3; ++i) {
        if (!acts(j, i))
          continue;
        const Vec3 slope = scale(j, i) * joint_slope(s.a, s.b, i)[body];
        for (int f = 0; f < 3; ++f) {
          column[f][i % 3] = slope[f];
          if (role(j, i) == Role::held)
            row[i % 3][f] = slope[f];
        }
      }
      const Global at = dofs_.row_of_body(b) + Global(body % 2);
      const double length = body % 2 ? bodies_.length(std::size_t(b)) : 1.0;
      if (bodies_.owns(std::size_t(b)))
        pattern.add(at, link + Global(kind), 1.0 / length, column, values);
      if (owns(j))
        pattern.add(link + Global(kind), at, 1.0,
                    body % 2 ? row * bodies_.turn(std::size_t(b)) : row, values);
    }
}

} // namespace abut::rigid
