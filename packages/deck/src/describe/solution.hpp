// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solver/options.hpp"
#include "rule.hpp"

namespace abut::deck {

template <class V> void describe(V& v, solver::TimeOptions& o) {
  v.optional("end", o.end, "the load parameter t runs from 0 to here", positive("1"));
  v.optional("steps", o.steps, "equal steps to start with", at_least(1.0, "1"));
  v.optional("adaptive", o.adaptive, "cut a failed step and grow again after it");
  v.optional("min_fraction", o.min_fraction, "smallest step as a fraction of end/steps",
             Rule{1e-12, 1.0, false, "1", ""});
  v.optional("max_cuts", o.max_cuts, "in a row, on one step", at_least(0.0, "1"));
  v.optional("target_iterations", o.target_iterations,
             "Newton iterations of a step that keeps its size", at_least(1.0, "1"));
  using solver::StepPrediction;
  v.choice("prediction", o.prediction,
           {{"automatic", StepPrediction::automatic,
             "extrapolation of the last step where that tells of the next one and there is no "
             "friction, else tangent"},
            {"tangent", StepPrediction::tangent, "a linear solve"},
            {"extrapolation", StepPrediction::extrapolation, "with friction, too"}},
           "where Newton starts a step");
}

template <class V> void describe(V& v, solver::DynamicsOptions& o) {
  v.optional("spectral_radius", o.spectral_radius,
             "what a step leaves of vibrations too fast for it; 1: all of them, the trapezoidal "
             "rule; below 1: generalised-alpha",
             Rule{0.0, 1.0, false, "1", ""});
  v.optional("beta", o.beta, "Newmark's, instead of spectral_radius", positive("1"));
  v.optional("gamma", o.gamma, "Newmark's, at least 0.5 and at most 2 beta",
             Rule{0.5, 1.0, false, "1", ""});
  for (const char* key : {"beta", "gamma"})
    v.check(key, o.spectral_radius == 1.0 || !(key[0] == 'b' ? o.beta : o.gamma),
            "spectral_radius below 1 gives beta and gamma");
  v.check(o.beta ? "beta" : "gamma", 2.0 * o.beta.value_or(0.25) >= o.gamma.value_or(0.5),
          "steps of any length are stable with 2 beta >= gamma >= 0.5");
}

template <class V> void describe(V& v, solver::NewtonOptions& o) {
  using solver::LineSearch;
  v.optional("tolerance", o.tolerance, "residual over reference force", positive("1"));
  v.number_or("displacement_tolerance", o.displacement_tolerance, "none",
              "a solve also ends when the last correction is at most this share of the step's "
              "increment, and its energy within energy_tolerance",
              positive("1"));
  v.optional("energy_tolerance", o.energy_tolerance,
             "with displacement_tolerance: the work left over the largest of the step",
             positive("1"));
  v.optional("max_iterations", o.max_iterations, "of one solve", at_least(1.0, "1"));
  v.choice("line_search", o.line_search,
           {{"automatic", LineSearch::automatic, "shorten a step that makes things worse"},
            {"none", LineSearch::none, "full Newton steps"}},
           "of the Newton step");
  v.optional("inexact", o.inexact,
             "without friction, solves that an augmentation will follow stop early");
}

template <class V> void describe(V& v, solver::LinearOptions& o) {
  using solver::LinearMethod;
  using solver::Preconditioner;
  v.choice("method", o.method,
           {{"automatic", LinearMethod::automatic,
             "direct up to direct_limit, Krylov beyond, and direct again "
             "where that fails"},
            {"direct", LinearMethod::direct, "MUMPS"},
            {"krylov", LinearMethod::krylov, "Belos: CG if symmetric, GMRES otherwise"}},
           "of the linear systems");
  v.optional("direct_limit", o.direct_limit, "unknowns up to which automatic means direct",
             at_least(0.0, "1"));
  v.choice("preconditioner", o.preconditioner,
           {{"automatic", Preconditioner::automatic, "abut's choice"},
            {"multigrid", Preconditioner::multigrid, "smoothed aggregation of node blocks"},
            {"muelu", Preconditioner::muelu, "MueLu's smoothed aggregation"},
            {"ilu", Preconditioner::ilu, "Ifpack2 incomplete factors"}},
           "of a Krylov solve");
  v.number_or("tolerance", o.tolerance, "automatic",
              "relative residual of a Krylov solve; automatic: 1e-3, and tighter where Newton "
              "comes close to its end",
              positive("1"));
  v.optional("max_iterations", o.max_iterations, "of a Krylov solve", at_least(1.0, "1"));
}

} // namespace abut::deck
