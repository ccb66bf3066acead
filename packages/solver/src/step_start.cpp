// SPDX-License-Identifier: BSD-3-Clause
#include "step_start.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/newton.hpp"
#include "abut/solver/nonlinear_system.hpp"

#include <cmath>
#include <limits>

namespace abut::solver {

namespace {

/// Residual of an extrapolated start over that of staying where the last step ended, up to which
/// the last step tells of the next one. Loads that go on as they did give less than a hundredth;
/// loads that stop, turn or begin, one and more.
constexpr double telling = 0.1;
/// The same over the forces in balance: beyond it Newton's second order is far off.
constexpr double near = 0.3;

/// |f(x)|_2; infinite where it cannot be evaluated.
double residual_size(NonlinearSystem& system, const Vector& x) {
  Vector f(x.getMap());
  try {
    system.residual(x, f);
  } catch (const SolveError&) {
    return std::numeric_limits<double>::infinity();
  }
  const double size = f.norm2();
  return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

} // namespace

bool StepStart::predict(NonlinearSystem& system, Vector& x, double dt) {
  if (extrapolate(system, x, dt))
    return true;
  Vector rhs(x.getMap()), dx(x.getMap());
  const auto tangent = system.predictor(x, rhs);
  LinearSolver& linear = newton_.linear();
  linear.setup(tangent, system.graph_version(), system.symmetric());
  linear.solve(rhs, dx, newton_.predictor_tolerance());
  x.update(1.0, dx, 1.0);
  system.apply_constraints(x);
  return false;
}

/// Stick and slip of a friction point depend on the way there, so with friction no start is free.
bool StepStart::extrapolate(NonlinearSystem& system, Vector& x, double dt) const {
  const bool wanted = kind_ == StepPrediction::extrapolation ||
                      (kind_ == StepPrediction::automatic && system.symmetric());
  if (!wanted || !trusted_ || last_.velocity.is_null())
    return false;
  Vector stay(x, Teuchos::Copy);
  system.apply_constraints(stay);
  system.begin_solve(SolveKind::newton);
  double least = telling * residual_size(system, stay);
  bool found = false;
  for (Vector& ahead : continuations(x, dt)) {
    system.apply_constraints(ahead);
    const double size = residual_size(system, ahead);
    if (!(size <= least && size <= near * system.reference_force()))
      continue;
    least = size;
    found = true;
    Tpetra::deep_copy(x, ahead);
  }
  return found;
}

/// Newton's divided differences through the last states: the line, and the parabola if any.
std::vector<Vector> StepStart::continuations(const Vector& x, double dt) const {
  std::vector<Vector> all;
  all.emplace_back(x, Teuchos::Copy);
  all[0].update(dt, *last_.velocity, 1.0);
  if (!before_last_.velocity.is_null()) {
    const double bend = dt * (dt + last_.dt) / (last_.dt + before_last_.dt);
    all.emplace_back(all[0], Teuchos::Copy);
    all[1].update(bend, *last_.velocity, -bend, *before_last_.velocity, 1.0);
  }
  return all;
}

void StepStart::accepted(const Vector& before, const Vector& x, double dt, bool alone) {
  before_last_ = last_;
  const auto velocity = rcp(new Vector(x, Teuchos::Copy));
  velocity->update(-1.0 / dt, before, 1.0 / dt);
  last_ = alone ? StepMotion{velocity, dt} : StepMotion{};
  trusted_ = true;
}

} // namespace abut::solver
