// SPDX-License-Identifier: BSD-3-Clause
#include "abut/translation/report.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut::translation {

namespace {

const char* word(Fate fate) {
  return fate == Fate::used ? "used" : fate == Fate::ignored ? "ignored" : "refused";
}

} // namespace

int Report::count(Fate fate) const {
  return static_cast<int>(std::count_if(entries_.begin(), entries_.end(),
                                        [=](const Entry& e) { return e.fate == fate; }));
}

std::string Report::text(const std::string& file) const {
  std::string out = file + ": " + std::to_string(count(Fate::used)) + " constructs used, " +
                    std::to_string(count(Fate::ignored)) + " ignored because harmless, " +
                    std::to_string(count(Fate::refused)) + " refused\n";
  for (const Fate fate : {Fate::refused, Fate::used, Fate::ignored})
    for (const Entry& e : entries_)
      if (e.fate == fate)
        out += std::string(word(fate)) + (bytes_ ? "  byte " : "  line ") + std::to_string(e.line) +
               "  " + e.path + (e.note.empty() ? "" : ": " + e.note) + "\n";
  return out;
}

void Report::require_nothing_refused(const std::string& file) const {
  std::string message;
  for (const Entry& e : entries_)
    if (e.fate == Fate::refused)
      message += (message.empty() ? "" : "\n") + file + (bytes_ ? ": byte " : ":") +
                 std::to_string(e.line) + ": " + e.path + ": " + e.note;
  if (!message.empty())
    throw InputError(message);
}

} // namespace abut::translation
