// SPDX-License-Identifier: BSD-3-Clause
#include "import_command.hpp"

#include "protect.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"
#include "abut/febio/import.hpp"
#include "abut/io/exodus.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

namespace abut::app {

namespace {

struct Arguments {
  std::string file, output_dir = ".";
};

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad() || !in.is_open() || std::filesystem::is_directory(path))
    throw InputError("cannot read the file '" + path + "'");
  return text;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush())
    throw InputError("cannot write the file '" + path.string() + "'");
}

void create_folder(const std::string& dir) {
  std::error_code error;
  std::filesystem::create_directories(dir, error);
  if (!std::filesystem::is_directory(dir))
    throw InputError("cannot write to the output folder '" + dir + "': " + error.message());
}

/// Prints the report of a file that cannot be imported, so that all of it can be mended at once.
void require_all_supported(const febio::Report& report, const std::string& file) {
  if (report.count(febio::Fate::refused) > 0)
    std::cout << report.text(file);
  report.require_nothing_refused(file);
}

void import_file(const Arguments& arguments) {
  const std::filesystem::path file(arguments.file), dir(arguments.output_dir);
  const std::string name = file.stem().string();
  febio::Report report;
  const febio::Model model = febio::read_model(read_text(arguments.file), arguments.file, report);
  require_all_supported(report, arguments.file);
  const febio::Scene scene = febio::translate(model, name, std::move(report));
  require_all_supported(scene.report, arguments.file);
  const std::string deck = (dir / (name + ".yaml")).string();
  try {
    deck::parse_deck(scene.deck, deck);
  } catch (const InputError& e) {
    throw Defect(std::string("the imported deck is not valid: ") + e.what());
  }
  create_folder(arguments.output_dir);
  const std::string mesh = (dir / (name + ".exo")).string();
  protect_from_mesh(mesh);
  protect_from_import(deck);
  io::write_mesh(mesh, scene.mesh);
  write_text(deck, scene.deck);
  write_text(dir / (name + ".import.txt"), scene.report.text(arguments.file));
  std::cout << deck << ": " << scene.mesh.num_nodes() << " nodes, " << scene.mesh.num_elements()
            << " elements; " << scene.report.count(febio::Fate::used) << " constructs used, "
            << scene.report.count(febio::Fate::ignored) << " ignored because harmless, see " << name
            << ".import.txt\n";
}

} // namespace

void add_import_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("import", "Turn a FEBio model into an Exodus mesh and a deck");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("FILE", arguments->file, "FEBio model, specification 4.0")->required();
  command->add_option("--output-dir", arguments->output_dir,
                      "folder for NAME.exo, NAME.yaml and NAME.import.txt");
  command->callback([arguments] { import_file(*arguments); });
}

} // namespace abut::app
