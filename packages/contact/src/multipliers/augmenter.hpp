// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multipliers/anderson.hpp"
#include "multipliers/averages.hpp"
#include "multipliers/plateau.hpp"

namespace abut::contact {

/// Multipliers of an interface: what the next ones are, whether another solve with them is worth
/// it, and how they are taken over. The same for points and nodes: both are sites.
class Augmenter {
public:
  explicit Augmenter(InterfaceData& data) : data_(data), watch_(data.comm), anderson_(data.comm) {}

  /// Another update of the multipliers; empty: the space's own.
  void set_update(MultiplierUpdate update) { update_ = std::move(update); }

  /// What the next multipliers would be in the last evaluated configuration. Collective.
  Augmentation judge(const EnergyOfBodies& energy);
  /// They become the multipliers, of stick and slip alike. Collective.
  void augment();
  /// The state has been evaluated anew: a proposal does not hold any longer.
  void forget_proposal() { proposed_ = false; }

  /// The tractions at the end of a step become multipliers where the settings say so: first the
  /// proposal, from the state of the step, then, when it has become history, the taking over.
  void propose_at_end();
  void take_at_end();
  /// The next solves are of another step.
  void clear();
  /// The next step is the first one again.
  void restart();
  /// What it keeps from step to step, see StateNumbers.
  template <class V> void list_state(V& v) { v(increments_, factor_chosen_); }
  /// Averages leave a penetration of no more than p_max/(6 f E) face sizes: f for the one that is
  /// asked for. Once, at the end of the first step in contact. Collective.
  void choose_factor();

private:
  bool smoothed() const { return data_.settings.multipliers == Multipliers::smoothed; }
  bool accelerates() const { return data_.settings.anderson && !update_; }
  void propose(Augmentation& result);
  void propose_own();
  void measure_sites(Augmentation& result);
  void judge_once(Augmentation& result);
  bool is_soft(const EnergyOfBodies& energy) const;
  double relative_change() const;
  double stiffness_factor() const;
  Global active_set() const;
  std::vector<double> next_pressures();
  void take(bool shear);
  void take_point(Local i, bool shear);

  InterfaceData& data_;
  MultiplierUpdate update_;
  std::vector<Multiplier> next_; ///< (sites) proposed
  bool proposed_ = false;        ///< for the present configuration
  bool increments_ = false;      ///< smoothed multipliers grow by averages of what springs carry
  bool factor_chosen_ = false;   ///< by the pressure of the first step in contact
  Judged judged_;                ///< of the last proposal
  PlateauWatch watch_;
  Anderson anderson_;
  std::vector<char> last_active_; ///< (sites) pressed at the last augmentation
};

} // namespace abut::contact
