// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_command.hpp"

#include "protect.hpp"

#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/mesh/info.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/meshgen/generate.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace abut::app {

namespace {

struct Arguments {
  std::string kind, output, info;
};

/// --key value and --key=value, in any number.
std::map<std::string, std::string> read_options(const std::vector<std::string>& words) {
  std::map<std::string, std::string> options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].compare(0, 2, "--") != 0 || words[i].size() == 2)
      throw InputError("abut mesh: expected --KEY VALUE, got '" + words[i] + "'");
    std::string key = words[i].substr(2), value;
    const std::size_t equals = key.find('=');
    if (equals != std::string::npos) {
      value = key.substr(equals + 1);
      key.resize(equals);
    } else {
      if (++i == words.size())
        throw InputError("abut mesh: --" + key + " needs a value");
      value = words[i];
    }
    if (!options.emplace(key, value).second)
      throw InputError("abut mesh: --" + key + " is given twice");
  }
  return options;
}

std::string describe_kinds() {
  std::string text;
  for (const std::string& kind : meshgen::generator_kinds()) {
    text += "\n" + kind + "\n";
    for (const meshgen::GeneratorKey& key : meshgen::generator_keys(kind))
      text += "  --" + key.name +
              std::string(key.name.size() < 20 ? 20 - key.name.size() : 1, ' ') + key.help +
              (key.value.empty() ? "" : " [" + key.value + "]") + "\n";
  }
  return text;
}

void write(const Arguments& arguments, const std::vector<std::string>& words) {
  if (arguments.kind.empty() || arguments.output.empty())
    throw InputError("abut mesh: expected KIND and -o FILE to write a mesh, or --info FILE to "
                     "describe one; 'abut help mesh' lists the kinds");
  const mesh::MeshData data = meshgen::generate(arguments.kind, read_options(words));
  protect_from_mesh(arguments.output);
  io::write_mesh(arguments.output, data);
  std::printf("%s: %lld nodes, %lld elements, smallest scaled Jacobian %.3f\n",
              arguments.output.c_str(), data.num_nodes(), data.num_elements(),
              mesh::min_scaled_jacobian(data));
}

void describe(const Arguments& arguments, const std::vector<std::string>& words) {
  if (!arguments.kind.empty() || !arguments.output.empty() || !words.empty())
    throw InputError("abut mesh: --info FILE goes with nothing else");
  const std::string text = mesh::text(mesh::info(io::read_exodus(arguments.info)));
  std::fputs(text.c_str(), stdout);
}

} // namespace

void add_mesh_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("mesh", "Write a simple mesh as an Exodus file, or describe one");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("KIND", arguments->kind, "box, blocks, quarter_cylinder, ...");
  command->add_option("-o,--output", arguments->output, "file to write, e.g. box.exo");
  command->add_option("--info", arguments->info, "Exodus file to describe");
  command->allow_extras();
  command->footer([] { return describe_kinds(); });
  command->callback([command, arguments] {
    (arguments->info.empty() ? write : describe)(*arguments, command->remaining());
  });
}

} // namespace abut::app
