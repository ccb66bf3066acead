// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"
#include "progress.hpp"

#include "abut/core/state_archive.hpp"
#include "abut/scene/step_audit.hpp"

#include <optional>
#include <string>
#include <vector>

namespace abut::app {

/// Audits the steps of a run as the deck asks for it, and tells what it finds.
class AuditWatch {
public:
  /// u: (N,3) where the first step begins. Collective.
  AuditWatch(const Model& model, const std::vector<double>& u);

  /// A solve has converged, and the equations were evaluated at its end: looks at it if it is its
  /// turn. Throws SolveError with what is found where the deck is strict. Collective.
  void look();
  /// That step was accepted: tells what is found for the first time.
  void accepted(const std::vector<double>& u, double t, Progress& progress);
  /// What became worse after it had been told.
  std::vector<std::string> warnings() const;

  const audit::Measures& now() const { return now_; }
  const audit::Measures& worst() const { return worst_; } ///< of all steps
  double seconds() const { return seconds_; }             ///< spent on this rank

  void exchange_state(StateArchive& archive, const std::vector<double>& u);

private:
  struct Told {
    audit::Finding first, worst;
    double t; ///< of the worst
  };
  bool is_due() const;
  std::string text(const audit::Finding& finding, double t) const;

  const Model& model_;
  std::optional<scene::StepAudit> audit_; ///< none: not asked for
  std::optional<audit::Findings> found_;  ///< of the step that has not been accepted yet
  audit::Measures now_, worst_;
  long long steps_ = 0; ///< accepted
  std::vector<Told> told_;
  double seconds_ = 0.0;
};

} // namespace abut::app
