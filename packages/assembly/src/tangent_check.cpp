// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_joints.hpp"
#include "system_parts.hpp"

#include <cmath>
#include <random>

namespace abut::assembly {

namespace {

/// The same direction on any number of ranks: from the number of the unknown.
double direction(Global unknown) {
  std::mt19937_64 random(static_cast<std::uint64_t>(unknown) + 1);
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

} // namespace

/// K d of one contribution, owned scalar rows.
std::vector<double> EquationSystem::tangent_times(std::size_t part, const Vector& d) {
  std::fill(raw_values_.begin(), raw_values_.end(), 0.0);
  dofs_.mesh().comm.together([&] { assemble_tangent_of(parts_[part]); });
  pattern_.add_shared_values(raw_values_.data());
  const RCP<const Vector> columns = column_values(d);
  const auto view = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = matrix_->getLocalMatrixHost();
  std::vector<double> product(static_cast<std::size_t>(local.numRows()), 0.0);
  for (Local i = 0; i < local.numRows(); ++i)
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
      product[std::size_t(i)] += raw_values_[k] * view(local.graph.entries(k), 0);
  return product;
}

/// Residual of one contribution at x, owned scalar rows.
std::vector<double> EquationSystem::residual_of(std::size_t part, const Vector& x) {
  prepare(x);
  std::vector<double> buffer(static_cast<std::size_t>(pattern_.num_rows()) * dofs_.fields(), 0.0);
  dofs_.mesh().comm.together([&] {
    Part& p = parts_[part];
    p.contribution->residual(fields(), residual_scatter(p, buffer));
  });
  pattern_.add_shared_residual(buffer.data());
  buffer.resize(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields());
  return buffer;
}

TangentMismatch EquationSystem::compare(std::size_t part, const Vector& x, const Vector& d,
                                        double step) {
  Vector moved(dofs_.map());
  std::vector<double> slope;
  for (const double side : {1.0, -1.0}) {
    moved.assign(x);
    moved.update(side * step, d, 1.0);
    const std::vector<double> r = residual_of(part, moved);
    slope.resize(r.size(), 0.0);
    for (std::size_t i = 0; i < r.size(); ++i)
      slope[i] += side * r[i] / (2.0 * step);
  }
  tangent(x); // pattern and state at x again
  const std::vector<double> product = tangent_times(part, d);
  const Comm& comm = dofs_.mesh().comm;
  double sums[2] = {0.0, 0.0}, worst = 0.0;
  std::size_t row = 0;
  const auto node_rows = static_cast<std::size_t>(dofs_.num_node_rows()) * dofs_.fields();
  for (std::size_t i = 0; i < node_rows; ++i) {
    const double error = std::fabs(product[i] - slope[i]);
    sums[0] += error * error;
    sums[1] += slope[i] * slope[i];
    if (error > worst)
      worst = error, row = i;
  }
  comm.sum(sums, 2);
  TangentMismatch result;
  result.part = parts_[part].contribution->name();
  result.error = sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : std::sqrt(sums[0]);
  const double largest = comm.max(worst);
  Global found[2] = {-1, -1}; // mesh node and field, on the rank that has them
  if (worst == largest && worst > 0.0) {
    const auto block = static_cast<Local>(row) / dofs_.fields();
    found[0] = dofs_.mesh().node_id[std::size_t(dofs_.node_of_row(block))];
    found[1] = static_cast<Global>(row) % dofs_.fields();
  }
  result.node = comm.max(found[0]);
  result.field = static_cast<int>(comm.max(found[1]));
  result.force = sums[1] > 0.0 ? std::sqrt(sums[1]) : 0.0;
  return result;
}

std::vector<TangentMismatch> EquationSystem::check_tangent(double step) {
  ABUT_REQUIRE(!last_.is_null(), "nothing has been evaluated yet");
  Vector x(dofs_.map()), d(dofs_.map());
  x.assign(*last_);
  tangent(x);
  {
    const auto view = d.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = direction(dofs_.map()->getGlobalElement(static_cast<Local>(i)));
  }
  std::vector<TangentMismatch> list;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    list.push_back(compare(p, x, d, step));
  Vector unused(dofs_.map());
  residual(x, unused); // all states are those of x again
  return list;
}

} // namespace abut::assembly
