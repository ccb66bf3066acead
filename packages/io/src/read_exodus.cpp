// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "exodus_file.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

namespace abut::io {

namespace {

std::string name_of(const ExodusFile& file, ex_entity_type type, std::int64_t id,
                    const char* fallback) {
  std::vector<char> name(257, '\0');
  // The longest that there may be: not all programs note the longest that there is.
  const int length = static_cast<int>(ex_inquire_int(file.id(), EX_INQ_DB_MAX_ALLOWED_NAME_LENGTH));
  ex_set_max_name_length(file.id(), std::min(std::max(length, 32), 255));
  if (ex_get_name(file.id(), type, id, name.data()) < 0 || name[0] == '\0')
    return fallback + std::to_string(id);
  return name.data();
}

std::vector<std::int64_t> ids_of(const ExodusFile& file, ex_entity_type type, std::int64_t count) {
  std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
  if (count > 0)
    file.check(ex_get_ids(file.id(), type, ids.data()), "read ids");
  return ids;
}

/// NetCDF reads what lies behind the end of a truncated file as zeros.
const char* zero_hint(std::int64_t value) {
  return value == 0 ? " (the file may be truncated)" : "";
}

bool is_identity(const std::vector<std::int64_t>& map) {
  for (std::size_t i = 0; i < map.size(); ++i)
    if (map[i] != static_cast<std::int64_t>(i) + 1)
      return false;
  return true;
}

std::vector<std::int64_t> number_map(const ExodusFile& file, ex_entity_type type,
                                     std::int64_t count) {
  std::vector<std::int64_t> map(static_cast<std::size_t>(count));
  if (count > 0)
    file.check(ex_get_id_map(file.id(), type, map.data()), "read the number map");
  for (std::int64_t id : map)
    if (id < 1)
      file.fail("expected positive numbers in the number map, got " + std::to_string(id) +
                zero_hint(id));
  return map;
}

void read_coordinates(const ExodusFile& file, std::int64_t nodes, mesh::MeshData& mesh) {
  std::vector<double> x(nodes), y(nodes), z(nodes);
  if (nodes > 0)
    file.check(ex_get_coord(file.id(), x.data(), y.data(), z.data()), "read the coordinates");
  mesh.x.resize(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mesh.x[3 * i] = x[i];
    mesh.x[3 * i + 1] = y[i];
    mesh.x[3 * i + 2] = z[i];
  }
}

/// Reads the nodes of the block's elements; `first` is the number of elements before the block.
void read_connectivity(const ExodusFile& file, std::int64_t count, std::int64_t nodes,
                       const std::vector<std::int64_t>& element_map, std::int64_t first,
                       mesh::BlockData& block) {
  const int width = fem::info(block.type).nodes;
  std::vector<std::int64_t> connectivity(static_cast<std::size_t>(count) * width);
  file.check(ex_get_conn(file.id(), EX_ELEM_BLOCK, block.id, connectivity.data(), nullptr, nullptr),
             "read the elements");
  block.nodes.reserve(connectivity.size());
  for (std::int64_t e = 0; e < count; ++e) {
    std::set<std::int64_t> seen;
    for (int i = 0; i < width; ++i) {
      const std::int64_t n = connectivity[e * width + i];
      const std::string element =
          "element " + std::to_string(element_map[first + e]) + " of block '" + block.name + "'";
      if (n < 1 || n > nodes)
        file.fail(element + " has node " + std::to_string(n) + ", but nodes go from 1 to " +
                  std::to_string(nodes) + zero_hint(n));
      if (!seen.insert(n).second)
        file.fail(element + " has node " + std::to_string(n) + " twice");
      block.nodes.push_back(n - 1);
    }
  }
}

void read_blocks(const ExodusFile& file, const ex_init_params& sizes, mesh::MeshData& mesh) {
  const auto element_map = number_map(file, EX_ELEM_MAP, sizes.num_elem);
  const bool plain = is_identity(element_map);
  std::set<std::string> names;
  std::int64_t first = 0;
  for (std::int64_t id : ids_of(file, EX_ELEM_BLOCK, sizes.num_elem_blk)) {
    mesh::BlockData block;
    block.id = static_cast<int>(id);
    block.name = name_of(file, EX_ELEM_BLOCK, id, "block_");
    char type[MAX_STR_LENGTH + 1] = "";
    std::int64_t count = 0, width = 0, edges = 0, faces = 0, attributes = 0;
    file.check(ex_get_block(file.id(), EX_ELEM_BLOCK, id, type, &count, &width, &edges, &faces,
                            &attributes),
               "read a block");
    if (!names.insert(block.name).second)
      file.fail("two blocks are called '" + block.name + "'");
    const bool known = fem::cell_type_from_exodus(type, static_cast<int>(width), block.type);
    if (count > 0 && !known)
      file.fail("block '" + block.name + "' (id " + std::to_string(id) + ") has elements of type " +
                type + " with " + std::to_string(width) +
                " nodes; valid: HEX8, HEX20, HEX27, TETRA4, TETRA10, WEDGE6");
    if (first + count > sizes.num_elem)
      file.fail("its blocks have more elements than the file");
    if (count > 0)
      read_connectivity(file, count, sizes.num_nodes, element_map, first, block);
    if (!plain)
      block.element_id.assign(element_map.begin() + first, element_map.begin() + first + count);
    first += count;
    mesh.blocks.push_back(std::move(block));
  }
  if (first != sizes.num_elem)
    file.fail("its blocks have fewer elements than the file");
}

void read_node_sets(const ExodusFile& file, const ex_init_params& sizes, mesh::MeshData& mesh) {
  for (std::int64_t id : ids_of(file, EX_NODE_SET, sizes.num_node_sets)) {
    const std::string name = name_of(file, EX_NODE_SET, id, "nodeset_");
    std::int64_t count = 0, factors = 0;
    file.check(ex_get_set_param(file.id(), EX_NODE_SET, id, &count, &factors), "read a node set");
    std::vector<std::int64_t> nodes(static_cast<std::size_t>(count));
    if (count > 0)
      file.check(ex_get_set(file.id(), EX_NODE_SET, id, nodes.data(), nullptr), "read a node set");
    const auto [set, is_new] = mesh.node_sets.emplace(name, std::vector<Global>());
    if (!is_new)
      file.fail("two node sets are called '" + name + "'");
    for (std::int64_t n : nodes) {
      if (n < 1 || n > sizes.num_nodes)
        file.fail("node set '" + name + "' has node " + std::to_string(n) +
                  ", but nodes go from 1 to " + std::to_string(sizes.num_nodes) + zero_hint(n));
      set->second.push_back(n - 1);
    }
  }
}

void read_side_sets(const ExodusFile& file, const ex_init_params& sizes, mesh::MeshData& mesh) {
  std::vector<std::int64_t> first{0};
  for (const mesh::BlockData& b : mesh.blocks)
    first.push_back(first.back() +
                    static_cast<std::int64_t>(b.nodes.size()) / fem::info(b.type).nodes);
  for (std::int64_t id : ids_of(file, EX_SIDE_SET, sizes.num_side_sets)) {
    const std::string name = name_of(file, EX_SIDE_SET, id, "sideset_");
    std::int64_t count = 0, factors = 0;
    file.check(ex_get_set_param(file.id(), EX_SIDE_SET, id, &count, &factors), "read a side set");
    std::vector<std::int64_t> elements(static_cast<std::size_t>(count)), sides(elements);
    if (count > 0)
      file.check(ex_get_set(file.id(), EX_SIDE_SET, id, elements.data(), sides.data()),
                 "read a side set");
    const auto [set, is_new] = mesh.side_sets.emplace(name, std::vector<mesh::SideData>());
    if (!is_new)
      file.fail("two side sets are called '" + name + "'");
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::int64_t e = elements[i] - 1;
      const std::string where = "side set '" + name + "' has ";
      if (e < 0 || e >= sizes.num_elem)
        file.fail(where + "element " + std::to_string(e + 1) + ", but elements go from 1 to " +
                  std::to_string(sizes.num_elem) + zero_hint(e + 1));
      const auto block =
          static_cast<int>(std::upper_bound(first.begin(), first.end(), e) - first.begin()) - 1;
      const fem::CellInfo& cell = fem::info(mesh.blocks[block].type);
      if (sides[i] < 1 || sides[i] > cell.sides)
        file.fail(where + "side " + std::to_string(sides[i]) + " of element " +
                  std::to_string(e + 1) + ", but " + cell.name + " has sides 1 to " +
                  std::to_string(cell.sides) + zero_hint(sides[i]));
      set->second.push_back({block, e - first[block], static_cast<int>(sides[i]) - 1});
    }
  }
}

} // namespace

mesh::MeshData read_exodus(const std::string& path) {
  const ExodusFile file = ExodusFile::open(path);
  ex_init_params sizes = {};
  file.check(ex_get_init_ext(file.id(), &sizes), "read its sizes");
  if (sizes.num_dim != 3)
    file.fail("expected a mesh in 3 dimensions, got " + std::to_string(sizes.num_dim));
  mesh::MeshData mesh;
  mesh.title = sizes.title;
  read_coordinates(file, sizes.num_nodes, mesh);
  const auto node_map = number_map(file, EX_NODE_MAP, sizes.num_nodes);
  if (!is_identity(node_map))
    mesh.node_id.assign(node_map.begin(), node_map.end());
  read_blocks(file, sizes, mesh);
  read_node_sets(file, sizes, mesh);
  read_side_sets(file, sizes, mesh);
  return mesh;
}

} // namespace abut::io
