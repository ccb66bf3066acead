// SPDX-License-Identifier: BSD-3-Clause
// Forces of all contributions, and what a residual is compared with.
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_joints.hpp"
#include "system_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::assembly {

namespace {
constexpr double round_off = 1e-14; ///< some 50 units in the last place of the unknowns
} // namespace

ResidualScatter EquationSystem::residual_scatter(const Part& p, std::vector<double>& buffer) {
  ResidualScatter scatter;
  scatter.fields = dofs_.fields();
  scatter.cell_offset = p.contribution->connectivity().offsets.data();
  scatter.row = p.positions.row.data();
  scatter.values = buffer.data();
  scatter.rigid = rigid_->scatter(p.positions);
  if (p.contribution->inertial())
    scatter.rigid.force = rigid_->inertial_forces();
  return scatter;
}

EquationSystem::Force EquationSystem::kind(const Contribution& contribution) {
  return contribution.inertial()         ? Force::inertial
         : contribution.internal_force() ? Force::internal
                                         : Force::other;
}

/// Adds what all contributions of one kind exert to the rows of this rank, owned and shared.
void EquationSystem::assemble_residual(Force which, std::vector<double>& buffer) {
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      if (kind(*p.contribution) != which)
        continue;
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      p.contribution->residual(fields(), residual_scatter(p, buffer));
    }
  });
}

/// Joints balance loads as internal forces do, but may also oppose those: their size counts by
/// itself. Returns the squared norm of this rank's.
double EquationSystem::add_joint_forces(std::vector<double>& buffer) {
  if (joints_->empty())
    return 0.0;
  std::vector<double> forces(raw_residual_.size(), 0.0);
  joints_->add_forces(forces.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum += forces[i] * forces[i];
    buffer[i] += forces[i];
  }
  joints_->add_equations(buffer.data());
  return sum;
}

void EquationSystem::residual(const Vector& x, Vector& f) {
  prepare(x);
  if (last_.is_null())
    last_ = rcp(new Vector(dofs_.map()));
  if (last_.get() != &x)
    last_->assign(x);
  const auto owned = static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields();
  raw_residual_.assign(owned, 0.0);
  inertia_.assign(rule_ ? owned : 0, 0.0);
  rigid_->clear_forces();
  double norms[3] = {0.0, 0.0, 0.0};
  for (const Force which : {Force::internal, Force::other, Force::inertial}) {
    if (which == Force::inertial && !rule_)
      break;
    std::vector<double> buffer(static_cast<std::size_t>(pattern_.num_rows()) * dofs_.fields(), 0.0);
    assemble_residual(which, buffer);
    const PhaseTimers::Scope scope(timers_, Phase::assembly);
    pattern_.add_shared_residual(buffer.data());
    if (which == Force::other)
      rigid_->add_loads(time_, buffer.data());
    if (which == Force::inertial)
      rigid_->add_inertia(buffer.data());
    std::vector<double>& sum = which == Force::inertial ? inertia_ : raw_residual_;
    for (std::size_t i = 0; i < owned; ++i) {
      norms[static_cast<int>(which)] += buffer[i] * buffer[i];
      sum[i] += buffer[i];
    }
  }
  joint_norm_ = add_joint_forces(raw_residual_);
  rigid_->sum_forces();
  forces_known_ = true;
  measure_forces(x, norms);
  add_motion();
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < owned; ++i)
    view(i, 0) = constrained_[i] ? 0.0 : raw_residual_[i];
}

/// What a residual is compared with, from the squared norms of each kind of force on this rank.
void EquationSystem::measure_forces(const Vector& x, const double (&norms)[3]) {
  double stiff = 0.0; // squared forces that the unknowns would make against a rigid surrounding
  const auto unknowns = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    const double force = diagonal_[i] * unknowns(i, 0);
    stiff += force * force;
  }
  double positions = 0.0; // the same for rounding of positions, by its own unit
  double unsettled = 0.0;
  for (const Part& p : parts_) {
    positions += p.contribution->round_off_force2();
    unsettled += p.contribution->settled() ? 0.0 : 1.0;
  }
  stiff += positions / (round_off * round_off);
  double all[6] = {norms[0], norms[1], norms[2], joint_norm_, stiff, unsettled};
  dofs_.mesh().comm.sum(all, 6);
  settled_ = all[5] == 0.0 && joints_->closed();
  reference_force_ = std::sqrt(std::max({all[0], all[1], all[2], all[3]}));
  round_off_force_ = round_off * std::sqrt(all[4] + joints_->rounding_force2());
}

} // namespace abut::assembly
