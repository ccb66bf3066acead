// SPDX-License-Identifier: BSD-3-Clause
#include "model.hpp"

#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/mesh/duplicates.hpp"
#include "abut/mesh/fingerprint.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/scene/names.hpp"
#include "abut/scene/surfaces.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

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

/// How far a point of an element may lie from its nearest node, over the largest distance from that
/// node to another one of its elements (the centre of a regular tetrahedron: 0.61).
constexpr double inside = 2.0 / 3.0;

/// A displacement is asked for at a point of the mesh, not at one from which the nearest node is
/// far. Collective.
void check_point(const std::string& path, const std::array<double, 3>& point,
                 const mesh::Mesh& mesh, const Where& where) {
  const auto distance = [&](const double* x, const double* y) {
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
  };
  const auto node = [&](Local n) { return &mesh.x[3 * std::size_t(n)]; };
  double least = std::numeric_limits<double>::infinity();
  for (Local n = 0; n < mesh.num_local(); ++n)
    least = std::min(least, distance(node(n), point.data()));
  least = mesh.comm.min(least);
  double size = 0.0;
  Global id = 0;
  for (const mesh::Block& block : mesh.blocks) {
    const auto width = static_cast<std::size_t>(fem::info(block.type).nodes);
    for (std::size_t first = 0; first < block.nodes.size(); first += width)
      for (std::size_t a = first; a < first + width; ++a) {
        if (distance(node(block.nodes[a]), point.data()) > least)
          continue;
        id = mesh.node_id[std::size_t(block.nodes[a])];
        for (std::size_t b = first; b < first + width; ++b)
          size = std::max(size, distance(node(block.nodes[a]), node(block.nodes[b])));
      }
  }
  size = mesh.comm.max(size);
  if (least > inside * size)
    throw InputError(fmt::format("{}: the point ({:g}, {:g}, {:g}) is not in the mesh: its nearest "
                                 "node, {}, is {:g} away",
                                 where(path), point[0], point[1], point[2], mesh.comm.max(id),
                                 least));
}

/// What `verify` asks about must be there. Collective.
void check_places(const deck::Deck& deck, const mesh::Mesh& mesh, const Where& where) {
  const std::vector<std::string> sets = scene::set_names(mesh);
  for (const auto& v : deck.verify)
    if (v.point) {
      check_point("verify." + v.name + ".point", *v.point, mesh, where);
    } else if (!deck::is_contact_quantity(v.quantity) && !deck::is_rigid_quantity(v.quantity) &&
               !deck::is_joint_quantity(v.quantity) && !v.place.empty()) {
      const std::string path = "verify." + v.name + ".place";
      scene::require_name(where, path, "node set or side set", v.place, sets);
      scene::require_nodes(where, path, v.place, mesh);
    }
}

} // namespace

std::unique_ptr<Model> build_model(const Comm& comm, const std::string& deck_file,
                                   const std::function<void(const mesh::MeshData&)>& look) {
  deck::Deck deck = deck::read_deck(comm, deck_file);
  const Where where = [&deck](const std::string& path) { return deck.where(path); };
  mesh::MeshData data;
  std::vector<std::string> duplicates; // on the root, which prints
  std::uint64_t fingerprint = 0;
  comm.on_root([&] {
    data = load_mesh(deck);
    duplicates = mesh::drop_duplicates(data);
    fingerprint = mesh::fingerprint(data);
    scene::add_surfaces(deck, data, where);
    if (look)
      look(data);
  });
  const auto mesh = std::make_shared<const mesh::Mesh>(mesh::distribute(data, comm));
  data = {};
  scene::name_blocks(deck, *mesh);
  auto timers = std::make_unique<PhaseTimers>();
  scene::Scene scene = scene::build_scene(deck, mesh, *timers, where);
  for (const std::string& text : duplicates)
    scene.warnings.push_back(deck.where("mesh") + ": " + text);
  check_places(deck, *mesh, where);
  return std::unique_ptr<Model>(
      new Model{std::move(scene), comm, std::move(deck), std::move(timers), fingerprint});
}

} // namespace abut::app
