// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace abut::assembly {

namespace {
constexpr double round_off = 1e-14; ///< some 50 units in the last place of the unknowns
} // namespace

struct EquationSystem::Part {
  std::shared_ptr<Contribution> contribution;
  CellPositions positions;
  long connectivity_version = -1;
  long pattern_version = -1;
};

EquationSystem::EquationSystem(DofMap dofs, PhaseTimers& timers)
    : dofs_(std::move(dofs)), timers_(timers), ghosts_(dofs_.mesh()), pattern_(dofs_),
      constrained_(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields(), 0) {}

EquationSystem::~EquationSystem() = default;

void EquationSystem::add(std::shared_ptr<Contribution> contribution) {
  parts_.push_back({std::move(contribution), {}, -1, -1});
  prepared_ = false;
}

void EquationSystem::set_constraints(std::vector<Constraint> constraints) {
  constraints_ = std::move(constraints);
  std::fill(constrained_.begin(), constrained_.end(), 0);
  for (const Constraint& c : constraints_) {
    const Local row = dofs_.row_of_node(c.node);
    if (row >= 0)
      constrained_[static_cast<std::size_t>(row * dofs_.fields() + c.field)] = 1;
  }
  matrix_ = Teuchos::null;
}

void EquationSystem::set_motion(PrescribedMotion motion) {
  motion_ = std::move(motion);
  prepared_ = false;
}

void EquationSystem::set_time(double t) {
  time_ = t;
  prepared_ = false;
}

bool EquationSystem::symmetric() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](const Part& p) { return p.contribution->symmetric(); });
}

NodalFields EquationSystem::fields() const {
  return {u_.data(), dofs_.fields(), time_};
}

std::vector<double> EquationSystem::nodal_values(const Vector& x) const {
  const int f = dofs_.fields();
  std::vector<double> u(static_cast<std::size_t>(dofs_.mesh().num_local()) * f, 0.0);
  if (motion_)
    motion_(time_, u.data());
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (Local r = 0; r < dofs_.num_rows(); ++r)
    for (int d = 0; d < f; ++d)
      u[static_cast<std::size_t>(dofs_.node_of_row(r)) * f + d] = view(std::size_t(r) * f + d, 0);
  ghosts_.update(u.data(), f);
  return u;
}

/// Search, pairs and pattern for x; nothing to do when neither x nor the time changed.
void EquationSystem::prepare(const Vector& x) {
  const Comm& comm = dofs_.mesh().comm;
  std::vector<double> u = nodal_values(x);
  const bool same = prepared_ && u.size() == u_.size() &&
                    std::memcmp(u.data(), u_.data(), u.size() * sizeof(double)) == 0;
  if (!comm.any(!same))
    return;
  for (double v : u)
    if (!std::isfinite(v)) {
      u[0] = v;
      break;
    }
  if (comm.any(!u.empty() && !std::isfinite(u[0])))
    throw SolveError("an unknown is not a finite number");
  u_ = std::move(u);
  prepared_ = false;
  comm.together([&] {
    for (Part& p : parts_) {
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      p.contribution->prepare(fields());
    }
  });
  update_pattern();
  prepared_ = true;
}

void EquationSystem::update_pattern() {
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  const auto locate = [&] {
    bool inside = pattern_.version() > 0;
    for (Part& p : parts_) {
      const long version = p.contribution->connectivity_version();
      if (p.connectivity_version == version && p.pattern_version == pattern_.version())
        continue;
      inside = inside && pattern_.locate(p.contribution->connectivity(), p.positions);
      p.connectivity_version = version;
      p.pattern_version = inside ? pattern_.version() : -1;
    }
    return inside;
  };
  if (!dofs_.mesh().comm.any(!locate()))
    return;
  std::vector<const Connectivity*> cells;
  for (const Part& p : parts_) {
    cells.push_back(&p.contribution->candidates());
    if (cells.back() != &p.contribution->connectivity())
      cells.push_back(&p.contribution->connectivity());
  }
  pattern_.build(cells);
  matrix_ = Teuchos::null;
  ABUT_REQUIRE(locate(), "a cell lies outside the pattern that was built from it");
}

