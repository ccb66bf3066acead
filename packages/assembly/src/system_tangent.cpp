// SPDX-License-Identifier: BSD-3-Clause
// The tangent of all contributions, raw and with constraints.
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_joints.hpp"
#include "system_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::assembly {

void EquationSystem::assemble_tangent_of(Part& p) {
  const PhaseTimers::Scope scope(timers_, p.contribution->phase());
  TangentScatter scatter;
  scatter.fields = dofs_.fields();
  scatter.cell_offset = p.contribution->connectivity().offsets.data();
  scatter.row = p.positions.row.data();
  scatter.block_offset = p.positions.block_offset.data();
  scatter.block_position = p.positions.block_position.data();
  scatter.row_length = pattern_.row_length().data();
  scatter.values = raw_values_.data();
  scatter.rigid = rigid_->scatter(p.positions);
  p.contribution->tangent(fields(), scatter);
}

/// Also what start_motion and steps of length zero ask for: the mass by itself.
void EquationSystem::assemble_tangent(bool mass_alone) {
  if (rigid_->have_unknowns() && !forces_known_) {
    std::vector<double> unused(static_cast<std::size_t>(pattern_.num_rows()) * dofs_.fields(), 0.0);
    rigid_->clear_forces();
    for (const Force which : {Force::internal, Force::other, Force::inertial})
      assemble_residual(which, unused);
    rigid_->sum_forces();
    forces_known_ = true;
  }
  const double weight = rule_ && !mass_alone ? rule_->inertia() : 1.0;
  raw_values_.assign(static_cast<std::size_t>(pattern_.num_values()), 0.0);
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_)
      if (p.contribution->inertial())
        assemble_tangent_of(p);
    if (weight != 1.0)
      for (double& value : raw_values_)
        value *= weight;
    for (Part& p : parts_)
      if (!p.contribution->inertial() && !mass_alone)
        assemble_tangent_of(p);
  });
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  pattern_.add_shared_values(raw_values_.data());
  if (!mass_alone) {
    rigid_->add_stiffness(time_, weight, pattern_, raw_values_.data());
    joints_->add_tangent(pattern_, raw_values_.data());
  }
  rigid_->add_inertia_tangent(weight, pattern_, raw_values_.data());
}

/// Values of the unknowns behind the columns of this rank's rows.
RCP<const Vector> EquationSystem::column_values(const Vector& owned) const {
  const auto columns = rcp(new Vector(pattern_.graph()->getColMap()));
  const auto importer = pattern_.graph()->getImporter();
  if (importer.is_null())
    Tpetra::deep_copy(*columns, owned);
  else
    columns->doImport(owned, *importer, Tpetra::INSERT);
  return columns;
}

RCP<const Matrix> EquationSystem::tangent(const Vector& x) {
  prepare(x);
  assemble_tangent(false);
  return make_matrix();
}

/// The matrix of the raw values, constraints applied.
RCP<const Matrix> EquationSystem::make_matrix() {
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  if (matrix_.is_null()) {
    matrix_ = rcp(new Matrix(pattern_.graph()));
    // Which columns are constrained is known to their owners: fetch it.
    Vector owned(dofs_.map());
    {
      const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < constrained_.size(); ++i)
        view(i, 0) = constrained_[i];
    }
    const RCP<const Vector> columns = column_values(owned);
    const auto view = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
    constrained_column_.resize(view.extent(0));
    for (std::size_t i = 0; i < view.extent(0); ++i)
      constrained_column_[i] = view(i, 0) != 0.0;
  } else {
    matrix_->resumeFill();
  }
  copy_constrained(*matrix_);
  matrix_->fillComplete(dofs_.map(), dofs_.map());
  const auto local = matrix_->getLocalMatrixHost();
  diagonal_.assign(constrained_.size(), 0.0);
  for (Local i = 0; i < local.numRows(); ++i)
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      if (local.graph.entries(k) == i)
        diagonal_[std::size_t(i)] = raw_values_[k];
  return matrix_;
}

/// Copies the raw values and clears constrained rows and columns, but for the diagonal. A row on
/// which no cell acts (a node without an element) gets a unit diagonal. Constrained rows of a rigid
/// body get the largest diagonal of its rows, or one: their own may be zero though the row is not.
void EquationSystem::copy_constrained(Matrix& matrix) const {
  const auto local = matrix.getLocalMatrixHost();
  const auto rows = local.numRows();
  const auto diagonal_of = [&](Local i) {
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      if (local.graph.entries(k) == i)
        return std::fabs(raw_values_[k]);
    return 0.0;
  };
  const Local node_rows = dofs_.num_node_rows() * dofs_.fields();
  for (Local i = 0; i < rows; ++i) {
    const auto begin = local.graph.row_map(i), end = local.graph.row_map(i + 1);
    bool empty = true;
    for (auto k = begin; k < end; ++k) {
      const Local j = local.graph.entries(k);
      const double raw = raw_values_[k];
      empty = empty && raw == 0.0;
      local.values(k) = i == j ? raw : constrained_[i] || constrained_column_[j] ? 0.0 : raw;
    }
    double diagonal = empty ? 1.0 : 0.0;
    if (i >= node_rows && constrained_[i]) {
      const Local first = i - (i - node_rows) % 6;
      for (Local j = first; j < first + 6; ++j)
        diagonal = std::max(diagonal, diagonal_of(j));
      if (diagonal == 0.0)
        diagonal = 1.0;
    }
    if (diagonal == 0.0)
      continue;
    for (auto k = begin; k < end; ++k)
      if (local.graph.entries(k) == i)
        local.values(k) = diagonal;
  }
}

} // namespace abut::assembly
