// SPDX-License-Identifier: BSD-3-Clause
#include "import_command.hpp"

#include "protect.hpp"

#include "abut/abaqus/import.hpp"
#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"
#include "abut/febio/import.hpp"
#include "abut/gmsh/import.hpp"
#include "abut/io/exodus.hpp"
#include "abut/io/file_kind.hpp"

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
void require_all_supported(const translation::Report& report, const std::string& file) {
  if (report.count(translation::Fate::refused) > 0)
    std::cout << report.text(file);
  report.require_nothing_refused(file);
}

struct Import {
  mesh::MeshData mesh;
  std::string deck;
  translation::Report report;
  bool is_start = false; ///< the deck is one to start from, which its user fills in
};

template <class Scene> Import checked(Scene scene, const std::string& file) {
  require_all_supported(scene.report, file);
  return {std::move(scene.mesh), std::move(scene.deck), std::move(scene.report)};
}

/// Abaqus and CalculiX decks by their name, or by the star that begins their first keyword.
bool is_inp(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return std::filesystem::path(file).extension() == ".inp" ||
         (first != std::string::npos && text[first] == '*');
}

/// Of an included file; devices and the like are none.
std::string read_included(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError("cannot read the file '" + path + "'");
  return read_text(path);
}

/// By what the file holds.
Import translate(const std::string& file, const std::string& name) {
  const std::string text = read_text(file);
  translation::Report report;
  if (gmsh::is_msh(text)) {
    const gmsh::Model model = gmsh::read_model(text, file, report);
    Import made = checked(gmsh::translate(model, name, std::move(report)), file);
    made.is_start = true;
    return made;
  }
  if (is_inp(text, file)) {
    const abaqus::Model model = abaqus::read_model(text, file, read_included, report);
    require_all_supported(report, file);
    return checked(abaqus::translate(model, name, std::move(report)), file);
  }
  if (std::filesystem::path(file).extension() == ".msh")
    throw InputError(file + ":1: expected a Gmsh file, which begins with $MeshFormat");
  const febio::Model model = febio::read_model(text, file, report);
  require_all_supported(report, file);
  return checked(febio::translate(model, name, std::move(report)), file);
}

void import_file(const Arguments& arguments) {
  const std::filesystem::path dir(arguments.output_dir);
  const std::string name = std::filesystem::path(arguments.file).stem().string();
  const Import made = translate(arguments.file, name);
  const std::string deck = (dir / (name + ".yaml")).string();
  try {
    deck::parse_deck(made.deck, deck);
  } catch (const InputError& e) {
    throw Defect(std::string("the imported deck is not valid: ") + e.what());
  }
  create_folder(arguments.output_dir);
  const std::string mesh = (dir / (name + ".exo")).string();
  protect_from_mesh(mesh);
  const bool keep_deck = made.is_start && io::kind_of_file(deck) != io::FileKind::none;
  if (!keep_deck)
    protect_from_import(deck);
  io::write_mesh(mesh, made.mesh);
  if (!keep_deck)
    write_text(deck, made.deck);
  write_text(dir / (name + ".import.txt"), made.report.text(arguments.file));
  std::cout << (keep_deck ? mesh : deck) << ": " << made.mesh.num_nodes() << " nodes, "
            << made.mesh.num_elements() << " elements; "
            << made.report.count(translation::Fate::used) << " constructs used, "
            << made.report.count(translation::Fate::ignored) << " ignored because harmless, see "
            << name << ".import.txt" << (keep_deck ? "; the deck " + deck + " stays as it is" : "")
            << "\n";
}

} // namespace

void add_import_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "import",
      "Turn an Abaqus, CalculiX or FEBio model, or a Gmsh mesh, into an Exodus mesh and a deck");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option(
          "FILE", arguments->file,
          "Abaqus or CalculiX model, .inp; FEBio model, specification 4.0; Gmsh mesh, MSH 2.2 or "
          "4.1")
      ->required();
  command->add_option("--output-dir", arguments->output_dir,
                      "folder for NAME.exo, NAME.yaml and NAME.import.txt");
  command->callback([arguments] { import_file(*arguments); });
}

} // namespace abut::app
