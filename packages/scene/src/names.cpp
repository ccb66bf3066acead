// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/names.hpp"

#include <algorithm>

namespace abut::scene {

namespace {

template <class Map> std::vector<std::string> names(const Map& map) {
  std::vector<std::string> result;
  for (const auto& entry : map)
    result.push_back(entry.first);
  return result;
}

} // namespace

std::vector<Local> nodes_of_set(const mesh::Mesh& mesh, const std::string& name) {
  const auto set = mesh.node_sets.find(name);
  if (set != mesh.node_sets.end())
    return set->second;
  std::vector<char> in_set(mesh.node.size(), 0);
  for (const mesh::Side& s : mesh.side_sets.at(name)) {
    const mesh::Block& block = mesh.blocks[std::size_t(s.block)];
    const fem::CellSide& face = fem::side(block.type, s.side);
    for (int a = 0; a < fem::face_nodes(face.type); ++a)
      in_set[std::size_t(block.nodes[std::size_t(s.element) * fem::info(block.type).nodes +
                                     std::size_t(face.nodes[a])])] = 1;
  }
  // A rank may own a node at the edge of the set without a face of it.
  const NodeExchange ghosts = mesh::node_exchange(mesh);
  ghosts.max_to_owners(in_set.data());
  ghosts.to_ghosts(in_set.data());
  std::vector<Local> nodes;
  for (Local n = 0; n < mesh.num_local(); ++n)
    if (in_set[std::size_t(n)])
      nodes.push_back(n);
  return nodes;
}

std::vector<std::string> set_names(const mesh::Mesh& mesh) {
  std::vector<std::string> sets = names(mesh.node_sets);
  for (std::string& name : names(mesh.side_sets))
    sets.push_back(std::move(name));
  std::sort(sets.begin(), sets.end()); // a name may stand for both
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

void require_name(const Where& where, const std::string& path, const std::string& what,
                  const std::string& name, const std::vector<std::string>& valid) {
  if (std::find(valid.begin(), valid.end(), name) != valid.end())
    return;
  throw InputError(where(path) + ": the mesh has no " + what + " '" + name + "'; " +
                   nearest_word_hint(name, valid.data(), valid.size()));
}

void name_blocks(Options& options, const mesh::Mesh& mesh) {
  const auto name = [&](std::string& word) {
    if (const int b = block_called(mesh.blocks, word); b >= 0)
      word = mesh.blocks[std::size_t(b)].name;
  };
  for (BodyOptions& body : options.bodies)
    for (std::string& block : body.blocks)
      name(block);
  for (solid::LoadOptions& load : options.loads)
    if (load.kind == solid::LoadKind::body_force)
      name(load.place);
}

void require_nodes(const Where& where, const std::string& path, const std::string& set,
                   const mesh::Mesh& mesh) {
  const std::vector<Local> nodes = nodes_of_set(mesh, set);
  const auto owned =
      std::count_if(nodes.begin(), nodes.end(), [&](Local n) { return n < mesh.num_owned; });
  if (mesh.comm.sum(Global(owned)) == 0)
    throw InputError(where(path) + ": '" + set + "' of the mesh is empty");
}

void check_not_empty(const Options& options, const mesh::Mesh& mesh, const Where& where) {
  for (const auto& b : options.bodies)
    for (const std::string& set : b.node_sets)
      require_nodes(where, "bodies." + b.name + ".node_sets", set, mesh);
  for (const auto& d : options.displacements)
    require_nodes(where, "displacements." + d.name + ".set", d.set, mesh);
  for (const auto& l : options.loads) {
    const std::string path = "loads." + l.name;
    if (l.kind == solid::LoadKind::force) {
      require_nodes(where, path + ".node_set", l.place, mesh);
      continue;
    }
    const bool in_block = l.kind == solid::LoadKind::body_force;
    Global members = 0;
    for (const mesh::Block& b : mesh.blocks)
      members += in_block && b.name == l.place ? b.size() : 0;
    if (!in_block)
      members = Global(mesh.side_sets.at(l.place).size());
    if (mesh.comm.sum(members) == 0)
      throw InputError(where(path + (in_block ? ".block" : ".side_set")) + ": '" + l.place +
                       "' of the mesh is empty");
  }
}

void check_names(const Options& options, const mesh::Mesh& mesh, const Where& where) {
  std::vector<std::string> blocks;
  for (const mesh::Block& b : mesh.blocks)
    blocks.push_back(b.name);
  const auto node_sets = names(mesh.node_sets), side_sets = names(mesh.side_sets),
             sets = set_names(mesh);
  for (const auto& b : options.bodies)
    for (const std::string& block : b.blocks)
      require_name(where, "bodies." + b.name + ".blocks", "block", block, blocks);
  for (const auto& b : options.bodies)
    for (const std::string& set : b.node_sets)
      require_name(where, "bodies." + b.name + ".node_sets", "node set", set, node_sets);
  for (const auto& d : options.displacements)
    require_name(where, "displacements." + d.name + ".set", "node set or side set", d.set, sets);
  for (const auto& l : options.loads) {
    const std::string path = "loads." + l.name;
    if (l.kind == solid::LoadKind::body_force)
      require_name(where, path + ".block", "block", l.place, blocks);
    else if (l.kind == solid::LoadKind::force)
      require_name(where, path + ".node_set", "node set", l.place, node_sets);
    else
      require_name(where, path + ".side_set", "side set", l.place, side_sets);
  }
  for (const auto& c : options.contact) {
    require_name(where, "contact." + c.name + ".primary", "side set", c.primary, side_sets);
    require_name(where, "contact." + c.name + ".secondary", "side set", c.secondary, side_sets);
  }
}

} // namespace abut::scene
