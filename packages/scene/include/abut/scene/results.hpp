// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/io/result_writer.hpp"
#include "abut/scene/state.hpp"

namespace abut::scene {

/// The fields of the outside contract (Exodus output).
io::ResultNames result_names(const Scene& scene);
/// Throws InputError with where(key) when two contacts, rigid bodies or joints would write one
/// variable, or one too long a name.
void require_own_names(const Scene& scene, const Where& where);
/// Their values. Collective.
io::ResultStep result_step(const Scene& scene, const State& state);

} // namespace abut::scene
