// SPDX-License-Identifier: BSD-3-Clause
#include "audit_watch.hpp"

#include "abut/core/error.hpp"
#include "abut/solver/linear_solver.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace abut::app {

namespace {

constexpr double worth_telling = 1.1; ///< times what has been told

} // namespace

AuditWatch::AuditWatch(const Model& model, const std::vector<double>& u) : model_(model) {
  const solver::Stopwatch watch;
  if (model.deck.audit.every > 0) {
    audit_.emplace(model.deck, model, model.deck.audit.tolerance);
    audit_->begin_step(u);
  }
  seconds_ = watch.seconds();
}

bool AuditWatch::is_due() const {
  return audit_ && ((steps_ + 1) % model_.deck.audit.every == 0 ||
                    model_.equations->time() >= model_.deck.time.end);
}

void AuditWatch::look() {
  found_.reset();
  if (!is_due())
    return;
  const solver::Stopwatch watch;
  found_ = audit_->look();
  seconds_ += watch.seconds();
  if (model_.deck.audit.strict && !found_->list.empty())
    throw SolveError("audit: " + audit::text(found_->list.front(), audit_->names()));
}

void AuditWatch::accepted(const std::vector<double>& u, double t, Progress& progress) {
  ++steps_;
  if (!found_)
    return;
  audit_->begin_step(u);
  now_ = found_->measures;
  worst_.raise(now_);
  for (const audit::Finding& f : found_->list) {
    const auto known = std::find_if(told_.begin(), told_.end(),
                                    [&](const Told& one) { return are_alike(one.worst, f); });
    if (known == told_.end()) {
      progress.warning(text(f, t));
      told_.push_back({f, f, t});
    } else if (f.value > known->worst.value) {
      known->worst = f;
      known->t = t;
    }
  }
  found_.reset();
}

std::vector<std::string> AuditWatch::warnings() const {
  std::vector<std::string> result;
  for (const Told& one : told_)
    if (one.worst.value > worth_telling * one.first.value)
      result.push_back(text(one.worst, one.t));
  return result;
}

std::string AuditWatch::text(const audit::Finding& finding, double t) const {
  return fmt::format("audit: at t = {:.6g} {}", t, audit::text(finding, audit_->names()));
}

void AuditWatch::exchange_state(StateArchive& archive, const std::vector<double>& u) {
  if (archive.holds("audit")) // else it is of a run that had none
    archive.numbers("audit", [&](auto& v) { v(now_, worst_, steps_); });
  if (archive.takes() && audit_)
    audit_->begin_step(u);
}

} // namespace abut::app
