// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/solver/augmented.hpp"

#include <functional>

namespace abut::app {

/// The augmentation of all interfaces with enforcement augmented_lagrangian, and the coming off of
/// sticky points; an empty callback when there is neither. `observer` sees every report; `warn` is
/// told, once for each interface and step, what holds its augmentations up.
solver::AugmentCallback
make_augmentation(Model& model,
                  std::function<void(int, const solver::AugmentReport&)> observer = {},
                  std::function<void(const std::string&)> warn = {});

/// Whether any interface may ask for another solve within a step.
bool augments_in_steps(const Model& model);

/// Whether sticky points may come off.
bool may_tear(const Model& model);

} // namespace abut::app
