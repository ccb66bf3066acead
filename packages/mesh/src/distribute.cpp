// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"
#include "pack.hpp"
#include "partition.hpp"

#include <algorithm>

namespace abut::mesh {

namespace {

std::vector<double> centres(const MeshData& data) {
  std::vector<double> out;
  for (const BlockData& b : data.blocks) {
    const fem::CellInfo& cell = fem::info(b.type);
    for (std::size_t first = 0; first < b.nodes.size(); first += cell.nodes)
      for (int d = 0; d < data.dim; ++d) {
        double sum = 0.0;
        for (int c = 0; c < cell.corners; ++c)
          sum += data.x[data.dim * b.nodes[first + c] + d];
        out.push_back(sum / cell.corners);
      }
  }
  return out;
}

/// What the root decides about the whole mesh before it sends the parts.
struct Plan {
  std::vector<Global> first_element;      ///< (blocks+1) in the input
  std::vector<int> part;                  ///< (elements)
  std::vector<int> owner;                 ///< (nodes)
  std::vector<Global> number;             ///< (nodes) global number
  std::vector<Global> first_node;         ///< (ranks+1)
  std::vector<std::vector<Global>> nodes; ///< (ranks) input indices: owned, then ghosts
  std::vector<Global> local_element;      ///< (elements) index within block and rank
};

Plan make_plan(const MeshData& data, std::vector<int> part, int ranks) {
  Plan plan;
  plan.part = std::move(part);
  const std::size_t num_nodes = static_cast<std::size_t>(data.num_nodes());
  plan.owner.assign(num_nodes, ranks);
  plan.first_element.push_back(0);
  std::vector<std::vector<Global>> touched(static_cast<std::size_t>(ranks));
  for (const BlockData& b : data.blocks) {
    const int width = fem::info(b.type).nodes;
    std::vector<Global> next(static_cast<std::size_t>(ranks), 0);
    Global e = plan.first_element.back();
    for (std::size_t first = 0; first < b.nodes.size(); first += width, ++e) {
      const int p = plan.part[e];
      plan.local_element.push_back(next[p]++);
      for (int i = 0; i < width; ++i) {
        int& owner = plan.owner[b.nodes[first + i]];
        owner = std::min(owner, p);
        touched[p].push_back(b.nodes[first + i]);
      }
    }
    plan.first_element.push_back(e);
  }
  for (int& owner : plan.owner)
    if (owner == ranks)
      owner = 0; // in no element

  plan.nodes.resize(static_cast<std::size_t>(ranks));
  plan.number.resize(num_nodes);
  for (std::size_t n = 0; n < num_nodes; ++n)
    plan.nodes[plan.owner[n]].push_back(static_cast<Global>(n));
  plan.first_node.push_back(0);
  for (int r = 0; r < ranks; ++r) {
    Global number = plan.first_node.back();
    for (Global n : plan.nodes[r])
      plan.number[n] = number++;
    plan.first_node.push_back(number);
  }
  for (int r = 0; r < ranks; ++r) {
    std::sort(touched[r].begin(), touched[r].end());
    touched[r].erase(std::unique(touched[r].begin(), touched[r].end()), touched[r].end());
    for (Global n : touched[r])
      if (plan.owner[n] != r)
        plan.nodes[r].push_back(n);
  }
  return plan;
}

/// Packs one rank's part. local: (nodes) scratch for local indices, -1 everywhere before and after.
std::vector<char> pack_part(const MeshData& data, const Plan& plan, int rank,
                            std::vector<Local>& local) {
  const std::vector<Global>& nodes = plan.nodes[rank];
  Pack out;
  out.add(data.dim);
  out.add(data.num_nodes());
  out.add(data.num_elements());
  out.add(static_cast<Local>(plan.first_node[rank + 1] - plan.first_node[rank]));
  out.add(plan.first_node);
  std::vector<double> x;
  std::vector<Global> number, id;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Global n = nodes[i];
    local[n] = static_cast<Local>(i);
    x.insert(x.end(), data.x.begin() + data.dim * n, data.x.begin() + data.dim * (n + 1));
    number.push_back(plan.number[n]);
    id.push_back(data.node_id.empty() ? n + 1 : data.node_id[n]);
  }
  out.add(x);
  out.add(number);
  out.add(nodes);
  out.add(id);

