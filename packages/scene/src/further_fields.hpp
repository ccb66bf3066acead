// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/io/result_writer.hpp"
#include "abut/scene/state.hpp"

namespace abut::scene {

/// Fields that a deck may ask for beside those of every run: they follow behind.
void add_further_names(const io::FieldOptions& further, io::ResultNames& names);
/// Rigid bodies have none: zeros. Collective.
void add_further_values(const Scene& scene, const State& state, const io::FieldOptions& further,
                        io::ResultStep& step);

} // namespace abut::scene
