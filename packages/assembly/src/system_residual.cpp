// SPDX-License-Identifier: BSD-3-Clause
// Forces of all contributions, what a residual is compared with, and the start of motion.
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <cmath>

namespace abut::assembly {

namespace {
constexpr double round_off = 1e-14; ///< some 50 units in the last place of the unknowns

/// Joints balance loads as internal forces do, but may also oppose those: their size counts by
/// itself. Returns the squared norm of this rank's.
double add_joint_forces(const rigid::Joints& joints, std::vector<double>& residual) {
  if (joints.empty())
    return 0.0;
  std::vector<double> forces(residual.size(), 0.0);
  joints.add_forces(forces.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum += forces[i] * forces[i];
    residual[i] += forces[i];
  }
  joints.add_equations(residual.data());
  return sum;
}

} // namespace

void EquationSystem::residual(const Vector& x, Vector& f) {
  prepare(x);
  if (last_.is_null())
    last_ = rcp(new Vector(dofs_.map()));
  if (last_.get() != &x)
    last_->assign(x);
  if (!residual_known_)
    sum_forces();
  measure_ = measured(x);
  const std::vector<char>& constrained = constraints_.holds();
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < raw_residual_.size(); ++i)
    view(i, 0) = constrained[i] ? 0.0 : raw_residual_[i];
}

/// All forces of the last prepare, and the squared norms of each kind on this rank.
void EquationSystem::sum_forces() {
  const auto owned = static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields();
  raw_residual_.assign(owned, 0.0);
  std::vector<double>& rates = motion_.clear_rates(owned);
  bodies_.clear_forces();
  norms_ = {};
  const NodalFields accepted{u_accepted_.data(), dofs_.fields(), time_};
  for (const Force which : {Force::internal, Force::other, Force::inertial}) {
    if (which == Force::inertial && !motion_.active())
      break;
    std::vector<double> buffer = which == Force::internal && linear_
                                     ? contributions_.linear_residual(accepted, fields(), bodies_)
                                     : contributions_.residual(which, fields(), bodies_);
    const PhaseTimers::Scope scope(timers_, Phase::assembly);
    contributions_.pattern().add_shared_residual(buffer.data());
    if (which == Force::other)
      bodies_.add_loads(time_, buffer.data());
    if (which == Force::inertial)
      bodies_.add_inertia(buffer.data());
    std::vector<double>& sum = which == Force::inertial ? rates : raw_residual_;
    for (std::size_t i = 0; i < owned; ++i) {
      norms_[static_cast<std::size_t>(which)] += buffer[i] * buffer[i];
      sum[i] += buffer[i];
    }
  }
  norms_[3] = add_joint_forces(joints_, raw_residual_);
  bodies_.sum_forces();
  motion_.complete(raw_residual_, constraints_.holds());
  forces_known_ = residual_known_ = true;
}

/// What a residual is compared with.
ResidualMeasure EquationSystem::measured(const Vector& x) const {
  double stiff = 0.0; // squared forces that the unknowns would make against a rigid surrounding
  const auto unknowns = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const std::vector<double>& diagonal = tangent_.raw_diagonal();
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double force = diagonal[i] * unknowns(i, 0);
    stiff += force * force;
  }
  // the same for rounding of positions, by its own unit
  stiff += contributions_.round_off_force2() / (round_off * round_off);
  double all[7] = {norms_[0],
                   norms_[1],
                   norms_[2],
                   norms_[3],
                   stiff,
                   static_cast<double>(contributions_.unsettled()),
                   static_cast<double>(contributions_.overloaded())};
  dofs_.mesh().comm.sum(all, 7);
  return {std::sqrt(std::max({all[0], all[1], all[2], all[3]})),
          round_off * std::sqrt(all[4] + joints_.rounding_force2()),
          all[5] == 0.0 && joints_.closed(), all[6] > 0.0, contributions_.land()};
}

void EquationSystem::start_motion(const TimeIntegration& rule, const Vector& x, Vector& minus_f) {
  motion_.start(rule, time_, constraints_.holds().size());
  prepared_ = false;
  prepare(x);
  bodies_.accept(); // rotations count from here
  prepared_ = false;
  prepare(x);
  bodies_.start(rule);
  // The whole equation of motion, not the one between two times: there is no past yet.
  residual(x, minus_f);
  const std::vector<char>& constrained = constraints_.holds();
  const auto view = minus_f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < constrained.size(); ++i)
    view(i, 0) = constrained[i] ? 0.0 : -motion_.at_end(i);
}

RCP<const Matrix> EquationSystem::mass(const Vector& x) {
  prepare(x);
  assemble_tangent(true);
  return make_matrix();
}

std::vector<double> EquationSystem::nodal_rates(const Vector& rates) const {
  std::vector<double> nodal(3 * static_cast<std::size_t>(dofs_.mesh().num_local()), 0.0);
  {
    const auto view = rates.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (Local r = 0; r < dofs_.num_node_rows(); ++r)
      for (std::size_t i = 0; i < 3; ++i)
        nodal[3 * static_cast<std::size_t>(dofs_.node_of_row(r)) + i] =
            view(3 * static_cast<std::size_t>(r) + i, 0);
  }
  ghosts_.to_ghosts(nodal.data(), 3);
  bodies_.put_rates(rates, nodal.data());
  return nodal;
}

void EquationSystem::accelerate(const Vector& x, const Vector& acceleration) {
  bodies_.accelerate(acceleration);
  prepared_ = false;
  Vector f(dofs_.map());
  residual(x, f);
  add_work(x);
  motion_.accept(time_);
}

} // namespace abut::assembly
