// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/io/result_writer.hpp"
#include "abut/scene/state.hpp"

namespace abut::scene {

/// The fields of the outside contract (Exodus output).
io::ResultNames result_names(const Scene& scene);
/// Their values. Collective.
io::ResultStep result_step(const Scene& scene, const State& state);

} // namespace abut::scene
