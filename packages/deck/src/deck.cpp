// SPDX-License-Identifier: BSD-3-Clause
#include "abut/deck/deck.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/parse.hpp"
#include "check.hpp"
#include "describe.hpp"
#include "filler.hpp"
#include "utf8.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace abut::deck {

std::map<std::string, std::string> MeshOptions::generator_options() const {
  std::map<std::string, std::string> options;
  for (const Parameter& parameter : parameters)
    options[parameter.key] = parameter.text;
  return options;
}

bool is_contact_quantity(Quantity quantity) {
  switch (quantity) {
  case Quantity::force_x:
  case Quantity::force_y:
  case Quantity::force_z:
  case Quantity::max_pressure:
  case Quantity::max_penetration:
  case Quantity::active_points:
  case Quantity::stick_points:
  case Quantity::slip_points:
  case Quantity::max_slip:
  case Quantity::friction_dissipation:
  case Quantity::contact_radius:
    return true;
  default:
    return false;
  }
}

bool is_rigid_quantity(Quantity quantity) {
  return quantity >= Quantity::rigid_displacement_x && quantity <= Quantity::rigid_moment_z;
}

bool is_joint_quantity(Quantity quantity) {
  return quantity >= Quantity::joint_force_x && quantity <= Quantity::joint_rotation;
}

double VerifyOptions::allowed_error() const {
  return std::max(tolerance.value_or(0.0), relative_tolerance.value_or(0.0) * std::abs(expected));
}

std::string Deck::where(const std::string& path) const {
  std::string known = path;
  auto found = locations.find(known);
  while (found == locations.end() && !known.empty()) {
    const std::size_t dot = known.rfind('.');
    known.resize(dot == std::string::npos ? 0 : dot);
    found = locations.find(known);
  }
  return (found == locations.end() ? file : found->second.text()) + ": " + path;
}

std::string Deck::mesh_path() const {
  return (std::filesystem::path(file).parent_path() / mesh.file).string();
}

Deck make_deck(const Value& top, const std::string& file) {
  Deck deck;
  deck.file = file;
  Filler filler(top, {file, 1, 1}, "", deck.locations);
  describe(filler, deck);
  filler.finish();
  check_references(deck);
  return deck;
}

Deck parse_deck(const std::string& text, const std::string& file) {
  require_utf8(text, file);
  return make_deck(parse(text, file), file);
}

Deck read_deck(const Comm& comm, const std::string& file) {
  std::string text;
  comm.on_root([&] {
    if (std::filesystem::is_directory(file))
      throw InputError(file + ": expected a deck (.yaml or .xml), got a folder");
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
      throw InputError(file + ": the deck cannot be opened");
    text.assign(std::istreambuf_iterator<char>(stream), {});
    if (stream.bad())
      throw InputError(file + ": the deck cannot be read");
  });
  comm.broadcast(text);
  return parse_deck(text, file);
}

} // namespace abut::deck
