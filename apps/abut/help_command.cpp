// SPDX-License-Identifier: BSD-3-Clause
#include "help_command.hpp"

#include "abut/core/error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace abut::app {

namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.push_back(command->get_name());
  return names;
}

void require_command(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> names = commands_of(app);
  if (std::find(names.begin(), names.end(), word) == names.end())
    throw InputError("there is no command '" + word + "'; " +
                     nearest_word_hint(word, names.data(), names.size()));
}

} // namespace

void add_help_command(CLI::App& app) {
  app.set_version_flag("--version", "abut " ABUT_VERSION);
  const auto word = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("help", "Explain the program, or one of its commands");
  command->add_option("COMMAND", *word, "run, check, ...");
  command->callback([&app, word] {
    if (!word->empty())
      require_command(app, *word);
    if (word->empty()) // app.help() would explain the command that was parsed, which is this one
      std::cout << app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
    else
      std::cout << app.get_subcommand(*word)->help(app.get_name());
  });
}

void require_known_words(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-')
    return;
  require_command(app, argv[1]);
  const CLI::App* command = app.get_subcommand(argv[1]);
  if (command->get_allow_extras())
    return;
  std::vector<std::string> options;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames())
      options.push_back("--" + name);
  for (int i = 2; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word == "--")
      return;
    if (word.compare(0, 2, "--") == 0 &&
        std::find(options.begin(), options.end(), word) == options.end())
      throw InputError("'abut " + command->get_name() + "' has no option '" + word + "'; " +
                       nearest_word_hint(word, options.data(), options.size()));
  }
}

} // namespace abut::app
