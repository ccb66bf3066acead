// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace abut::assembly {

namespace {

std::vector<unknowns::RowConstraint> constraints_of(const rigid::Bodies& bodies,
                                                    const rigid::Joints& joints) {
  std::vector<unknowns::RowConstraint> all = bodies.constraints();
  for (unknowns::RowConstraint& c : joints.constraints())
    all.push_back(std::move(c));
  return all;
}

} // namespace

EquationSystem::EquationSystem(unknowns::DofMap dofs, PhaseTimers& timers,
                               std::vector<rigid::Body> bodies, std::vector<rigid::Joint> joints)
    : dofs_(std::move(dofs)), timers_(timers), ghosts_(mesh::node_exchange(dofs_.mesh())),
      contributions_(dofs_, timers), bodies_(dofs_, std::move(bodies)),
      joints_(dofs_, bodies_, std::move(joints)),
      constraints_(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields(),
                   constraints_of(bodies_, joints_)),
      tangent_(contributions_.pattern()), joints_scaled_(joints_.empty()),
      scale_joints_(!joints_.empty()),
      u_accepted_(static_cast<std::size_t>(dofs_.mesh().num_local()) * dofs_.fields(), 0.0) {
  constraints_.follow(time_, {});
}

void EquationSystem::add(std::shared_ptr<Contribution> contribution) {
  contributions_.add(std::move(contribution));
  prepared_ = false;
}

void EquationSystem::set_constraints(std::vector<Constraint> constraints) {
  constraints_.set_nodes(dofs_, std::move(constraints));
  constraints_.follow(time_, work_.last_x());
  tangent_.reset();
  residual_known_ = false;
}

void EquationSystem::set_time(double t) {
  time_ = t;
  prepared_ = false;
  contributions_.begin_step();
  scale_joints_ = !joints_scaled_;
  if (dofs_.mesh().comm.any(constraints_.follow(t, work_.last_x())))
    tangent_.reset();
}

/// Rigid bodies' turns are not small in an approach: with them, bodies stay as they are.
void EquationSystem::begin_solve(SolveKind kind) {
  const bool linear = kind == SolveKind::approach && !bodies_.have_unknowns();
  if (linear != linear_)
    forces_known_ = residual_known_ = false;
  linear_ = linear;
  contributions_.begin_solve(kind);
}

bool EquationSystem::symmetric() const {
  return bodies_.symmetric() && !joints_.have_unknowns() && contributions_.symmetric();
}

std::vector<double> EquationSystem::nodal_values(const Vector& x) const {
  const int f = dofs_.fields();
  std::vector<double> u(static_cast<std::size_t>(dofs_.mesh().num_local()) * f, 0.0);
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (Local r = 0; r < dofs_.num_node_rows(); ++r)
    for (int d = 0; d < f; ++d)
      u[static_cast<std::size_t>(dofs_.node_of_row(r)) * f + d] = view(std::size_t(r) * f + d, 0);
  ghosts_.to_ghosts(u.data(), f);
  if (!bodies_.empty())
    bodies_.displace(bodies_.place(x, time_), u.data());
  return u;
}

std::vector<double> EquationSystem::row_coordinates() const {
  const mesh::Mesh& mesh = dofs_.mesh();
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<double> x(3 * static_cast<std::size_t>(dofs_.num_rows()), 0.0);
  for (Local r = 0; r < dofs_.num_node_rows(); ++r)
    std::copy_n(&mesh.x[static_cast<std::size_t>(dofs_.node_of_row(r)) * dim], dim,
                &x[3 * static_cast<std::size_t>(r)]);
  bodies_.put_centers(x.data());
  joints_.put_origins(x.data());
  return x;
}

std::vector<rigid::BodyState> EquationSystem::body_states() const {
  return bodies_.states(time_, joints_.body_forces());
}

/// Search, pairs and pattern for x; nothing to do when neither x nor the time changed.
void EquationSystem::prepare(const Vector& x) {
  const Comm& comm = dofs_.mesh().comm;
  std::vector<double> u = nodal_values(x);
  std::vector<rigid::Placement> placements = bodies_.place(x, time_);
  std::vector<double> multipliers = joints_.multipliers(x);
  const long state = contributions_.state_version();
  const bool same = prepared_ && state == state_version_ && u.size() == u_.size() &&
                    std::memcmp(u.data(), u_.data(), u.size() * sizeof(double)) == 0 &&
                    bodies_.stands_at(placements) && joints_.stands_at(multipliers);
  const bool finite = std::all_of(u.begin(), u.end(), [](double v) { return std::isfinite(v); });
  double worst[2] = {same ? 0.0 : 1.0, finite ? 0.0 : 1.0};
  comm.max(worst, 2);
  if (worst[0] == 0.0)
    return;
  if (worst[1] > 0.0)
    throw SolveError("an unknown is not a finite number");
  u_ = std::move(u);
  state_version_ = state;
  prepared_ = false;
  forces_known_ = residual_known_ = false;
  bodies_.move(std::move(placements));
  joints_.move(std::move(multipliers), time_);
  if (contributions_.prepare(fields()))
    tangent_.reset();
  bodies_.follow(contributions_.pattern());
  bodies_.move_masses(time_ - motion_.accepted_time());
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
  for (const double k : contributions_.pattern().diagonal(tangent_.values().data()))
    largest = std::max(largest, std::fabs(k));
  largest = dofs_.mesh().comm.max(largest);
  if (largest == 0.0)
    largest = std::max(bodies_.load_stiffness(), joints_.load_stiffness());
  joints_scaled_ = largest > 0.0;
  joints_.set_stiffness(joints_scaled_ ? largest : 1.0);
}

