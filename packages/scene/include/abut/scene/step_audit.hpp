// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/audit.hpp"
#include "abut/scene/scene.hpp"

#include <vector>

namespace abut::scene {

/// What an interface says of itself where the equations were last evaluated. Collective.
audit::Belief belief_of(const mesh::Mesh& mesh, contact::Interaction& contact);

/// The audit of a scene's converged steps. The scene must outlive it.
class StepAudit {
public:
  /// Collective.
  StepAudit(const Options& options, const Scene& scene, double tolerance);

  /// Displacements u (N,3) from which the next step begins.
  void begin_step(const std::vector<double>& u) { audit_.begin_step(u.data()); }
  /// Of the state where the equations were last evaluated. Collective.
  audit::Findings look();
  const audit::Names& names() const { return audit_.names(); }

private:
  const Scene& scene_;
  audit::Audit audit_;
};

} // namespace abut::scene
