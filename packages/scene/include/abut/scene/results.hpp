// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/io/result_writer.hpp"
#include "abut/scene/state.hpp"

namespace abut::scene {

/// The fields of the outside contract (Exodus output), and those of `further` behind them.
io::ResultNames result_names(const Scene& scene, const io::FieldOptions& further);
/// Their values. Collective.
io::ResultStep result_step(const Scene& scene, const State& state, const io::FieldOptions& further);

} // namespace abut::scene
