// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::abaqus {

struct Keyword {
  const char* name;
  const char* why_ignored; ///< it cannot change the answer; null: it is read
  const char* why_refused; ///< abut lacks it; null: it is read
};

/// By its name with or without blanks, in capitals, or the beginning of a single one (four letters
/// or more); nullptr when there is none.
const Keyword* find_keyword(const std::string& name);
/// Message for a name that is none, with the nearest one.
std::string keyword_hint(const std::string& name);

} // namespace abut::abaqus
