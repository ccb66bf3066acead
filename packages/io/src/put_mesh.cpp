// SPDX-License-Identifier: BSD-3-Clause
#include "put_mesh.hpp"

#include "abut/io/exodus.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <set>

namespace abut::io {

namespace {

/// Ids for the sets in the order of their names: ID for a name prefix_ID, else the next free one.
template <class Sets>
std::vector<std::int64_t> set_ids(const Sets& sets, const std::string& prefix) {
  std::vector<std::int64_t> ids;
  std::set<std::int64_t> taken;
  for (const auto& entry : sets) {
    const std::string& name = entry.first;
    std::int64_t id = 0;
    const std::string digits =
        name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : "";
    if (!digits.empty() && digits.size() < 10 &&
        digits.find_first_not_of("0123456789") == std::string::npos)
      id = std::stoll(digits);
    ids.push_back(id > 0 && taken.insert(id).second ? id : 0);
  }
  std::int64_t next = 1;
  for (std::int64_t& id : ids)
    if (id == 0) {
      while (!taken.insert(next).second)
        ++next;
      id = next;
    }
  return ids;
}

void put_sizes(const ExodusFile& file, const mesh::MeshData& mesh) {
  ex_init_params sizes = {};
  std::snprintf(sizes.title, sizeof sizes.title, "%s", mesh.title.c_str());
  sizes.num_dim = mesh.dim;
  sizes.num_nodes = mesh.num_nodes();
  sizes.num_elem = mesh.num_elements();
  sizes.num_elem_blk = static_cast<std::int64_t>(mesh.blocks.size());
  sizes.num_node_sets = static_cast<std::int64_t>(mesh.node_sets.size());
  sizes.num_side_sets = static_cast<std::int64_t>(mesh.side_sets.size());
  file.check(ex_put_init_ext(file.id(), &sizes), "write the sizes");
}

void put_coordinates(const ExodusFile& file, const mesh::MeshData& mesh) {
  const std::size_t nodes = static_cast<std::size_t>(mesh.num_nodes());
  std::vector<double> x[3];
  for (int d = 0; d < mesh.dim; ++d)
    for (std::size_t i = 0; i < nodes; ++i)
      x[d].push_back(mesh.x[mesh.dim * i + d]);
  if (nodes > 0)
    file.check(ex_put_coord(file.id(), x[0].data(), x[1].data(), x[2].data()),
               "write the coordinates");
  char axis[3][2] = {"x", "y", "z"};
  char* names[3] = {axis[0], axis[1], axis[2]};
  file.check(ex_put_coord_names(file.id(), names), "write the coordinate names");
}

void put_blocks(const ExodusFile& file, const mesh::MeshData& mesh) {
  for (const mesh::BlockData& b : mesh.blocks) {
    const fem::CellInfo& cell = fem::info(b.type);
    const std::int64_t count = static_cast<std::int64_t>(b.nodes.size()) / cell.nodes;
    file.check(ex_put_block(file.id(), EX_ELEM_BLOCK, b.id, cell.name, count, cell.nodes, 0, 0, 0),
               "write a block");
  }
  for (const mesh::BlockData& b : mesh.blocks) {
    file.check(ex_put_name(file.id(), EX_ELEM_BLOCK, b.id, b.name.c_str()), "write a name");
    if (b.nodes.empty())
      continue;
    std::vector<std::int64_t> nodes(b.nodes.begin(), b.nodes.end());
    for (std::int64_t& n : nodes)
      ++n;
    file.check(ex_put_conn(file.id(), EX_ELEM_BLOCK, b.id, nodes.data(), nullptr, nullptr),
               "write the elements");
  }
}

void put_number_maps(const ExodusFile& file, const mesh::MeshData& mesh) {
  std::vector<std::int64_t> map(mesh.node_id.begin(), mesh.node_id.end());
  if (map.empty()) {
    map.resize(static_cast<std::size_t>(mesh.num_nodes()));
    std::iota(map.begin(), map.end(), 1);
  }
  if (!map.empty())
    file.check(ex_put_id_map(file.id(), EX_NODE_MAP, map.data()), "write the node map");
  map.clear();
  for (const mesh::BlockData& b : mesh.blocks) {
    const std::size_t count = b.nodes.size() / fem::info(b.type).nodes;
    for (std::size_t e = 0; e < count; ++e)
      map.push_back(b.element_id.empty() ? static_cast<std::int64_t>(map.size()) + 1
                                         : b.element_id[e]);
  }
  if (!map.empty())
    file.check(ex_put_id_map(file.id(), EX_ELEM_MAP, map.data()), "write the element map");
}

void put_node_sets(const ExodusFile& file, const mesh::MeshData& mesh) {
  const auto ids = set_ids(mesh.node_sets, "nodeset_");
  auto id = ids.begin();
  for (const auto& [name, set] : mesh.node_sets) {
    std::vector<std::int64_t> nodes(set.begin(), set.end());
    for (std::int64_t& n : nodes)
      ++n;
    const auto count = static_cast<std::int64_t>(nodes.size());
    file.check(ex_put_set_param(file.id(), EX_NODE_SET, *id, count, 0), "write a node set");
    if (count > 0)
      file.check(ex_put_set(file.id(), EX_NODE_SET, *id, nodes.data(), nullptr),
                 "write a node set");
    file.check(ex_put_name(file.id(), EX_NODE_SET, *id, name.c_str()), "write a name");
    ++id;
  }
}

void put_side_sets(const ExodusFile& file, const mesh::MeshData& mesh) {
  std::vector<std::int64_t> first{1};
  for (const mesh::BlockData& b : mesh.blocks)
    first.push_back(first.back() +
                    static_cast<std::int64_t>(b.nodes.size()) / fem::info(b.type).nodes);
  const auto ids = set_ids(mesh.side_sets, "sideset_");
  auto id = ids.begin();
  for (const auto& [name, set] : mesh.side_sets) {
    std::vector<std::int64_t> elements, sides;
    for (const mesh::SideData& s : set) {
      elements.push_back(first[s.block] + s.element);
      sides.push_back(s.side + 1);
    }
    const auto count = static_cast<std::int64_t>(sides.size());
    file.check(ex_put_set_param(file.id(), EX_SIDE_SET, *id, count, 0), "write a side set");
    if (count > 0)
      file.check(ex_put_set(file.id(), EX_SIDE_SET, *id, elements.data(), sides.data()),
                 "write a side set");
    file.check(ex_put_name(file.id(), EX_SIDE_SET, *id, name.c_str()), "write a name");
    ++id;
  }
}

} // namespace

int longest_name(const mesh::MeshData& mesh) {
  std::size_t length = 32;
  for (const auto& b : mesh.blocks)
    length = std::max(length, b.name.size());
  for (const auto& s : mesh.node_sets)
    length = std::max(length, s.first.size());
  for (const auto& s : mesh.side_sets)
    length = std::max(length, s.first.size());
  return static_cast<int>(length);
}

void put_mesh(const ExodusFile& file, const mesh::MeshData& mesh, int name_length) {
  file.check(ex_set_max_name_length(file.id(), name_length), "set the name length");
  put_sizes(file, mesh);
  put_coordinates(file, mesh);
  put_blocks(file, mesh);
  put_number_maps(file, mesh);
  put_node_sets(file, mesh);
  put_side_sets(file, mesh);
}

void write_mesh(const std::string& path, const mesh::MeshData& mesh) {
  const ExodusFile file = ExodusFile::create(path);
  put_mesh(file, mesh, longest_name(mesh));
  file.check(ex_update(file.id()), "write to the disk");
}

} // namespace abut::io
