// SPDX-License-Identifier: BSD-3-Clause
#include "choices.hpp"

#include "abut/contact/resolve.hpp"

#include <sstream>

namespace abut::app {

std::vector<std::string> choices_of(const Model& m, const contact::Settings& settings) {
  std::vector<std::string> choices;
  for (const contact::ContactOptions& options : m.deck.contact) {
    if (options.name != settings.name)
      continue;
    std::istringstream lines(contact::explain(options, settings));
    for (std::string line; std::getline(lines, line);)
      choices.push_back(line);
  }
  return choices;
}

} // namespace abut::app
