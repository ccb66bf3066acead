// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/time_integration.hpp"

#include <optional>
#include <string>

namespace abut::solver {

enum class LinearMethod {
  automatic, ///< direct up to `direct_limit` unknowns, Krylov beyond; see make_linear_solver
  direct,    ///< MUMPS
  krylov,    ///< Belos: CG for a symmetric operator, GMRES otherwise
};
enum class Preconditioner { automatic, multigrid, muelu, ilu };
enum class StepPrediction {
  automatic,     ///< extrapolation where the last step tells of the next one
  tangent,       ///< a linear solve with the tangent of the last state
  extrapolation, ///< the same where friction makes the way matter
};
enum class LineSearch { automatic, none };

struct LinearOptions {
  LinearMethod method = LinearMethod::automatic;
  long long direct_limit = 2500;
  /// Beyond so many a factorization takes minutes and gigabytes (at 325,000 more than 9 of each):
  /// where Krylov fails, automatic tries a shorter step first.
  long long dear_limit = 150'000;
  Preconditioner preconditioner = Preconditioner::automatic;
  /// Of a Krylov solve, relative residual; none: as exact as Newton has use for. [1]
  std::optional<double> tolerance;
  int max_iterations = 500;
  /// Trilinos parameter lists as XML text, merged over abut's own: Belos, MueLu, Ifpack2.
  std::string belos, muelu, ifpack2;
};

struct NewtonOptions {
  double tolerance = 1e-8; ///< residual over reference force [1]
  /// When given, a solve also ends where the last correction is at most this share of the step's
  /// whole increment (2-norms over all unknowns) and the work |dx . f| left of it at most
  /// `energy_tolerance` times the largest of the step. [1]
  std::optional<double> displacement_tolerance;
  double energy_tolerance = 1e-2; ///< see displacement_tolerance [1]
  int max_iterations = 25;
  LineSearch line_search = LineSearch::automatic;
  bool inexact = true; ///< without friction: solves that an augmentation follows stop early
  std::string nox;     ///< NOX parameter list as XML text, merged over abut's own
};

/// Load parameter t from 0 to `end`.
struct TimeOptions {
  double end = 1.0;
  int steps = 1;              ///< equal steps to start with
  bool adaptive = true;       ///< grow again after a cut, and cut after a failed step
  double min_fraction = 1e-3; ///< smallest step as a fraction of end/steps
  int max_cuts = 8;           ///< in a row, on one step
  StepPrediction prediction = StepPrediction::automatic;
  int target_iterations = 10; ///< Newton iterations of a step that keeps its size
};

/// Whether bodies have inertia, and how time goes on.
struct DynamicsOptions {
  bool active = false;               ///< else t is a load parameter
  double spectral_radius = 1.0;      ///< see TimeIntegration
  std::optional<double> beta, gamma; ///< Newmark's, instead of spectral_radius

  TimeIntegration rule() const {
    TimeIntegration rule = TimeIntegration::with_spectral_radius(spectral_radius);
    rule.beta = beta.value_or(rule.beta);
    rule.gamma = gamma.value_or(rule.gamma);
    return rule;
  }
};

} // namespace abut::solver
