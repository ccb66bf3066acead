// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/block_pattern.hpp"
#include "abut/core/contribution.hpp"
#include "abut/core/timers.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace abut::assembly {

/// An unknown of an owned node that is prescribed: value(t) [unit of the field].
struct Constraint {
  Local node = 0; ///< owned mesh node
  int field = 0;
  std::function<double(double)> value;
};

/// Motion of nodes without unknowns: writes u (N, fields) of such nodes on this rank for time t.
using PrescribedMotion = std::function<void(double t, double* u)>;

/// The equations of all contributions: f(x) = sum of residuals = 0 for the unknowns that are not
/// constrained. Rows of other ranks are assembled here and added at their owner.
/// Every member but the accessors is collective; errors of contributions are thrown on all ranks.
class EquationSystem {
public:
  EquationSystem(DofMap dofs, PhaseTimers& timers);
  ~EquationSystem();
  EquationSystem(const EquationSystem&) = delete;
  EquationSystem& operator=(const EquationSystem&) = delete;

  void add(std::shared_ptr<Contribution> contribution);
  void set_constraints(std::vector<Constraint> constraints);
  void set_motion(PrescribedMotion motion);
  /// Loads and prescribed values from now on are those of load parameter t.
  void set_time(double t);
  double time() const { return time_; }
  /// A contribution's state changed by other means than x and t (multipliers): evaluate anew.
  void state_changed() { prepared_ = false; }

  const DofMap& dofs() const { return dofs_; }

  /// f(x), zero in constrained rows.
  void residual(const Vector& x, Vector& f);
  /// df/dx; constrained rows and columns hold only their diagonal. Owned by the system.
  RCP<const Matrix> tangent(const Vector& x);
  long graph_version() const { return pattern_.version(); }
  bool symmetric() const;

  /// Norm of the forces in balance in the last residual (internal forces or what opposes them).
  double reference_force() const { return reference_force_; }
  /// Size of a residual that rounding of the unknowns makes by itself, with the stiffness of the
  /// last tangent: a body that moves without strain has no other forces. [force]
  double round_off_force() const { return round_off_force_; }
  /// (owned rows, fields) internal minus external force of the last residual, constrained rows
  /// included: there it is the reaction that supports exert on the body.
  const std::vector<double>& raw_residual() const { return raw_residual_; }

  /// Right-hand side that moves free unknowns along with a change of the constrained ones.
  void predictor(const Vector& x, Vector& rhs);
  void apply_constraints(Vector& x) const;

  /// (N, fields) values of all local mesh nodes for x at the present time.
  std::vector<double> nodal_values(const Vector& x) const;

  void accept(const Vector& x);
  void reject();

private:
  struct Part;
  void prepare(const Vector& x);
  void update_pattern();
  void assemble_tangent();
  void copy_constrained(Matrix& matrix) const;
  NodalFields fields() const;

  DofMap dofs_;
  PhaseTimers& timers_;
  mesh::GhostExchange ghosts_;
  BlockPattern pattern_;
  std::vector<Part> parts_;
  std::vector<Constraint> constraints_;
  std::vector<char> constrained_;        ///< (owned scalar rows)
  std::vector<char> constrained_column_; ///< (columns of the graph)
  PrescribedMotion motion_;
  double time_ = 0.0;
  bool prepared_ = false;
  std::vector<double> u_;            ///< (N, fields) of the last prepare
  std::vector<double> raw_values_;   ///< owned and shared values, constraints not applied
  std::vector<double> raw_residual_; ///< owned rows
  std::vector<double> diagonal_;     ///< owned rows of the last tangent, constraints not applied
  double reference_force_ = 0.0, round_off_force_ = 0.0;
  RCP<Matrix> matrix_;
};

} // namespace abut::assembly
