// SPDX-License-Identifier: BSD-3-Clause
#include "augmentation.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace abut::app {

namespace {

std::vector<contact::Interaction*> augmented_interfaces(Model& m) {
  std::vector<contact::Interaction*> result;
  for (const auto& c : m.contacts)
    if (c->options().enforcement == contact::Enforcement::augmented_lagrangian)
      result.push_back(c.get());
  return result;
}

/// Whether sticky points come off; then the solve must be done again. Collective.
bool tear(Model& m) {
  bool torn = false;
  for (const auto& c : m.contacts)
    torn = c->tear() || torn;
  if (torn)
    m.equations->state_changed();
  return torn;
}

/// Judges one interface; adds to the report what it has to say.
contact::Augmentation judge(contact::Interaction& c, int number, solver::AugmentReport& report) {
  const contact::Augmentation a = c.augmentation();
  report.change = std::max(report.change, a.change);
  report.gap = std::max(report.gap, a.gap);
  if (c.options().augments_at_end() || !c.acts())
    return a;
  if (number < c.options().min_augmentations) {
    report.converged = false;
  } else if (!a.converged && number >= c.options().max_augmentations) {
    report.stalled = true;
    report.reason = fmt::format("{}: stopped at max_augmentations = {}", c.name(), number);
  } else if (a.stalled) {
    report.stalled = true;
    report.reason =
        fmt::format("{}: neither multipliers nor penetration get better any more", c.name());
    if (a.cause != contact::PlateauCause::none)
      report.reason += fmt::format("; {}", describe(a.cause));
  } else {
    report.converged = report.converged && a.converged;
  }
  return a;
}

} // namespace

bool may_tear(const Model& model) {
  return std::any_of(model.contacts.begin(), model.contacts.end(), [](const auto& c) {
    return c->options().sticky && c->options().stick_strength > 0.0;
  });
}

bool augments_in_steps(const Model& model) {
  return std::any_of(model.contacts.begin(), model.contacts.end(), [](const auto& c) {
    return c->options().enforcement == contact::Enforcement::augmented_lagrangian &&
           !c->options().augments_at_end();
  });
}

solver::AugmentCallback
make_augmentation(Model& m, std::function<void(int, const solver::AugmentReport&)> observer,
                  std::function<void(const std::string&)> warn) {
  const auto interfaces = augmented_interfaces(m);
  if (interfaces.empty() && !may_tear(m))
    return {};
  std::set<const contact::Interaction*> warned; // in this step
  return [&m, interfaces, observer, warn, warned](int number) mutable {
    if (number == 0)
      warned.clear();
    solver::AugmentReport report;
    if (tear(m)) {
      report.converged = false;
      if (observer)
        observer(number, report);
      return report;
    }
    for (contact::Interaction* c : interfaces) {
      const contact::Augmentation a = judge(*c, number, report);
      if (warn && a.cause != contact::PlateauCause::none && !a.stalled && warned.insert(c).second)
        warn(fmt::format("{}: augmentations bring little; {}", c->name(), describe(a.cause)));
    }
    report.stalled = report.stalled && report.converged; // others may still have work to do
    if (report.stalled) {
      report.converged = false;
    } else if (!report.converged) {
      for (contact::Interaction* c : interfaces)
        if (!c->options().augments_at_end() && c->acts())
          c->augment();
      m.equations->state_changed();
    } else if (report.reason.empty()) {
      report.reason = interfaces.empty()     ? "no sticky point comes off"
                      : augments_in_steps(m) ? "multipliers and gap within tolerance"
                                             : "multipliers change at the end of the step";
    }
    if (observer)
      observer(number, report);
    return report;
  };
}

} // namespace abut::app
