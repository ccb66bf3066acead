// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/findings.hpp"
#include "abut/scene/reactions.hpp"
#include "abut/scene/scene.hpp"
#include "abut/solid/element_fields.hpp"
#include "abut/solver/load_stepping.hpp"

#include <vector>

namespace abut::scene {

/// Where the work of a run went, from its start [energy]. Closes to second order in the step.
struct Energy {
  double work_in = 0.0;  ///< by loads, supports and the motion of rigid bodies and joints
  double stored = 0.0;   ///< strain energy, and what springs between rigid bodies took up
  double penalty = 0.0;  ///< in the springs of contact; 0 once multipliers have converged
  double friction = 0.0; ///< dissipated
  double kinetic = 0.0, kinetic_at_start = 0.0;
  double imbalance() const {
    return work_in - stored - penalty - friction - (kinetic - kinetic_at_start);
  }
};

/// What is known of the last converged step.
struct State {
  double time = 0.0;
  solver::Counters counters;
  std::vector<double> u;          ///< (N, 3) displacement of local nodes
  std::vector<double> reaction;   ///< (owned rows, 3) force of supports on the body
  std::vector<Reaction> supports; ///< of Scene::supports
  std::vector<contact::ContactSummary> contacts;
  std::vector<solid::ElementFields> elements; ///< per block; empty for rigid ones
  Energy energy;
  audit::Measures audit;                      ///< of the last step that was looked at; 0: none
  std::vector<rigid::BodyState> rigid_bodies; ///< of Scene::rigid_bodies
  std::vector<rigid::JointState> joints;      ///< of Scene::joints
  // Of dynamics, else empty:
  std::vector<double> velocity, acceleration; ///< (N, 3)
  std::vector<rigid::BodyMotion> rigid_motions;
  Vec3 momentum = Vec3::zero(), angular_momentum = Vec3::zero(); ///< the latter about the origin
};

/// Of the bodies where the equations were last evaluated: strain, springs between rigid ones,
/// motion [energy]. Collective.
double energy_of_bodies(const Scene& scene);

/// Collective. The equations must have been evaluated at x.
State make_state(const Scene& scene, const Vector& x, double time,
                 const solver::Counters& counters);

} // namespace abut::scene
