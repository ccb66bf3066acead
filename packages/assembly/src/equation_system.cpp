// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "rigid_joints.hpp"
#include "system_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace abut::assembly {

namespace {
constexpr double round_off = 1e-14; ///< some 50 units in the last place of the unknowns
} // namespace

EquationSystem::EquationSystem(DofMap dofs, PhaseTimers& timers)
    : dofs_(std::move(dofs)), timers_(timers), ghosts_(dofs_.mesh()), pattern_(dofs_),
      constrained_(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields(), 0) {
  if (dofs_.num_bodies() == 0)
    set_rigid_bodies({});
}

EquationSystem::~EquationSystem() = default;

void EquationSystem::add(std::shared_ptr<Contribution> contribution) {
  parts_.push_back({std::move(contribution), {}, -1, -1});
  prepared_ = false;
}

void EquationSystem::set_rigid_bodies(std::vector<RigidBody> bodies) {
  rigid_ = std::make_unique<RigidBodies>(dofs_, std::move(bodies));
  body_constraints_ = rigid_->constraints();
  follow_windows();
  joint_constraints_.clear();
  joints_.reset();
  if (dofs_.num_links() == 0)
    joints_ = std::make_unique<RigidJoints>(dofs_, *rigid_, std::vector<RigidJoint>{});
  mark_constrained();
  prepared_ = false;
}

void EquationSystem::set_rigid_joints(std::vector<RigidJoint> joints) {
  joints_ = std::make_unique<RigidJoints>(dofs_, *rigid_, std::move(joints));
  joint_constraints_ = joints_->constraints();
  mark_constrained();
  prepared_ = false;
  joints_scaled_ = joints_->empty();
  scale_joints_ = !joints_scaled_;
}

void EquationSystem::set_time(double t) {
  time_ = t;
  prepared_ = false;
  scale_joints_ = !joints_scaled_;
  if (dofs_.mesh().comm.any(follow_windows()))
    mark_constrained();
}

bool EquationSystem::symmetric() const {
  return rigid_->symmetric() && !joints_->have_unknowns() &&
         std::all_of(parts_.begin(), parts_.end(),
                     [](const Part& p) { return p.contribution->symmetric(); });
}

bool EquationSystem::indefinite() const {
  return joints_->have_unknowns();
}

void EquationSystem::require_consistent() const {
  joints_->require_consistent();
}

NodalFields EquationSystem::fields() const {
  return {u_.data(), dofs_.fields(), time_, predicting_};
}

std::vector<double> EquationSystem::nodal_values(const Vector& x) const {
  const int f = dofs_.fields();
  std::vector<double> u(static_cast<std::size_t>(dofs_.mesh().num_local()) * f, 0.0);
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (Local r = 0; r < dofs_.num_node_rows(); ++r)
    for (int d = 0; d < f; ++d)
      u[static_cast<std::size_t>(dofs_.node_of_row(r)) * f + d] = view(std::size_t(r) * f + d, 0);
  ghosts_.update(u.data(), f);
  if (!rigid_->empty())
    rigid_->displace(rigid_->place(x, time_), u.data());
  return u;
}

std::vector<double> EquationSystem::row_coordinates() const {
  const mesh::Mesh& mesh = dofs_.mesh();
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<double> x(3 * static_cast<std::size_t>(dofs_.num_rows()), 0.0);
  for (Local r = 0; r < dofs_.num_node_rows(); ++r)
    std::copy_n(&mesh.x[static_cast<std::size_t>(dofs_.node_of_row(r)) * dim], dim,
                &x[3 * static_cast<std::size_t>(r)]);
  rigid_->put_centers(x.data());
  joints_->put_origins(x.data());
  return x;
}

std::vector<RigidBodyState> EquationSystem::rigid_body_states() const {
  return rigid_->states(time_, joints_->body_forces());
}

std::vector<RigidJointState> EquationSystem::rigid_joint_states() const {
  return joints_->states();
}

std::vector<std::pair<std::string, std::string>> EquationSystem::implied_constraints() const {
  return joints_->implied();
}

/// Search, pairs and pattern for x; nothing to do when neither x nor the time changed.
void EquationSystem::prepare(const Vector& x) {
  const Comm& comm = dofs_.mesh().comm;
  std::vector<double> u = nodal_values(x);
  std::vector<Placement> placements = rigid_->place(x, time_);
  std::vector<double> multipliers = joints_->multipliers(x);
  const bool same = prepared_ && u.size() == u_.size() &&
                    std::memcmp(u.data(), u_.data(), u.size() * sizeof(double)) == 0 &&
                    rigid_->stands_at(placements) && joints_->stands_at(multipliers);
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
  forces_known_ = false;
  rigid_->move(std::move(placements));
  joints_->move(std::move(multipliers), time_);
  comm.together([&] {
    for (Part& p : parts_) {
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      p.contribution->prepare(fields());
    }
  });
  update_pattern();
  rigid_->follow(pattern_);
  rigid_->move_masses(time_ - accepted_time_);
  prepared_ = true;
  if (scale_joints_)
    scale_joints();
}

/// Joints are as stiff as what stiffness there is, or else loads over the size of their bodies.
/// While there is nothing, multipliers are zero and their scale may change from step to step.
void EquationSystem::scale_joints() {
  scale_joints_ = false;
  assemble_tangent(false);
  double largest = 0.0;
  for (const double k : pattern_.diagonal(raw_values_.data()))
    largest = std::max(largest, std::fabs(k));
  largest = dofs_.mesh().comm.max(largest);
  if (largest == 0.0)
    largest = std::max(rigid_->load_stiffness(), joints_->load_stiffness());
  joints_scaled_ = largest > 0.0;
  joints_->set_stiffness(joints_scaled_ ? largest : 1.0);
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
  if (predicted_)
    prepared_ = predicted_ = false; // what was made for the prediction holds no longer
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

void EquationSystem::predictor(const Vector& x, Vector& rhs) {
  predicting_ = true;
  prepared_ = false;
  tangent(x);
  Vector jump(dofs_.map());
  jump.assign(x);
  apply_constraints(jump);
  jump.update(-1.0, x, 1.0); // change of the constrained unknowns, zero elsewhere
  const RCP<const Vector> columns = column_values(jump);
  residual(x, rhs);
  const auto local = matrix_->getLocalMatrixHost();
  const auto dx = columns->getLocalViewHost(Tpetra::Access::ReadOnly);
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
  predicting_ = false;
  predicted_ = true;
}

void EquationSystem::accept(const Vector& x) {
  prepare(x);
  add_work(x);
  for (Part& p : parts_)
    p.contribution->accept();
  rigid_->accept();
  for (auto* list : {&constraints_, &body_constraints_, &joint_constraints_})
    for (RowConstraint& c : *list)
      c.has_held = c.holds;
  joints_->accept();
  accepted_time_ = time_;
  keep_past();
  if (rigid_->have_unknowns())
    prepared_ = false; // the same place, but the rotation's increments count from here
}

void EquationSystem::reject() {
  for (Part& p : parts_)
    p.contribution->reject();
  prepared_ = false;
}

} // namespace abut::assembly
