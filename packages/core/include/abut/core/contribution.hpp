// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/core/timers.hpp"
#include "abut/core/types.hpp"

#include <string>
#include <vector>

namespace abut {

/// Values that physics reads: of every mesh node on this rank, owned nodes first, then ghosts.
struct NodalFields {
  const double* u = nullptr; ///< (N, fields) unknowns; the displacement comes first [length]
  int fields = 0;            ///< unknowns per node
  double time = 0.0;         ///< load parameter
};

/// Cells as lists of global mesh node ids, in CRS form: cell i has the nodes
/// nodes[offsets[i]] .. nodes[offsets[i+1]-1].
struct Connectivity {
  std::vector<Local> offsets{0};
  std::vector<Global> nodes;

  Local cells() const { return static_cast<Local>(offsets.size()) - 1; }
  Local size(Local cell) const { return offsets[cell + 1] - offsets[cell]; }
  void add(const Global* first, Local count) {
    nodes.insert(nodes.end(), first, first + count);
    offsets.push_back(static_cast<Local>(nodes.size()));
  }
  void clear() {
    offsets.assign(1, 0);
    nodes.clear();
  }
};

/// What a solve is for.
enum class SolveKind {
  /// One linear solve that moves the last state along with the new loads: u is the last step's
  /// while loads and prescribed bodies are already the next one's.
  prediction,
  /// Newton's iteration toward a state that the next solve can start from, see
  /// Contribution::overloaded: laws stiffer than the bodies are as soft as they are, and bodies
  /// respond as to small strains.
  approach,
  /// Newton's iteration of a step in which it did not converge otherwise: bodies and laws are as
  /// stiff as they are, but laws take the form that converges from afar, see Contribution::lands.
  landing,
  newton,             ///< Newton's iteration of a step
  after_augmentation, ///< the same again, after multipliers have changed
};

/// What the forces of a contribution are to the equations.
enum class Role {
  internal, ///< forces of bodies: their size is what residuals are compared with
  external, ///< loads: what they do is work from outside
  contact,  ///< forces between bodies
  /// Rates of momentum, see TimeIntegration. Where no time has gone by since the last accepted
  /// state, the tangent is the derivative by the acceleration: the mass.
  inertia,
};

/// A sum of small dense blocks over cells of a few nodes: the one thing that assembly knows of any
/// physics (solid, contact, loads). Residuals have the sign of internal force minus external force.
class Contribution {
public:
  virtual ~Contribution() = default;

  virtual const char* name() const = 0;
  virtual Role role() const { return Role::external; }
  virtual Phase phase() const { return Phase::solid; } ///< whose time its evaluation counts as

  /// Brings everything that depends on the configuration up to date (search, pairs, ghosts) before
  /// residual and tangent are asked. Collective. Called once for every new u or time.
  virtual void prepare(const NodalFields&) {}

  /// Cells of this rank, valid after prepare. `connectivity_version` grows with every change.
  virtual const Connectivity& connectivity() const = 0;
  virtual long connectivity_version() const { return 0; }

  /// Cells to reserve room for in the matrix pattern: a superset of connectivity() that still holds
  /// after some motion, so that the pattern lives for many iterations.
  virtual const Connectivity& candidates() const { return connectivity(); }

  /// Adds each cell's residual (n*fields). Throws SolveError (inverted element).
  virtual void residual(const NodalFields&, const ResidualScatter&) = 0;

  /// Adds each cell's tangent (n*fields)^2, the derivative of residual with respect to u.
  virtual void tangent(const NodalFields&, const TangentScatter&) = 0;

  /// Whether the tangent is symmetric.
  virtual bool symmetric() const { return true; }

  /// Square of the residual norm that rounding of positions makes, of this rank's cells [force^2].
  virtual double round_off_force2() const { return 0.0; }

  /// Whether the last prepared residual follows the true laws on this rank; false while a law
  /// stands in for another on the way there. A solve does not end before all are settled.
  virtual bool settled() const { return true; }

  /// Whether forces of the last prepared residual are larger on this rank than any that the bodies
  /// could balance: the state is too far from equilibrium for a linearisation to lead there.
  virtual bool overloaded() const { return false; }

  /// Whether the laws have another form for SolveKind::landing, close to their own. The same on all
  /// ranks.
  virtual bool lands() const { return false; }

  // Events. A residual is a function of the unknowns, the converged history and the iterate state;
  // only these, and what changes multipliers, change the latter two. In their order:
  //   begin_step
  //   begin_solve(prediction)
  //   begin_solve(approach), iterate_taken ..., where the predicted state is overloaded
  //   begin_solve(newton), iterate_taken for each iterate that Newton goes on from
  //   begin_solve(landing), iterate_taken ..., begin_solve(newton) once more, where that failed
  //   begin_solve(after_augmentation), iterates again, as often as multipliers change
  //   accept or reject
  // Evaluations between them (trials of a line search, a second tangent, a check of the tangent)
  // leave no trace.

  virtual void begin_step() {} ///< a step from the last accepted state, or another attempt at it
  virtual void begin_solve(SolveKind) {}
  /// Newton has linearised at the last prepared unknowns and goes on from there.
  virtual void iterate_taken() {}
  /// Grows with every change of the state that the next residual depends on beside u and time.
  virtual long state_version() const { return 0; }

  virtual void accept() {} ///< the step converged: trial state becomes history
  virtual void reject() {} ///< the step failed: trial state is dropped
};

} // namespace abut