void EquationSystem::residual(const Vector& x, Vector& f) {
  prepare(x);
  const Comm& comm = dofs_.mesh().comm;
  const int width = dofs_.fields();
  const auto owned = static_cast<std::size_t>(dofs_.num_rows()) * width;
  raw_residual_.assign(owned, 0.0);
  double norms[2] = {0.0, 0.0}; // internal forces, all others
  for (const bool internal : {true, false}) {
    std::vector<double> buffer(static_cast<std::size_t>(pattern_.num_rows()) * width, 0.0);
    comm.together([&] {
      for (Part& p : parts_) {
        if (p.contribution->internal_force() != internal)
          continue;
        const PhaseTimers::Scope scope(timers_, p.contribution->phase());
        const Connectivity& cells = p.contribution->connectivity();
        p.contribution->residual(
            fields(), {width, cells.offsets.data(), p.positions.row.data(), buffer.data()});
      }
    });
    const PhaseTimers::Scope scope(timers_, Phase::assembly);
    pattern_.add_shared_residual(buffer.data());
    for (std::size_t i = 0; i < owned; ++i) {
      norms[internal ? 0 : 1] += buffer[i] * buffer[i];
      raw_residual_[i] += buffer[i];
    }
  }
  double stiff = 0.0; // squared forces that the unknowns would make against a rigid surrounding
  const auto unknowns = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    const double force = diagonal_[i] * unknowns(i, 0);
    stiff += force * force;
  }
  double all[3] = {norms[0], norms[1], stiff};
  comm.sum(all, 3);
  reference_force_ = std::sqrt(std::max(all[0], all[1]));
  round_off_force_ = round_off * std::sqrt(all[2]);
  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < owned; ++i)
    view(i, 0) = constrained_[i] ? 0.0 : raw_residual_[i];
}

void EquationSystem::assemble_tangent() {
  raw_values_.assign(static_cast<std::size_t>(pattern_.num_values()), 0.0);
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      TangentScatter scatter;
      scatter.fields = dofs_.fields();
      scatter.cell_offset = p.contribution->connectivity().offsets.data();
      scatter.row = p.positions.row.data();
      scatter.block_offset = p.positions.block_offset.data();
      scatter.block_position = p.positions.block_position.data();
      scatter.row_length = pattern_.row_length().data();
      scatter.values = raw_values_.data();
      p.contribution->tangent(fields(), scatter);
    }
  });
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  pattern_.add_shared_values(raw_values_.data());
}

RCP<const Matrix> EquationSystem::tangent(const Vector& x) {
  prepare(x);
  assemble_tangent();
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  if (matrix_.is_null()) {
    matrix_ = rcp(new Matrix(pattern_.graph()));
    // Which columns are constrained is known to their owners: fetch it.
    Vector owned(dofs_.map()), columns(pattern_.graph()->getColMap());
    {
      const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < constrained_.size(); ++i)
        view(i, 0) = constrained_[i];
    }
    const auto importer = pattern_.graph()->getImporter();
    if (importer.is_null())
      Tpetra::deep_copy(columns, owned);
    else
      columns.doImport(owned, *importer, Tpetra::INSERT);
    const auto view = columns.getLocalViewHost(Tpetra::Access::ReadOnly);
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
/// which no cell acts (a node without an element) gets a unit diagonal.
void EquationSystem::copy_constrained(Matrix& matrix) const {
  const auto local = matrix.getLocalMatrixHost();
  const auto rows = local.numRows();
  for (Local i = 0; i < rows; ++i) {
    const auto begin = local.graph.row_map(i), end = local.graph.row_map(i + 1);
    bool empty = true;
    for (auto k = begin; k < end; ++k) {
      const Local j = local.graph.entries(k);
      const double raw = raw_values_[k];
      empty = empty && raw == 0.0;
      local.values(k) = i == j ? raw : constrained_[i] || constrained_column_[j] ? 0.0 : raw;
    }
    if (!empty)
      continue;
    for (auto k = begin; k < end; ++k)
      if (local.graph.entries(k) == i)
        local.values(k) = 1.0;
  }
}

void EquationSystem::apply_constraints(Vector& x) const {
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Constraint& c : constraints_) {
    const Local row = dofs_.row_of_node(c.node);
    if (row >= 0)
      view(std::size_t(row) * dofs_.fields() + c.field, 0) = c.value(time_);
  }
}

void EquationSystem::predictor(const Vector& x, Vector& rhs) {
  tangent(x);
  Vector jump(dofs_.map()), columns(pattern_.graph()->getColMap());
  jump.assign(x);
  apply_constraints(jump);
  jump.update(-1.0, x, 1.0); // change of the constrained unknowns, zero elsewhere
  const auto importer = pattern_.graph()->getImporter();
  if (importer.is_null())
    Tpetra::deep_copy(columns, jump);
  else
    columns.doImport(jump, *importer, Tpetra::INSERT);
  residual(x, rhs);
  const auto local = matrix_->getLocalMatrixHost();
  const auto dx = columns.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto own = jump.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto r = rhs.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (Local i = 0; i < local.numRows(); ++i) {
    double lift = 0.0, diagonal = 0.0;
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k) {
      const Local j = local.graph.entries(k);
      lift += raw_values_[k] * dx(j, 0);
      if (i == j)
        diagonal = local.values(k);
    }
    r(i, 0) = constrained_[i] ? diagonal * own(i, 0) : -r(i, 0) - lift;
  }
}

void EquationSystem::accept(const Vector& x) {
  prepare(x);
  for (Part& p : parts_)
    p.contribution->accept();
}

void EquationSystem::reject() {
  for (Part& p : parts_)
    p.contribution->reject();
  prepared_ = false;
}

} // namespace abut::assembly
