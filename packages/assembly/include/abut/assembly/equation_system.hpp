// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/block_pattern.hpp"
#include "abut/assembly/rigid_body.hpp"
#include "abut/assembly/rigid_joint.hpp"
#include "abut/core/contribution.hpp"
#include "abut/core/time_integration.hpp"
#include "abut/core/timers.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::assembly {

/// An unknown of an owned node that is prescribed: value(t) [unit of the field].
struct Constraint {
  Local node = 0; ///< owned mesh node
  int field = 0;
  std::function<double(double)> value;
  Window window{};       ///< outside of it the unknown is free
  bool relative = false; ///< the value counts from that of the last state before the window
};

/// Work done from outside between the accepted states, by the trapezoidal rule [energy].
struct ExternalWork {
  double loads = 0.0;
  double supports = 0.0; ///< prescribed unknowns and prescribed motion of rigid bodies
};

/// How far the tangent of one contribution is from the slope of its residual.
struct TangentMismatch {
  std::string part;
  double error = 0.0; ///< |K d - slope| / |slope| in the L2 norm [1]
  double force = 0.0; ///< |slope|: zero when the contribution does not act [force/length]
  Global node = -1;   ///< id of the node of the worst row; -1: there is no error at all
  int field = 0;      ///< its component
};

class RigidBodies;
class RigidJoints;
struct RowConstraint;

/// The equations of all contributions: f(x) = sum of residuals = 0 for the unknowns that are not
/// constrained. Rows of other ranks are assembled here and added at their owner. Forces on nodes of
/// a rigid body are forces on its center and moments about it.
/// Every member but the accessors is collective; errors of contributions are thrown on all ranks.
class EquationSystem {
public:
  EquationSystem(DofMap dofs, PhaseTimers& timers);
  ~EquationSystem();
  EquationSystem(const EquationSystem&) = delete;
  EquationSystem& operator=(const EquationSystem&) = delete;

  void add(std::shared_ptr<Contribution> contribution);
  void set_constraints(std::vector<Constraint> constraints);
  /// The bodies whose nodes the DofMap knows, in its order; before the first evaluation.
  void set_rigid_bodies(std::vector<RigidBody> bodies);
  /// The links of the DofMap, in its order; after set_rigid_bodies. Throws InputError for an axis
  /// without direction.
  void set_rigid_joints(std::vector<RigidJoint> joints);
  /// Loads and prescribed values from now on are those of load parameter t; which unknowns are
  /// prescribed may change.
  void set_time(double t);
  double time() const { return time_; }
  /// Events of the solution, told to all contributions; see Contribution.
  void begin_solve(SolveKind kind);
  void iterate_taken();

  const DofMap& dofs() const { return dofs_; }

  /// f(x), zero in constrained rows.
  void residual(const Vector& x, Vector& f);
  /// df/dx; constrained rows and columns hold only their diagonal. Owned by the system.
  RCP<const Matrix> tangent(const Vector& x);
  long graph_version() const { return pattern_.version(); }
  bool symmetric() const;
  /// Whether multipliers are among the unknowns: only a direct solver then takes the tangent.
  bool indefinite() const;
  /// Throws SolveError where the last residual is not that of a solution, however small it is.
  void require_consistent() const;

  /// Norm of the forces in balance in the last residual (internal forces or what opposes them).
  double reference_force() const { return reference_force_; }
  /// Size of a residual that rounding of the unknowns makes by itself, with the stiffness of the
  /// last tangent: a body that moves without strain has no other forces. [force]
  double round_off_force() const { return round_off_force_; }
  /// Whether the last residual follows the true laws, see Contribution::settled.
  bool settled() const { return settled_; }
  /// (owned rows, fields) internal minus external force of the last residual, constrained rows
  /// included: there it is the reaction that supports exert on the body.
  const std::vector<double>& raw_residual() const { return raw_residual_; }
  /// Motion of the rigid bodies and reactions on them, as of the last residual. Not collective.
  std::vector<RigidBodyState> rigid_body_states() const;
  std::vector<RigidJointState> rigid_joint_states() const;
  /// What joints need not hold, since others do: (joint, component) as words.
  std::vector<std::pair<std::string, std::string>> implied_constraints() const;
  /// (owned rows, 3) reference coordinates; of a rigid body's rows those of its center. [length]
  std::vector<double> row_coordinates() const;

