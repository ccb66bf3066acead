// SPDX-License-Identifier: BSD-3-Clause
// Which unknowns are prescribed, when and how.
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_bodies.hpp"
#include "system_parts.hpp"

#include <algorithm>

namespace abut::assembly {

void EquationSystem::set_constraints(std::vector<Constraint> constraints) {
  constraints_.clear();
  for (Constraint& c : constraints) {
    const Local row = dofs_.row_of_node(c.node);
    if (row >= 0)
      constraints_.push_back(
          {row * dofs_.fields() + c.field, std::move(c.value), c.window, c.relative});
  }
  follow_windows();
  mark_constrained();
}

/// Brings the constraints up to date with the time. True: on this rank one begins or ends.
bool EquationSystem::follow_windows() {
  bool changed = false;
  for (auto* list : {&constraints_, &body_constraints_, &joint_constraints_})
    for (RowConstraint& c : *list) {
      const bool held = c.holds;
      c.holds = c.window.holds(time_);
      changed = changed || c.holds != held;
      const auto row = static_cast<std::size_t>(c.row);
      if (c.holds && c.relative && !c.has_held)
        c.start = row < work_state_.x.size() ? work_state_.x[row] : 0.0;
    }
  return changed;
}

void EquationSystem::mark_constrained() {
  std::fill(constrained_.begin(), constrained_.end(), 0);
  for (const auto* list : {&constraints_, &body_constraints_, &joint_constraints_})
    for (const RowConstraint& c : *list)
      if (c.holds)
        constrained_[static_cast<std::size_t>(c.row)] = 1;
  matrix_ = Teuchos::null;
}

void EquationSystem::apply_constraints(Vector& x) const {
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const auto* list : {&constraints_, &body_constraints_, &joint_constraints_})
    for (const RowConstraint& c : *list)
      if (c.holds)
        view(static_cast<std::size_t>(c.row), 0) = c.at(time_);
}

} // namespace abut::assembly
