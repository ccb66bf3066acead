// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/solver/augmented.hpp"

#include <functional>

namespace abut::app {

/// The augmentation of all interfaces with enforcement augmented_lagrangian; an empty callback when
/// there is none. `observer` sees every report.
solver::AugmentCallback
make_augmentation(Model& model,
                  std::function<void(int, const solver::AugmentReport&)> observer = {});

} // namespace abut::app