RCP<const Matrix> EquationSystem::tangent(const Vector& x) {
  prepare(x);
  assemble_tangent(false);
  return make_matrix();
}

RCP<const Matrix> EquationSystem::make_matrix() {
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  return tangent_.make(dofs_, constraints_.holds());
}

/// Also what start_motion and steps of length zero ask for: the mass by itself.
void EquationSystem::assemble_tangent(bool mass_alone) {
  if (bodies_.have_unknowns() && !forces_known_) {
    bodies_.clear_forces();
    for (const Force which : {Force::internal, Force::other, Force::inertial})
      contributions_.residual(which, fields(), bodies_);
    bodies_.sum_forces();
    forces_known_ = true;
  }
  const double weight = mass_alone ? 1.0 : motion_.weight();
  const View<double>& values = tangent_.clear();
  contributions_.add_tangents(Force::inertial, fields(), bodies_, values.data());
  if (weight != 1.0)
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] *= weight;
  if (!mass_alone) {
    const NodalFields bodies_at{(linear_ ? u_accepted_ : u_).data(), dofs_.fields(), time_};
    contributions_.add_tangents(Force::internal, bodies_at, bodies_, values.data());
    contributions_.add_tangents(Force::other, fields(), bodies_, values.data());
  }
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  const unknowns::BlockPattern& pattern = contributions_.pattern();
  pattern.add_shared_values(values.data());
  if (!mass_alone) {
    bodies_.add_stiffness(time_, weight, pattern, values.data());
    joints_.add_tangent(pattern, values.data());
  }
  bodies_.add_inertia_tangent(weight, pattern, values.data());
}

RCP<const Matrix> EquationSystem::predictor(const Vector& x, Vector& rhs) {
  begin_solve(SolveKind::prediction);
  prepare(x);
  assemble_tangent(false);
  Vector jump(dofs_.map());
  jump.assign(x);
  apply_constraints(jump);
  jump.update(-1.0, x, 1.0); // change of the constrained unknowns, zero elsewhere
  const std::vector<double> lift = tangent_.times(jump);
  const RCP<const Matrix> matrix = make_matrix();
  residual(x, rhs);
  const auto own = jump.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto r = rhs.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t i = 0; i < lift.size(); ++i)
    r(i, 0) = constraints_.holds()[i] ? tangent_.diagonal(static_cast<Local>(i)) * own(i, 0)
                                      : -r(i, 0) - lift[i];
  begin_solve(SolveKind::newton);
  return matrix;
}

void EquationSystem::add_work(const Vector& x) {
  WorkLedger::State now;
  now.loads = contributions_.loads(fields(), bodies_);
  bodies_.add_loads(time_, now.loads.data());
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < now.loads.size(); ++i)
    now.x.push_back(view(i, 0));
  now.raw = raw_residual_;
  now.bodies = body_states();
  now.joints = joints_.states();
  work_.add(std::move(now), constraints_.holds(),
            static_cast<std::size_t>(dofs_.num_node_rows()) * dofs_.fields(), joints_,
            dofs_.mesh().comm);
}

void EquationSystem::accept(const Vector& x) {
  prepare(x);
  u_accepted_ = u_;
  add_work(x);
  contributions_.accept();
  bodies_.accept();
  constraints_.accept();
  joints_.accept();
  motion_.accept(time_);
  residual_known_ = false; // histories and the past have moved on
  if (bodies_.have_unknowns())
    prepared_ = false; // the same place, but the rotation's increments count from here
}

void EquationSystem::exchange_state(StateArchive& archive, Vector& x) {
  const std::vector<Global> rows = dofs_.row_keys();
  ABUT_REQUIRE(dofs_.fields() == 3, "rows of three");
  archive.numbers("equations", [&](auto& v) { v(time_, joints_scaled_); });
  archive.rows("unknowns", rows, 3, x.getLocalViewHost(Tpetra::Access::ReadWrite).data());
  bodies_.exchange_state(archive);
  joints_.exchange_state(archive);
  work_.exchange_state(archive, rows);
  motion_.exchange_state(archive, rows);
  constraints_.exchange_state(archive, rows, time_);
  if (!archive.takes())
    return;
  u_accepted_ = nodal_values(x);
  scale_joints_ = prepared_ = forces_known_ = residual_known_ = false;
  tangent_.reset();
}

void EquationSystem::reject() {
  begin_solve(SolveKind::newton); // what failed may have been a solve on the way
  contributions_.reject();
  prepared_ = false;
}

} // namespace abut::assembly
