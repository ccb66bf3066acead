// SPDX-License-Identifier: BSD-3-Clause
#include "model.hpp"

#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/scene/names.hpp"

namespace abut::app {

namespace {

mesh::MeshData load_mesh(const deck::Deck& deck) {
  if (!deck.mesh.file.empty()) {
    try {
      return io::read_exodus(deck.mesh_path());
    } catch (const InputError& e) {
      throw InputError(deck.where("mesh.file") + ": " + e.what());
    }
  }
  try {
    return meshgen::generate(deck.mesh.kind, deck.mesh.generator_options());
  } catch (const InputError& e) {
    throw InputError(deck.where("mesh.generate") + ": " + e.what());
  }
}

/// What `verify` asks about must be there.
void check_places(const deck::Deck& deck, const mesh::Mesh& mesh, const Where& where) {
  const std::vector<std::string> sets = scene::set_names(mesh);
  for (const auto& v : deck.verify)
    if (!deck::is_contact_quantity(v.quantity) && !deck::is_rigid_quantity(v.quantity) &&
        !deck::is_joint_quantity(v.quantity) && !v.place.empty())
      scene::require_name(where, "verify." + v.name + ".place", "node set or side set", v.place,
                          sets);
}

} // namespace

std::unique_ptr<Model> build_model(const Comm& comm, const std::string& deck_file) {
  deck::Deck deck = deck::read_deck(comm, deck_file);
  mesh::MeshData data;
  comm.on_root([&] { data = load_mesh(deck); });
  const auto mesh = std::make_shared<const mesh::Mesh>(mesh::distribute(data, comm));
  data = {};
  const Where where = [&deck](const std::string& path) { return deck.where(path); };
  auto timers = std::make_unique<PhaseTimers>();
  scene::Scene scene = scene::build_scene(deck, mesh, *timers, where);
  check_places(deck, *mesh, where);
  return std::unique_ptr<Model>(
      new Model{std::move(scene), comm, std::move(deck), std::move(timers)});
}

} // namespace abut::app
