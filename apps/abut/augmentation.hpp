// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/augmentation_policy.hpp"
#include "abut/solver/augmented.hpp"

#include <functional>
#include <string>

namespace abut::app {

/// The policy as the solver asks it; empty where there is nothing to ask. `observer` sees every
/// report, `warn` what it has to say besides.
solver::AugmentCallback
make_augmentation(const contact::AugmentationPolicy& policy,
                  std::function<void(int, const solver::AugmentReport&)> observer = {},
                  std::function<void(const std::string&)> warn = {});

} // namespace abut::app
