// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/scene/penalty_error.hpp"
#include "abut/scene/state.hpp"

#include <string>
#include <vector>

namespace abut::app {

/// What is suspicious in the surfaces of an interface at the start: without partners, facing the
/// wrong way, deep in each other. The equations must have been evaluated there. Collective.
std::vector<std::string> warnings_of_start(const Model& model);

/// How many points of each interface have their gap counted from another zero than that of the
/// meshes, and by how much: "contact.NAME: ...". Where an interface fits or closes, also when none
/// has. The equations must have been evaluated at the start. Collective.
std::vector<std::string> shifts_of_start(const Model& model);

/// Watches which interfaces ever touch, and how deep.
class ContactWatch {
public:
  void look(const scene::State& state);
  /// Of a run that has ended: those that never touched, though they acted; those whose points sank
  /// so deep that their pressure means little.
  std::vector<std::string> warnings(const Model& model, bool converged) const;

  /// See StateNumbers.
  template <class V> void list_state(V& v) { v(looks_, seen_); }

private:
  int looks_ = 0;
  struct Seen {
    bool touched = false;
    double deepest = 0.0; ///< in sizes of the face
    template <class V> friend void list_state(V& v, Seen& s) { v(s.touched, s.deepest); }
  };
  std::vector<Seen> seen_;
};

/// Where contact is too soft by more than 2 % in the last state of a run: by how much, and the word
/// that would mend it.
std::vector<std::string> warnings_of_penalty(const Model& model, const scene::PenaltyError& error);

} // namespace abut::app
