// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"
#include "keywords.hpp"

#include <cmath>

namespace abut::abaqus {

namespace {

/// By Rodrigues' formula: about the axis from a to b, by an angle in degrees.
void place(Scope& scope, std::array<double, 3> shift, const double* a, const double* b,
           double degrees) {
  constexpr double radian = 0.017453292519943295;
  const double s = std::sin(radian * degrees), c = std::cos(radian * degrees);
  std::array<double, 3> n{};
  double length = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    length += (b[i] - a[i]) * (b[i] - a[i]);
  for (std::size_t i = 0; i < 3; ++i)
    n[i] = (b[i] - a[i]) / std::sqrt(length);
  const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      scope.turn[i][k] = c * (i == k ? 1.0 : 0.0) + s * cross[i][k] + (1.0 - c) * n[i] * n[k];
  // The part is shifted first, and then turned about the axis.
  for (std::size_t i = 0; i < 3; ++i) {
    scope.shift[i] = a[i];
    for (std::size_t k = 0; k < 3; ++k)
      scope.shift[i] += scope.turn[i][k] * (shift[k] - a[k]);
  }
}

bool is_structure(const Card& card) {
  for (const char* name : {"PART", "END PART", "ASSEMBLY", "END ASSEMBLY", "INSTANCE",
                           "END INSTANCE", "STEP", "END STEP"})
    if (card.is(name))
      return true;
  return false;
}

} // namespace

Structure::Structure(Cards& cards) : cards_(cards.list()) {
  scopes.push_back(std::make_unique<Scope>());
  scope_ = scopes.front().get();
  for (std::size_t at = 0; at < cards_.size(); ++at)
    card(at);
  if (open_step_)
    open_step_->fail("there is no *END STEP");
  for (const auto& [name, list] : parts_)
    if (!placed_[name])
      for (const std::size_t c : list)
        cards_[c].set_ignored("the part has no *INSTANCE");
}

void Structure::card(std::size_t& at) {
  Card& card = cards_[at];
  if (is_structure(card))
    card.use();
  if (card.is("PART")) {
    part(at);
  } else if (card.is("ASSEMBLY")) {
    card.parameter("NAME");
    in_assembly_ = true;
  } else if (card.is("END ASSEMBLY")) {
    in_assembly_ = false;
  } else if (card.is("INSTANCE")) {
    if (!in_assembly_ || scope_ != scopes.front().get())
      card.fail("expected within an *ASSEMBLY, each behind the *END INSTANCE of the last one");
    instance(card);
  } else if (card.is("END INSTANCE")) {
    scope_ = scopes.front().get();
  } else if (card.is("STEP")) {
    if (open_step_)
      card.fail("expected an *END STEP before it");
    open_step_ = &card;
    steps.push_back(&card);
  } else if (card.is("END STEP")) {
    if (!open_step_)
      card.fail("there is no *STEP before it");
    open_step_ = nullptr;
  } else if (card.is("END PART")) {
    card.fail("there is no *PART before it");
  } else {
    items.push_back({&card, scope_, open_step_ ? static_cast<int>(steps.size()) - 1 : -1});
  }
}

void Structure::part(std::size_t& at) {
  Card& first = cards_[at];
  const std::string name = first.required("NAME");
  if (open_step_ || in_assembly_)
    first.fail("expected before the *ASSEMBLY");
  const auto [list, is_new] = parts_.emplace(key_of(name), std::vector<std::size_t>());
  if (!is_new)
    first.fail("there is a part '" + name + "' already");
  for (++at; at < cards_.size() && !cards_[at].is("END PART"); ++at)
    if (is_structure(cards_[at]))
      cards_[at].fail("expected an *END PART before it");
    else
      list->second.push_back(at);
  if (at == cards_.size())
    first.fail("there is no *END PART");
  cards_[at].use();
}

void Structure::instance(Card& card) {
  const std::string name = card.required("NAME");
  const auto part = card.parameter("PART");
  scopes.push_back(std::make_unique<Scope>());
  scope_ = scopes.back().get();
  scope_->spelled = name_of(card, name) + ".";
  scope_->prefix = key_of(scope_->spelled);
  for (const auto& other : scopes)
    if (other.get() != scope_ && other->prefix == scope_->prefix)
      card.fail("there is an instance '" + name + "' already");
  if (!card.lines.empty()) {
    const DataLine& line = card.lines[0];
    const auto fields = line.fields();
    for (std::size_t i = 0; i < 3; ++i)
      scope_->shift[i] = card.number(line, fields, i, "a translation", 0.0);
  }
  if (card.lines.size() > 1) {
    const DataLine& line = card.lines[1];
    const auto fields = line.fields();
    double n[7];
    for (std::size_t i = 0; i < 7; ++i)
      n[i] = card.number(line, fields, i, "two points of an axis and an angle in degrees");
    if (n[0] == n[3] && n[1] == n[4] && n[2] == n[5])
      card.fail(line.place, "expected two points of the axis that differ");
    place(*scope_, scope_->shift, n, n + 3, n[6]);
  }
  if (!part)
    return; // its mesh stands below it
  const auto found = parts_.find(key_of(*part));
  if (found == parts_.end()) {
    std::vector<std::string> names;
    for (const auto& entry : parts_)
      names.push_back(entry.first);
    card.fail("there is no part '" + *part + "'; " +
              nearest_word_hint(key_of(*part), names.data(), names.size()));
  }
  placed_[found->first] = true;
  for (const std::size_t c : found->second)
    items.push_back({&cards_[c], scope_, -1});
}

} // namespace abut::abaqus
