// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/constraints.hpp"
#include "abut/assembly/contributions.hpp"
#include "abut/assembly/external_work.hpp"
#include "abut/assembly/motion_terms.hpp"
#include "abut/assembly/tangent_matrix.hpp"
#include "abut/core/state_archive.hpp"
#include "abut/core/timers.hpp"
#include "abut/rigid/bodies.hpp"
#include "abut/rigid/joints.hpp"

#include <array>
#include <memory>
#include <vector>

namespace abut::assembly {

/// What the last residual is compared with, and what its contributions say of it.
struct ResidualMeasure {
  /// Norm of the forces in balance: internal ones or what opposes them. [force]
  double reference = 0.0;
  /// Size of a residual that rounding of the unknowns makes by itself, with the stiffness of the
  /// last tangent: a body that moves without strain has no other forces. [force]
  double round_off = 0.0;
  bool settled = true;     ///< all follow their true laws, see Contribution::settled
  bool overloaded = false; ///< some exceed what bodies carry, see Contribution::overloaded
  bool lands = false;      ///< some have another form to start from, see Contribution::lands
};

/// The equations of all contributions: f(x) = sum of residuals = 0 for the unknowns that are not
/// constrained. Rows of other ranks are assembled here and added at their owner. Forces on nodes of
/// a rigid body are forces on its center and moments about it.
/// Every member but the accessors is collective; errors of contributions are thrown on all ranks.
class EquationSystem {
public:
  /// bodies: those whose nodes the DofMap knows, joints: its links, in its order. Throws InputError
  /// for an axis without direction.
  EquationSystem(unknowns::DofMap dofs, PhaseTimers& timers, std::vector<rigid::Body> bodies = {},
                 std::vector<rigid::Joint> joints = {});
  EquationSystem(const EquationSystem&) = delete;

  void add(std::shared_ptr<Contribution> contribution);
  void set_constraints(std::vector<Constraint> constraints);
  /// Loads and prescribed values from now on are those of load parameter t; which unknowns are
  /// prescribed may change.
  void set_time(double t);
  double time() const { return time_; }
  /// Events of the solution, told to all contributions; see Contribution. In an approach internal
  /// forces are linear about the last accepted state: no path through them inverts an element.
  void begin_solve(SolveKind kind);
  void iterate_taken() { contributions_.iterate_taken(); }

  const unknowns::DofMap& dofs() const { return dofs_; }
  /// As of the last residual.
  const rigid::Bodies& bodies() const { return bodies_; }
  const rigid::Joints& joints() const { return joints_; }

  /// f(x), zero in constrained rows.
  void residual(const Vector& x, Vector& f);
  /// df/dx; constrained rows and columns hold only their diagonal. Owned by the system.
  RCP<const Matrix> tangent(const Vector& x);
  long graph_version() const { return contributions_.pattern().version(); }
  bool symmetric() const;
  /// Whether multipliers are among the unknowns: only a direct solver then takes the tangent.
  bool indefinite() const { return joints_.have_unknowns(); }
  /// Throws SolveError where the last residual is not that of a solution, however small it is.
  void require_consistent() const { joints_.require_consistent(); }

  const ResidualMeasure& measure() const { return measure_; }
  /// Where the last residual was taken, of all local mesh nodes.
  NodalFields fields() const { return {u_.data(), dofs_.fields(), time_}; }
  /// (owned rows, fields) internal minus external force of the last residual, constrained rows
  /// included: there it is the reaction that supports exert on the body.
  const std::vector<double>& raw_residual() const { return raw_residual_; }
  /// Motion of the rigid bodies and reactions on them, as of the last residual. Not collective.
  std::vector<rigid::BodyState> body_states() const;
  /// (owned rows, 3) reference coordinates; of a rigid body's rows those of its center. [length]
  std::vector<double> row_coordinates() const;

  /// The tangent, and the right-hand side that moves free unknowns along with a change of the
  /// constrained ones, at x: a solve of its own, see SolveKind. Newton's is begun after it.
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs);
  void apply_constraints(Vector& x) const { constraints_.apply(x, time_); }

  /// (N, fields) values of all local mesh nodes for x at the present time.
  std::vector<double> nodal_values(const Vector& x) const;

  /// The last residual must be that at x.
  void accept(const Vector& x);
  void reject();
  /// The last accepted state x, its time and all that the next step needs of it, without what the
  /// contributions remember. After taking the equations are to be evaluated anew. Collective.
  void exchange_state(StateArchive& archive, Vector& x);

  const ExternalWork& external_work() const { return work_.work(); }

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

private:
  friend class TangentCheck;
  void prepare(const Vector& x);
  void scale_joints();
  void sum_forces();
  ResidualMeasure measured(const Vector& x) const;
  void assemble_tangent(bool mass_alone);
  RCP<const Matrix> make_matrix();
  void add_work(const Vector& x);

  unknowns::DofMap dofs_;
  PhaseTimers& timers_;
  NodeExchange ghosts_;
  Contributions contributions_;
  rigid::Bodies bodies_;
  rigid::Joints joints_;
  Constraints constraints_;
  TangentMatrix tangent_;
  MotionTerms motion_;
  WorkLedger work_;
  double time_ = 0.0;
  long state_version_ = -1;     ///< of all contributions in the last prepare
  bool prepared_ = false;       ///< u_ and all that is made of it are of the last x and time
  bool forces_known_ = false;   ///< whether the rigid bodies hold the forces of the last prepare
  bool residual_known_ = false; ///< whether raw_residual_ is of the last prepare
  bool joints_scaled_, scale_joints_;
  bool linear_ = false;              ///< internal forces are linear about u_accepted_
  std::vector<double> u_;            ///< (N, fields) of the last prepare
  std::vector<double> u_accepted_;   ///< (N, fields) of the last accepted state
  std::vector<double> raw_residual_; ///< owned rows
  std::array<double, 4> norms_ = {}; ///< squared, of each kind of force and of joints; of this rank
  RCP<Vector> last_;                 ///< where the residual was asked last
  ResidualMeasure measure_;
};

} // namespace abut::assembly