  out.add(static_cast<int>(data.blocks.size()));
  for (std::size_t b = 0; b < data.blocks.size(); ++b) {
    const BlockData& block = data.blocks[b];
    const int width = fem::info(block.type).nodes;
    std::vector<Local> cells;
    std::vector<Global> element, element_id;
    for (Global e = plan.first_element[b]; e < plan.first_element[b + 1]; ++e) {
      if (plan.part[e] != rank)
        continue;
      const Global in_block = e - plan.first_element[b];
      for (int i = 0; i < width; ++i)
        cells.push_back(local[block.nodes[width * in_block + i]]);
      element.push_back(e);
      element_id.push_back(block.element_id.empty() ? e + 1 : block.element_id[in_block]);
    }
    out.add(block.id);
    out.add(block.name);
    out.add(block.type);
    out.add(cells);
    out.add(element);
    out.add(element_id);
  }

  out.add(static_cast<int>(data.node_sets.size()));
  for (const auto& [name, set] : data.node_sets) {
    std::vector<Local> here;
    for (Global n : set)
      if (local[n] >= 0)
        here.push_back(local[n]);
    out.add(name);
    out.add(here);
  }
  out.add(static_cast<int>(data.side_sets.size()));
  for (const auto& [name, set] : data.side_sets) {
    std::vector<Side> here;
    for (const SideData& s : set) {
      const Global e = plan.first_element[s.block] + s.element;
      if (plan.part[e] == rank)
        here.push_back({s.block, static_cast<Local>(plan.local_element[e]), s.side});
    }
    out.add(name);
    out.add(here);
  }
  for (Global n : nodes)
    local[n] = -1;
  return out.take();
}

void unpack_part(const std::vector<char>& bytes, Mesh& mesh) {
  Unpack in(bytes);
  in.get(mesh.dim);
  in.get(mesh.num_nodes);
  in.get(mesh.num_elements);
  in.get(mesh.num_owned);
  in.get(mesh.first_node);
  in.get(mesh.x);
  in.get(mesh.node);
  in.get(mesh.node_input);
  in.get(mesh.node_id);
  mesh.blocks.resize(static_cast<std::size_t>(in.get<int>()));
  for (Block& b : mesh.blocks) {
    in.get(b.id);
    in.get(b.name);
    in.get(b.type);
    in.get(b.nodes);
    in.get(b.element);
    in.get(b.element_id);
  }
  for (int sets = in.get<int>(); sets > 0; --sets) {
    std::string name;
    in.get(name);
    in.get(mesh.node_sets[name]);
  }
  for (int sets = in.get<int>(); sets > 0; --sets) {
    std::string name;
    in.get(name);
    in.get(mesh.side_sets[name]);
  }
}

} // namespace

Mesh distribute(const MeshData& data, const Comm& comm) {
  std::vector<double> points;
  if (comm.is_root())
    points = centres(data);
  std::vector<int> part = bisect(points, data.dim, comm);
  std::vector<std::vector<char>> send(static_cast<std::size_t>(comm.size()));
  if (comm.is_root()) {
    const Plan plan = make_plan(data, std::move(part), comm.size());
    std::vector<Local> local(static_cast<std::size_t>(data.num_nodes()), -1);
    for (int r = 0; r < comm.size(); ++r)
      send[r] = pack_part(data, plan, r, local);
  }
  Mesh mesh(comm);
  unpack_part(comm.exchange(send)[0], mesh);
  return mesh;
}

} // namespace abut::mesh
