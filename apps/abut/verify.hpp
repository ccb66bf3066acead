// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/scene/state.hpp"

namespace abut::app {

struct Verdict {
  std::string name;
  double value = 0.0, expected = 0.0, tolerance = 0.0; ///< tolerance absolute
  bool ok = false;
};

/// The deck's `verify` entries against the last converged state. Collective.
std::vector<Verdict> verify(const Model& model, const scene::State& state);

} // namespace abut::app
