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
  for (Part& p : parts_)
    p.contribution->begin_step();
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
  return {u_.data(), dofs_.fields(), time_};
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
  const bool same = prepared_ && state_version() == state_version_ && u.size() == u_.size() &&
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
  state_version_ = state_version();
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

RCP<const Matrix> EquationSystem::predictor(const Vector& x, Vector& rhs) {
  begin_solve(SolveKind::prediction);
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
  begin_solve(SolveKind::newton);
  return matrix_;
}

void EquationSystem::begin_solve(SolveKind kind) {
  for (Part& p : parts_)
    p.contribution->begin_solve(kind);
}

void EquationSystem::iterate_taken() {
  for (Part& p : parts_)
    p.contribution->iterate_taken();
}

long EquationSystem::state_version() const {
  long sum = 0;
  for (const Part& p : parts_)
    sum += p.contribution->state_version();
  return sum;
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
