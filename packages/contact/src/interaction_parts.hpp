// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"
#include "history/nearest_hold.hpp"
#include "interface_data.hpp"
#include "kernels/pairs.hpp"
#include "multipliers/augmenter.hpp"
#include "spaces/node_cells.hpp"

namespace abut::contact {

/// What an interaction consists of: evaluated in interaction.cpp, changed by the events of
/// history/events.cpp.
struct Interaction::Parts {
  Parts(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
        const ContactOptions& options, PhaseTimers& phase_timers, double share)
      : data(comm, std::move(primary), std::move(secondary), options, share), augmenter(data),
        timers(phase_timers) {}

  /// What the settings say at the present time.
  void set_terms(double time);
  /// Outside of its window: no partners, no forces. What the points remember stays until a step of
  /// this kind is accepted, for it may yet be cut.
  void rest();
  /// Partners, readings and the law, at points or nodes.
  void evaluate_sites();
  bool may_hold() const { return hold.is_asked_for() && !established; }
  /// Whether the solve under way is one in which nearest points hold what nothing else does.
  bool seeks_hold() const {
    return may_hold() && (solve == SolveKind::prediction || solve == SolveKind::approach);
  }
  /// Whether the solve under way leads to where the next one starts.
  bool from_afar() const { return solve == SolveKind::approach || solve == SolveKind::landing; }
  void build_pairs();
  void add_node_rows(const NodeRowArrays& rows) const;

  InterfaceData data;
  Augmenter augmenter;
  PhaseTimers& timers;
  std::function<double(double)> penalty_schedule, friction_schedule, interference_schedule;
  NormalLaw normal_law;
  double end = 1.0; ///< t at which an initial overlap is resolved and an interference whole
  bool exact_tangent = false;
  NearestHold hold; ///< see Interaction::hold_by_nearest

  PairArrays pairs;
  NodeCells node_cells;
  Connectivity connectivity;
  mutable Connectivity candidates;
  long connectivity_version = 0, state_version = 0;

  bool started = false;                ///< the points have their history
  bool established = false;            ///< some point was in contact at the last converged step
  SolveKind solve = SolveKind::newton; ///< under way
  int iterates = 0;                    ///< taken in this solve
  int step_iterates = 0;               ///< taken in this step
};

} // namespace abut::contact
