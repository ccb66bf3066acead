// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace abut::solver {

class NonlinearSystem;

/// How exactly an iterative method is to solve Newton's linear systems: to a tenth of what Newton's
/// own error will leave of the residual, foretold by the last correction as of second order, and no
/// further than convergence asks for. After Eisenstat and Walker, Choosing the forcing terms in an
/// inexact Newton method, SIAM J. Sci. Comput. 17 (1996), choices 1 and 2.
/// Friction forces may be tiny beside the normal ones that a residual is compared with: unsymmetric
/// systems are solved further.
class ForcingTerm {
public:
  static constexpr double loosest = 1e-3, finest = 1e-9; ///< tolerances [1]

  /// Where Newton ends: newton_tolerance: residual over the system's reference force;
  /// displacement_tolerance: correction over the increment of a step. [1]
  ForcingTerm(double newton_tolerance, std::optional<double> displacement_tolerance)
      : newton_tolerance_(newton_tolerance), displacement_tolerance_(displacement_tolerance) {}

  /// A solve begins; its first residual is not that of a correction. The system must outlive it.
  void begin_solve(const NonlinearSystem& system);

  /// For K dx = -f, |f|_2 = residual > 0 [force]: what |f + K dx| / |f| may be. [1]
  double tolerance(double residual);
  /// That system has been solved so far.
  void solved(double relative_residual) { linear_part_ = relative_residual * last_residual_; }

  /// For the linear system that predicts a step: a tenth of what predictions leave. The first one
  /// is solved as far as a correction would count: in a linear scene there is nothing else to do.
  double predictor_tolerance();

  /// What it keeps from step to step, see StateNumbers.
  template <class V> void list_state(V& v) {
    bool known = prediction_error_.has_value();
    double error = prediction_error_.value_or(0.0);
    v(first_share_, known, error);
    prediction_error_ = known ? std::optional<double>(error) : std::nullopt;
  }

private:
  double sufficient(double residual) const;

  double newton_tolerance_;
  std::optional<double> displacement_tolerance_;
  const NonlinearSystem* system_ = nullptr;
  int iterates_ = 0;            ///< of this solve that a system has been solved at
  double first_residual_ = 0.0; ///< of this solve [force]
  double last_residual_ = 0.0;  ///< of the last one [force]
  double linear_part_ = 0.0;    ///< what the last linear solve left of it [force]
  double first_share_ = 1.0;    ///< of a solve's first residual, what Newton leaves by itself [1]
  /// Residual over reference force after the last prediction. [1]
  std::optional<double> prediction_error_;
  bool predicted_ = false;
};

} // namespace abut::solver
