// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/state.hpp"

#include <vector>

namespace abut::scene {

/// By how much contact is too soft because its surfaces sink into each other, as fractions: of the
/// force where displacements are given, of the displacement where forces are. 0 where the bodies
/// store no energy: then the penalty is all the stiffness there is.
struct PenaltyError {
  double whole = 0.0;           ///< of all interfaces together
  std::vector<double> contacts; ///< what each adds to it
  /// Largest penetration over the approach, the way by which linear bodies come together that store
  /// the elastic energy of the model under the normal force of the interface: twice their quotient.
  std::vector<double> penetration_over_approach;
};

/// Follows the states of a run, from its start on. With E the energy stored in bodies and springs,
/// and in dynamics that of motion: springs in series share E as they share the way. With w = sum of
/// ContactSummary::softness a linear model is too soft by w/E. One that
/// stiffens is by 2 w E''/E'^2, with derivatives by t of the last two steps: more, up to twice as
/// much. Not collective.
class PenaltyWatch {
public:
  void look(const State& state);
  /// See StateNumbers.
  template <class V> void list_state(V& v) {
    v(last_, error_.whole, error_.contacts, error_.penetration_over_approach);
  }
  const PenaltyError& error() const { return error_; } ///< of the last state

private:
  struct Stored {
    double t = 0.0, energy = 0.0;
    template <class V> friend void list_state(V& v, Stored& s) { v(s.t, s.energy); }
  };
  double stiffening() const;

  std::vector<Stored> last_; ///< three at most
  PenaltyError error_;
};

} // namespace abut::scene
