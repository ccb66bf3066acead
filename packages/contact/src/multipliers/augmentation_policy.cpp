// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/augmentation_policy.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

AugmentationPolicy::AugmentationPolicy(std::vector<std::shared_ptr<Interaction>> interfaces,
                                       EnergyOfBodies energy)
    : interfaces_(std::move(interfaces)), energy_(std::move(energy)) {
  for (const auto& i : interfaces_)
    if (i->settings().augmented())
      augmented_.push_back(i.get());
}

bool AugmentationPolicy::may_tear() const {
  return std::any_of(interfaces_.begin(), interfaces_.end(), [](const auto& i) {
    return i->settings().sticky && std::isfinite(i->settings().stick_strength);
  });
}

bool AugmentationPolicy::augments_in_steps() const {
  return std::any_of(augmented_.begin(), augmented_.end(),
                     [](const Interaction* i) { return !i->settings().augments_at_end(); });
}

bool AugmentationPolicy::allows_loose_solves() const {
  return augments_in_steps() && !may_tear() &&
         std::all_of(interfaces_.begin(), interfaces_.end(),
                     [](const auto& i) { return i->settings().friction == 0.0; });
}

/// Whether sticky points come off; then the solve must be done again.
bool AugmentationPolicy::tear() {
  bool torn = false;
  for (const auto& i : interfaces_)
    torn = i->tear() || torn;
  return torn;
}

/// Judges one interface; adds to the report what it has to say.
Augmentation AugmentationPolicy::judge(Interaction& interface, int number,
                                       AugmentationReport& report) const {
  const Settings& settings = interface.settings();
  const Augmentation a = interface.augmentation(energy_);
  report.change = std::max(report.change, a.change);
  report.gap = std::max(report.gap, a.gap);
  if (settings.augments_at_end() || !interface.acts())
    return a;
  if (number < settings.min_augmentations) {
    report.converged = false;
  } else if (!a.converged && number >= settings.max_augmentations) {
    report.stalled = true;
    report.reason = settings.name + ": stopped at max_augmentations = " + std::to_string(number);
  } else if (a.stalled) {
    report.stalled = true;
    report.reason = settings.name + ": neither multipliers nor penetration get better any more";
    if (a.cause != PlateauCause::none)
      report.reason += std::string("; ") + describe(a.cause);
  } else {
    report.converged = report.converged && a.converged;
  }
  return a;
}

/// Multipliers change where any interface asks for another solve.
void AugmentationPolicy::conclude(AugmentationReport& report) {
  report.stalled = report.stalled && report.converged; // others may still have work to do
  if (report.stalled) {
    report.converged = false;
  } else if (!report.converged) {
    for (Interaction* i : augmented_)
      if (!i->settings().augments_at_end() && i->acts())
        i->augment();
  } else if (report.reason.empty()) {
    report.reason = augmented_.empty()    ? "no sticky point comes off"
                    : augments_in_steps() ? "multipliers and gap within tolerance"
                                          : "multipliers change at the end of the step";
  }
}

AugmentationReport AugmentationPolicy::operator()(int number) {
  if (number == 0)
    warned_.clear();
  AugmentationReport report;
  if (tear()) {
    report.converged = false;
    return report;
  }
  for (Interaction* i : augmented_) {
    const Augmentation a = judge(*i, number, report);
    if (a.cause != PlateauCause::none && !a.stalled && warned_.insert(i).second)
      report.warnings.push_back(i->settings().name + ": augmentations bring little; " +
                                describe(a.cause));
  }
  conclude(report);
  return report;
}

} // namespace abut::contact
