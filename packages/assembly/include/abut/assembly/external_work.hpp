// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "abut/rigid/joints.hpp"

#include <vector>

namespace abut::assembly {

/// Work done from outside between the accepted states, by the trapezoidal rule [energy].
struct ExternalWork {
  double loads = 0.0;
  double supports = 0.0; ///< prescribed unknowns and prescribed motion of rigid bodies
};

/// Adds up the work from one accepted state to the next; the first starts from rest without loads.
class WorkLedger {
public:
  struct State {
    std::vector<double> x, loads, raw; ///< (owned scalar rows) unknowns, loads, raw residual
    std::vector<rigid::BodyState> bodies;
    std::vector<rigid::JointState> joints;
  };

  /// The work since the last state. constrained: (owned scalar rows), of which the first node_rows
  /// are of nodes. Collective.
  void add(State now, const std::vector<char>& constrained, std::size_t node_rows,
           const rigid::Joints& joints, const Comm& comm);

  /// rows: keys of the owned block rows of three.
  void exchange_state(StateArchive& archive, const std::vector<Global>& rows);

  const ExternalWork& work() const { return work_; }
  const std::vector<double>& last_x() const { return last_.x; } ///< empty before the first state

private:
  State last_;
  ExternalWork work_;
};

} // namespace abut::assembly
