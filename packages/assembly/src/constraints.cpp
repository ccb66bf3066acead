// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/constraints.hpp"

#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::assembly {

using unknowns::RowConstraint;

void Constraints::set_nodes(const unknowns::DofMap& dofs, std::vector<Constraint> constraints) {
  nodes_.clear();
  for (Constraint& c : constraints) {
    const Local row = dofs.row_of_node(c.node);
    if (row >= 0)
      nodes_.push_back({row * dofs.fields() + c.field, std::move(c.value), c.window, c.relative});
  }
}

bool Constraints::follow(double t, const std::vector<double>& last) {
  bool changed = false;
  std::fill(holds_.begin(), holds_.end(), 0);
  for (auto* list : {&nodes_, &others_})
    for (RowConstraint& c : *list) {
      const bool held = c.holds;
      c.holds = c.window.holds(t);
      changed = changed || c.holds != held;
      const auto row = static_cast<std::size_t>(c.row);
      if (c.holds && c.relative && !c.has_held)
        c.start = last.empty() ? 0.0 : last[row];
      if (c.holds)
        holds_[row] = 1;
    }
  return changed;
}

void Constraints::apply(Vector& x, double t) const {
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const auto* list : {&nodes_, &others_})
    for (const RowConstraint& c : *list)
      if (c.holds)
        view(static_cast<std::size_t>(c.row), 0) = c.at(t);
}

void Constraints::accept() {
  for (auto* list : {&nodes_, &others_})
    for (RowConstraint& c : *list)
      c.has_held = c.holds;
}

void Constraints::exchange_state(StateArchive& archive, const std::vector<Global>& rows, double t) {
  constexpr Global most = 256; // constraints of one row
  std::unordered_map<Local, Global> seen;
  std::vector<Global> keys;
  std::vector<double> starts;
  for (const auto* list : {&nodes_, &others_})
    for (const RowConstraint& c : *list)
      if (c.relative) {
        keys.push_back((3 * rows[static_cast<std::size_t>(c.row / 3)] + c.row % 3) * most +
                       seen[c.row]++);
        starts.push_back(c.start);
      }
  archive.rows("constraints.start", keys, 1, starts.data());
  if (!archive.takes())
    return;
  follow(t, {});
  auto start = starts.begin();
  for (auto* list : {&nodes_, &others_})
    for (RowConstraint& c : *list)
      if (c.relative)
        c.start = *start++;
  accept();
}

} // namespace abut::assembly
