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

const View<double>& TangentMatrix::clear() {
  const auto size = static_cast<std::size_t>(pattern_.num_values());
  if (values_.size() == size)
    Kokkos::deep_copy(values_, 0.0);
  else
    values_ = View<double>("abut::assembly::tangent", size);
  return values_;
}

std::vector<double> TangentMatrix::times(const Vector& x) const {
  const RCP<const Vector> columns = column_values(pattern_, x);
  const auto view = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto graph = pattern_.graph()->getLocalGraphHost();
  std::vector<double> product(static_cast<std::size_t>(graph.numRows()), 0.0);
  for (std::size_t i = 0; i < product.size(); ++i)
    for (auto k = graph.row_map(i); k < graph.row_map(i + 1); ++k)
      product[i] += values_[k] * view(graph.entries(k), 0);
  return product;
}

RCP<const Matrix> TangentMatrix::make(const unknowns::DofMap& dofs,
                                      const std::vector<char>& constrained) {
  if (matrix_.is_null()) {
    const auto owned = static_cast<std::size_t>(pattern_.num_owned_values());
    matrix_ = rcp(
        new Matrix(pattern_.graph(), Kokkos::subview(values_, std::pair(std::size_t(0), owned))));
    find_places(constrained, dofs);
  } else {
    matrix_->resumeFill();
  }
  constrain(constrained, static_cast<std::size_t>(dofs.num_node_rows()) * dofs.fields());
  matrix_->fillComplete(dofs.map(), dofs.map());
  return matrix_;
}

/// Where the diagonals are, and what constrained rows and columns hold beside them. Which columns
/// are constrained is known to their owners: fetches it.
void TangentMatrix::find_places(const std::vector<char>& constrained,
                                const unknowns::DofMap& dofs) {
  Vector owned(dofs.map());
  {
    const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < constrained.size(); ++i)
      view(i, 0) = constrained[i];
  }
  const RCP<const Vector> columns = column_values(pattern_, owned);
  const auto column_is_constrained = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto graph = pattern_.graph()->getLocalGraphHost();
  diagonal_place_.resize(constrained.size());
  cleared_.clear();
  for (std::size_t i = 0; i < constrained.size(); ++i)
    for (auto k = graph.row_map(i); k < graph.row_map(i + 1); ++k) {
      const auto j = static_cast<std::size_t>(graph.entries(k));
      if (j == i)
        diagonal_place_[i] = k;
      else if (constrained[i] || column_is_constrained(j, 0) != 0.0)
        cleared_.push_back(k);
    }
}

/// Clears constrained rows and columns, but for the diagonal. A row on which no cell acts (a node
/// without an element) gets a unit diagonal. Constrained rows of a rigid body get the largest
/// diagonal of its rows, or one: their own may be zero though the row is not.
void TangentMatrix::constrain(const std::vector<char>& constrained, std::size_t node_rows) {
  const auto graph = pattern_.graph()->getLocalGraphHost();
  const auto is_empty = [&](std::size_t row) {
    for (auto k = graph.row_map(row); k < graph.row_map(row + 1); ++k)
      if (values_[k] != 0.0)
        return false;
    return true;
  };
  raw_diagonal_.resize(constrained.size());
  for (std::size_t i = 0; i < constrained.size(); ++i)
    raw_diagonal_[i] = values_[diagonal_place_[i]];
  for (std::size_t i = 0; i < constrained.size(); ++i) {
    double& diagonal = values_[diagonal_place_[i]];
    if (i >= node_rows && constrained[i]) {
      const auto first = raw_diagonal_.begin() + std::ptrdiff_t(i - (i - node_rows) % 6);
      const auto largest = std::max_element(
          first, first + 6, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
      diagonal = std::fabs(*largest);
    }
    if (diagonal == 0.0 && (is_empty(i) || (i >= node_rows && constrained[i])))
      diagonal = 1.0;
  }
  for (const std::size_t k : cleared_)
    values_[k] = 0.0;
}

} // namespace abut::assembly
