// SPDX-License-Identifier: BSD-3-Clause
// What changes an interaction between evaluations, in the order of abut/core/contribution.hpp.
#include "history/exchange.hpp"
#include "history/steps.hpp"
#include "interaction_parts.hpp"

namespace abut::contact {

void Interaction::begin_step() {
  parts_->state_version += parts_->data.terms.search_hold > 0.0;
  parts_->step_iterates = 0;
}

void Interaction::begin_solve(SolveKind kind) {
  Parts& p = *parts_;
  p.state_version += kind != p.solve;
  if (p.from_afar())
    restart_search(p.data);
  if (kind == SolveKind::landing) { // what failed has nothing to tell
    drop_step(p.data);
    p.step_iterates = 0;
  }
  p.solve = kind;
  p.iterates = 0;
}

void Interaction::iterate_taken() {
  Parts& p = *parts_;
  if (p.data.acts)
    take_iterate(p.data, p.step_iterates == 0);
  if (p.seeks_hold())
    p.hold.take_iterate(p.data.terms.law, p.iterates == 0);
  p.step_iterates += !p.from_afar();
  ++p.iterates;
  ++p.state_version;
}

void Interaction::accept() {
  Parts& p = *parts_;
  if (!p.data.acts && p.started) {
    forget_history(p.data);
    p.augmenter.restart();
    p.started = false;
  }
  p.augmenter.choose_factor();
  p.augmenter.propose_at_end();
  end_step(p.data);
  p.augmenter.take_at_end();
  keep_history(p.data);
  if (p.data.acts)
    take_iterate(p.data, p.step_iterates == 0);
  restart_search(p.data);
  if (settings().update_penalty)
    p.data.place.primary().update_stretch();
  bool contact = false;
  for (Local i = 0; i < p.data.points.size(); ++i)
    contact = contact || p.data.points.converged(i).in_contact;
  p.established = p.data.comm.any(contact);
  p.data.place.accept();
  p.augmenter.clear();
  p.iterates = p.step_iterates = 0;
}

void Interaction::reject() {
  Parts& p = *parts_;
  drop_step(p.data);
  p.augmenter.clear();
  p.iterates = p.step_iterates = 0;
  ++p.state_version;
}

void exchange_state(StateArchive& archive, Interaction& interface, const NodalFields& accepted) {
  Interaction::Parts& p = *interface.parts_;
  const std::string path = "contact." + p.data.settings.name + ".";
  archive.numbers(path + "interface", [&](auto& v) {
    v(p.started, p.established, p.data.factor, p.data.terms.law.hair_share);
    p.augmenter.list_state(v);
  });
  exchange_history(archive, path, p.data);
  if (!archive.takes())
    return;
  p.data.place.start_at(accepted);
  p.augmenter.clear();
  p.iterates = p.step_iterates = 0;
  ++p.state_version;
}

Augmentation Interaction::augmentation(const EnergyOfBodies& energy) {
  return parts_->augmenter.judge(energy);
}

void Interaction::augment() {
  parts_->augmenter.augment();
  freeze(parts_->data);
  parts_->iterates = 0;
  ++parts_->state_version;
}

bool Interaction::tear() {
  if (!settings().sticky)
    return false;
  const bool torn = contact::tear(parts_->data);
  parts_->state_version += torn;
  return torn;
}

} // namespace abut::contact
