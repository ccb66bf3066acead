// SPDX-License-Identifier: BSD-3-Clause
#include "schema_command.hpp"

#include "abut/deck/schema.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace abut::app {

void add_schema_command(CLI::App& app) {
  struct Choice {
    bool markdown = false, json = false;
  };
  const auto choice = std::make_shared<Choice>();
  CLI::App* command = app.add_subcommand("schema", "Print every key that a deck may use");
  CLI::Option* markdown = command->add_flag("--markdown", choice->markdown,
                                            "as Markdown (docs/user/deck-reference.md)");
  command->add_flag("--json", choice->json, "as JSON Schema, for editors")->excludes(markdown);
  command->callback([choice] {
    if (choice->markdown)
      std::cout << deck::schema_markdown();
    else if (choice->json)
      std::cout << deck::schema_json();
    else
      std::cout << deck::schema_text();
  });
}

} // namespace abut::app
