// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/tangent_matrix.hpp"

#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <cmath>

namespace abut::assembly {

namespace {

/// Values of the unknowns behind the columns of this rank's rows.
RCP<const Vector> column_values(const unknowns::BlockPattern& pattern, const Vector& owned) {
  const auto columns = rcp(new Vector(pattern.graph()->getColMap()));
  const auto importer = pattern.graph()->getImporter();
  if (importer.is_null())
    Tpetra::deep_copy(*columns, owned);
  else
    columns->doImport(owned, *importer, Tpetra::INSERT);
  return columns;
}

} // namespace

std::vector<double>& TangentMatrix::clear() {
  raw_.assign(static_cast<std::size_t>(pattern_.num_values()), 0.0);
  return raw_;
}

std::vector<double> TangentMatrix::raw_times(const Vector& x) const {
  const RCP<const Vector> columns = column_values(pattern_, x);
  const auto view = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = matrix_->getLocalMatrixHost();
  std::vector<double> product(static_cast<std::size_t>(local.numRows()), 0.0);
  for (Local i = 0; i < local.numRows(); ++i)
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      product[std::size_t(i)] += raw_[k] * view(local.graph.entries(k), 0);
  return product;
}

double TangentMatrix::diagonal(Local row) const {
  const auto local = matrix_->getLocalMatrixHost();
  for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
    if (local.graph.entries(k) == row)
      return local.values(k);
  return 0.0;
}

RCP<const Matrix> TangentMatrix::make(const unknowns::DofMap& dofs,
                                      const std::vector<char>& constrained) {
  if (matrix_.is_null()) {
    matrix_ = rcp(new Matrix(pattern_.graph()));
    mark_columns(constrained, dofs);
  } else {
    matrix_->resumeFill();
  }
  copy(constrained, dofs.num_node_rows() * dofs.fields());
  matrix_->fillComplete(dofs.map(), dofs.map());
  const auto local = matrix_->getLocalMatrixHost();
  raw_diagonal_.assign(constrained.size(), 0.0);
  for (Local i = 0; i < local.numRows(); ++i)
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      if (local.graph.entries(k) == i)
        raw_diagonal_[std::size_t(i)] = raw_[k];
  return matrix_;
}

/// Which columns are constrained is known to their owners: fetches it.
void TangentMatrix::mark_columns(const std::vector<char>& constrained,
                                 const unknowns::DofMap& dofs) {
  Vector owned(dofs.map());
  {
    const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < constrained.size(); ++i)
      view(i, 0) = constrained[i];
  }
  const RCP<const Vector> columns = column_values(pattern_, owned);
  const auto view = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
  constrained_column_.resize(view.extent(0));
  for (std::size_t i = 0; i < view.extent(0); ++i)
    constrained_column_[i] = view(i, 0) != 0.0;
}

/// Copies the raw values and clears constrained rows and columns, but for the diagonal. A row on
/// which no cell acts (a node without an element) gets a unit diagonal. Constrained rows of a rigid
/// body get the largest diagonal of its rows, or one: their own may be zero though the row is not.
void TangentMatrix::copy(const std::vector<char>& constrained, Local node_rows) {
  const auto local = matrix_->getLocalMatrixHost();
  const auto rows = local.numRows();
  const auto diagonal_of = [&](Local i) {
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      if (local.graph.entries(k) == i)
        return std::fabs(raw_[k]);
    return 0.0;
  };
  for (Local i = 0; i < rows; ++i) {
    const auto begin = local.graph.row_map(i), end = local.graph.row_map(i + 1);
    bool empty = true;
    for (auto k = begin; k < end; ++k) {
      const Local j = local.graph.entries(k);
      const double raw = raw_[k];
      empty = empty && raw == 0.0;
      local.values(k) = i == j ? raw : constrained[i] || constrained_column_[j] ? 0.0 : raw;
    }
    double diagonal = empty ? 1.0 : 0.0;
    if (i >= node_rows && constrained[i]) {
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
