// SPDX-License-Identifier: BSD-3-Clause
#include "augmentation.hpp"

#include "abut/contact/augmentation_policy.hpp"

namespace abut::app {

solver::AugmentCallback
make_augmentation(const contact::AugmentationPolicy& policy,
                  std::function<void(int, const solver::AugmentReport&)> observer,
                  std::function<void(const std::string&)> warn) {
  if (!policy.is_needed())
    return {};
  return [policy = contact::AugmentationPolicy(policy), observer, warn](int number) mutable {
    const contact::AugmentationReport said = policy(number);
    const solver::AugmentReport report{said.converged, said.stalled, said.change, said.gap,
                                       said.reason};
    for (const std::string& warning : said.warnings)
      if (warn)
        warn(warning);
    if (observer)
      observer(number, report);
    return report;
  };
}

} // namespace abut::app
