// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/state.hpp"

#include <string>
#include <vector>

namespace abut::scene {

/// A number that the whole model, a contact, support, body or joint has at a time: a global
/// variable of the results and a column of the history.
struct GlobalVariable {
  std::string name;
  std::string key; ///< of the options that it belongs to, e.g. contact.press; empty: the whole run
  std::string meaning;
  std::string unit; ///< in words, e.g. "force length"; empty: a pure number
  double value = 0.0;
};

/// In the order of the results. The same on all ranks; not collective.
std::vector<GlobalVariable> global_variables(const Scene& scene, const State& state);
/// The same without values: there is no state yet.
std::vector<GlobalVariable> global_variables(const Scene& scene);

/// Throws InputError with where(key) when two contacts, supports, rigid bodies or joints would
/// write one variable, or one too long a name.
void require_own_names(const Scene& scene, const Where& where);

} // namespace abut::scene
