// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace abut::contact {

/// What the interfaces say after a converged solve.
struct AugmentationReport {
  bool converged = true;             ///< no further solve is needed
  bool stalled = false;              ///< further augmentations change nothing; stop, with reason
  double change = 0.0;               ///< largest relative change of multipliers [1]
  double gap = 0.0;                  ///< largest violation over face size [1]
  std::string reason;                ///< one sentence, for the log
  std::vector<std::string> warnings; ///< once a step for each interface that converges slowly
};

/// The outer loop of augmented Lagrangian over all interfaces of a model: judges each by its own
/// settings after a solve, between the smallest and the largest number of augmentations, and
/// changes multipliers where another solve is worth it. Sticky points that pull too hard come off
/// first. It knows no solver: the host solves, asks, and solves again until it need not.
class AugmentationPolicy {
public:
  /// energy: see Interaction::augmentation.
  explicit AugmentationPolicy(std::vector<std::shared_ptr<Interaction>> interfaces,
                              EnergyOfBodies energy = {});

  /// Whether there is anything to ask after a solve.
  bool is_needed() const { return !augmented_.empty() || may_tear(); }
  /// Whether solves that multipliers will still change after may be loose: a status that has not
  /// come to rest would be augmented into the multipliers of friction.
  bool allows_loose_solves() const;
  /// After a converged solve with `number` augmentations done in this step. When the report is
  /// neither converged nor stalled multipliers have changed, and another solve is due. Collective.
  AugmentationReport operator()(int number);

private:
  bool may_tear() const;
  bool augments_in_steps() const;
  bool tear();
  Augmentation judge(Interaction& interface, int number, AugmentationReport& report) const;
  void conclude(AugmentationReport& report);

  std::vector<std::shared_ptr<Interaction>> interfaces_;
  EnergyOfBodies energy_;
  std::vector<Interaction*> augmented_;
  std::set<const Interaction*> warned_; ///< in this step
};

} // namespace abut::contact