  /// The tangent, and the right-hand side that moves free unknowns along with a change of the
  /// constrained ones, at x: a solve of its own, see SolveKind. Newton's is begun after it.
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs);
  void apply_constraints(Vector& x) const;

  /// (N, fields) values of all local mesh nodes for x at the present time.
  std::vector<double> nodal_values(const Vector& x) const;

  /// The last residual must be that at x.
  void accept(const Vector& x);
  void reject();
  const ExternalWork& external_work() const { return external_work_; }

  // --- dynamics: t is the time, and rates of momentum are part of the equations ---

  /// From x at the present time on, bodies with mass move as they say; inertial contributions have
  /// been added and started. Returns the right-hand side -f of mass() a = -f, the equation of the
  /// accelerations a; accelerate(a) then completes the start.
  void start_motion(const TimeIntegration& rule, const Vector& x, Vector& minus_f);
  /// Derivative of the rates of momentum by the accelerations; constrained rows as in tangent().
  RCP<const Matrix> mass(const Vector& x);
  /// Rates of the nodes (N,3) as they follow from rates of the unknowns, but for what is quadratic
  /// in the velocity of turning bodies.
  std::vector<double> nodal_rates(const Vector& rates) const;
  /// Adds the accelerations of rigid bodies; those of inertial contributions have been set.
  void accelerate(const Vector& x, const Vector& acceleration);
  bool has_inertia() const { return rule_.has_value(); }
  /// Of the rigid bodies in the state of the last residual; empty without inertia.
  std::vector<RigidBodyMotion> rigid_body_motions() const;

  /// Each contribution's tangent where the residual was last asked, along a random direction of all
  /// unknowns, against central differences of its residual over +- step [length]. Rows of free
  /// rigid bodies are left out: their arm stiffness belongs to no contribution.
  std::vector<TangentMismatch> check_tangent(double step);

private:
  struct Part;
  /// What the work of the next step starts from.
  struct WorkState {
    std::vector<double> x, loads, raw; ///< (owned scalar rows)
    std::vector<RigidBodyState> bodies;
    std::vector<RigidJointState> joints;
  };
  long state_version() const;
  void prepare(const Vector& x);
  void update_pattern();
  enum class Force { internal, other, inertial };
  static Force kind(const Contribution& contribution);
  void assemble_residual(Force which, std::vector<double>& buffer);
  void measure_forces(const Vector& x, const double (&norms)[3]);
  void add_motion();
  void keep_past();
  ResidualScatter residual_scatter(const Part& part, std::vector<double>& buffer);
  std::vector<double> load_residual();
  void add_work(const Vector& x);
  void assemble_tangent_of(Part& part);
  std::vector<double> tangent_times(std::size_t part, const Vector& d);
  std::vector<double> residual_of(std::size_t part, const Vector& x);
  TangentMismatch compare(std::size_t part, const Vector& x, const Vector& d, double step);
  void assemble_tangent(bool mass_alone);
  RCP<const Matrix> make_matrix();
  void scale_joints();
  double add_joint_forces(std::vector<double>& buffer);
  RCP<const Vector> column_values(const Vector& owned) const;
  bool follow_windows();
  void mark_constrained();
  void copy_constrained(Matrix& matrix) const;
  NodalFields fields() const;

  DofMap dofs_;
  PhaseTimers& timers_;
  mesh::GhostExchange ghosts_;
  BlockPattern pattern_;
  std::vector<Part> parts_;
  std::vector<RowConstraint> constraints_;
  std::vector<RowConstraint> body_constraints_, joint_constraints_;
  std::vector<char> constrained_;        ///< (owned scalar rows)
  std::vector<char> constrained_column_; ///< (columns of the graph)
  std::unique_ptr<RigidBodies> rigid_;
  std::unique_ptr<RigidJoints> joints_;
  double time_ = 0.0;
  long state_version_ = -1; ///< of all contributions in the last prepare
  bool prepared_ = false;
  bool joints_scaled_ = true, scale_joints_ = false;
  bool forces_known_ = false;      ///< whether the rigid bodies hold the forces of the last prepare
  std::vector<double> u_;          ///< (N, fields) of the last prepare
  std::vector<double> raw_values_; ///< owned and shared values, constraints not applied
  std::vector<double> raw_residual_;    ///< owned rows
  std::vector<double> diagonal_;        ///< owned rows of the last tangent, constraints not applied
  std::optional<TimeIntegration> rule_; ///< none: no inertia
  double accepted_time_ = 0.0;
  std::vector<double> forces_, inertia_; ///< the two parts of the last residual, owned rows
  std::vector<double> past_; ///< what the start of the step adds to the equation, owned rows
  RCP<Vector> last_;         ///< where the residual was asked last
  WorkState work_state_;
  ExternalWork external_work_;
  double joint_norm_ = 0.0; ///< squared forces of joints in this rank's rows
  double reference_force_ = 0.0, round_off_force_ = 0.0;
  bool settled_ = true;
  RCP<Matrix> matrix_;
};

} // namespace abut::assembly
