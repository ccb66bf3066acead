// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/multigrid/near_null_space.hpp"

#include <string>
#include <vector>

namespace abut::solver {

using multigrid::RowPlace;

/// What Newton needs of a discretised problem f(x) = 0. Newton knows nothing of contact or
/// elements. Every member is collective. residual and tangent may throw SolveError (inverted
/// element, lost pair): a line search then shortens the step, a load step is tried again smaller.
class NonlinearSystem {
public:
  virtual ~NonlinearSystem() = default;

  virtual RCP<const Map> map() const = 0;

  /// f(x): internal minus external force; zero in constrained rows.
  virtual void residual(const Vector& x, Vector& f) = 0;

  /// df/dx at x. Constrained rows and columns hold only their diagonal. The graph may change from
  /// one call to the next, `graph_version` then grows; the values belong to the system.
  virtual RCP<const Matrix> tangent(const Vector& x) = 0;
  virtual long graph_version() const = 0;
  virtual bool symmetric() const = 0;
  /// Whether multipliers are among the unknowns. The tangent then has zeros on its diagonal, which
  /// only a direct solver takes, and the slope of a line search may have any sign.
  virtual bool indefinite() const { return false; }

  /// Size of the forces that balance in the last residual, reactions and external forces included:
  /// what a residual norm is compared with. [force]
  virtual double reference_force() const = 0;
  /// A residual norm no larger than this is rounding and counts as zero. [force]
  virtual double round_off_force() const { return 0.0; }

  /// Whether the last residual is of the true laws; a solve does not end before.
  virtual bool settled() const { return true; }
  /// Whether the last residual has forces beyond what the bodies can balance: a solve of the kind
  /// `approach` then comes first.
  virtual bool overloaded() const { return false; }
  /// Whether a solve of the kind `landing` differs from one of the kind `newton`.
  virtual bool lands() const { return false; }
  /// Asked when a solve has converged: throws SolveError where its end is no solution after all.
  virtual void require_consistent() const {}

  /// For multigrid: unknowns come in rows of this many per node.
  virtual int unknowns_per_node() const { return 1; }
  /// (local unknowns / unknowns_per_node) what each row stands for and where; empty: not known.
  virtual std::vector<RowPlace> row_places() const { return {}; }

  // --- events of the solution, see Contribution ---

  virtual void begin_solve(SolveKind) {}
  /// Newton has linearised at the x of the last residual and goes on from there.
  virtual void iterate_taken() {}

  // --- load steps ---

  /// A step begins, or another attempt at it: loads and prescribed values are those of load
  /// parameter t.
  virtual void set_time(double t) = 0;
  /// The predictor: K dx = rhs, K being what it returns, moves the free unknowns along with the
  /// prescribed ones from the equilibrium x of the last step to the loads of the present time.
  /// Constrained rows hold (their diagonal) * (prescribed - present value). Load stepping calls
  /// set_time, predictor(x), apply_constraints, then residual at the predicted x.
  virtual RCP<const Matrix> predictor(const Vector& x, Vector& rhs) = 0;
  /// Overwrites the constrained entries of x by their prescribed values.
  virtual void apply_constraints(Vector& x) = 0;
  virtual void accept(const Vector& x) = 0; ///< the step converged: trial state becomes history
  virtual void reject() = 0;                ///< the step failed: trial state is dropped
};

/// What one augmentation did. See AugmentCallback.
struct AugmentReport {
  bool converged = true; ///< no further solve is needed
  bool stalled = false;  ///< plateau: further augmentations change nothing; stop, with reason
  double change = 0.0;   ///< relative change of the multipliers [1]
  double gap = 0.0;      ///< largest penetration over face size [1]
  std::string reason;    ///< one sentence, for the log
};

} // namespace abut::solver
