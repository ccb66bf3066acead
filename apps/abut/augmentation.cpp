// SPDX-License-Identifier: BSD-3-Clause
#include "augmentation.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace abut::app {

namespace {

std::vector<contact::Interaction*> augmented_interfaces(Model& m) {
  std::vector<contact::Interaction*> result;
  for (const auto& c : m.contacts)
    if (c->options().enforcement == contact::Enforcement::augmented_lagrangian)
      result.push_back(c.get());
  return result;
}

/// Judges one interface; adds to the report what it has to say.
void judge(contact::Interaction& c, int number, solver::AugmentReport& report) {
  const contact::Augmentation a = c.augmentation();
  report.change = std::max(report.change, a.change);
  report.gap = std::max(report.gap, a.gap);
  if (number < c.options().min_augmentations) {
    report.converged = false;
  } else if (!a.converged && number >= c.options().max_augmentations) {
    report.stalled = true;
    report.reason = fmt::format("{}: stopped at max_augmentations = {}", c.name(), number);
  } else if (a.stalled) {
    report.stalled = true;
    report.reason =
        fmt::format("{}: neither multipliers nor penetration get better any more", c.name());
  } else {
    report.converged = report.converged && a.converged;
  }
}

} // namespace

solver::AugmentCallback
make_augmentation(Model& m, std::function<void(int, const solver::AugmentReport&)> observer) {
  const auto interfaces = augmented_interfaces(m);
  if (interfaces.empty())
    return {};
  return [&m, interfaces, observer](int number) {
    solver::AugmentReport report;
    for (contact::Interaction* c : interfaces)
      judge(*c, number, report);
    report.stalled = report.stalled && report.converged; // others may still have work to do
    if (report.stalled) {
      report.converged = false;
    } else if (!report.converged) {
      for (contact::Interaction* c : interfaces)
        c->augment();
      m.equations->state_changed();
    } else if (report.reason.empty()) {
      report.reason = "multipliers and gap within tolerance";
    }
    if (observer)
      observer(number, report);
    return report;
  };
}

} // namespace abut::app
