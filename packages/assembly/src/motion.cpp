// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_bodies.hpp"
#include "system_parts.hpp"

namespace abut::assembly {

void EquationSystem::start_motion(const TimeIntegration& rule, const Vector& x, Vector& minus_f) {
  rule_ = rule;
  accepted_time_ = time_;
  past_.assign(constrained_.size(), 0.0);
  prepared_ = false;
  prepare(x);
  rigid_->accept(); // rotations count from here
  prepared_ = false;
  prepare(x);
  rigid_->start(rule);
  // The whole equation of motion, not the one between two times: there is no past yet.
  residual(x, minus_f);
  const auto view = minus_f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < constrained_.size(); ++i)
    view(i, 0) = constrained_[i] ? 0.0 : -forces_[i] - inertia_[i];
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
  ghosts_.update(nodal.data(), 3);
  rigid_->put_rates(rates, nodal.data());
  return nodal;
}

void EquationSystem::accelerate(const Vector& x, const Vector& acceleration) {
  rigid_->accelerate(acceleration);
  prepared_ = false;
  Vector f(dofs_.map());
  residual(x, f);
  add_work(x);
  keep_past();
}

/// The last residual holds forces alone so far: adds what inertia and the start of the step make.
void EquationSystem::add_motion() {
  if (!rule_)
    return;
  forces_ = raw_residual_;
  for (std::size_t i = 0; i < forces_.size(); ++i)
    raw_residual_[i] = constrained_[i] // there the reactions are those of the end of the step
                           ? forces_[i] + inertia_[i]
                           : forces_[i] + rule_->inertia() * inertia_[i] + past_[i];
}

/// The part of the next equation that the accepted state makes, from the last residual.
void EquationSystem::keep_past() {
  if (!rule_ || !rule_->has_past())
    return;
  for (std::size_t i = 0; i < past_.size(); ++i)
    past_[i] = rule_->past_force() * forces_[i] + rule_->past_inertia() * inertia_[i];
}

std::vector<RigidBodyMotion> EquationSystem::rigid_body_motions() const {
  return rigid_->motions();
}

} // namespace abut::assembly
