// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/info.hpp"

#include "abut/fem/cell_edges.hpp"
#include "abut/fem/measure.hpp"
#include "abut/mesh/quality.hpp"
#include "abut/mesh/sides.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

namespace abut::mesh {

namespace {

std::vector<Vec3> element_points(const MeshData& mesh, const BlockData& block, std::size_t first) {
  std::vector<Vec3> points;
  for (int a = 0; a < fem::info(block.type).nodes; ++a) {
    const double* x = &mesh.x[3 * std::size_t(block.nodes[first + std::size_t(a)])];
    points.push_back({{x[0], x[1], x[2]}});
  }
  return points;
}

Vec3 center_of(const std::vector<Vec3>& points, int corners) {
  Vec3 sum = Vec3::zero();
  for (int a = 0; a < corners; ++a)
    sum += points[std::size_t(a)];
  return (1.0 / corners) * sum;
}

/// Walks through the elements.
class Survey {
public:
  explicit Survey(const MeshData& mesh) : mesh_(mesh) {
    info_.aspect_ratio.value = -std::numeric_limits<double>::infinity();
    info_.scaled_jacobian.value = std::numeric_limits<double>::infinity();
    info_.min_edge = std::numeric_limits<double>::infinity();
    for (const BlockData& block : mesh.blocks)
      add(block);
    info_.elements = before_;
    if (edges_ > 0)
      info_.mean_edge /= double(edges_);
    else
      info_.min_edge = info_.aspect_ratio.value = info_.scaled_jacobian.value = 0.0;
  }

  MeshInfo take() { return std::move(info_); }

private:
  void add(const BlockData& block) {
    const fem::CellInfo& cell = fem::info(block.type);
    BlockInfo& summary = info_.blocks.emplace_back();
    summary.id = block.id;
    summary.name = block.name;
    summary.type = block.type;
    summary.elements = Global(block.nodes.size()) / cell.nodes;
    for (Global e = 0; e < summary.elements; ++e, ++before_) {
      const std::vector<Vec3> x = element_points(mesh_, block, std::size_t(e * cell.nodes));
      const Global id = block.element_id.empty() ? before_ + 1 : block.element_id[std::size_t(e)];
      const WorstElement here{0.0, block.name, id, center_of(x, cell.corners)};
      summary.volume += fem::measure_cell(block.type, x.data()).volume;
      const double ratio = measure_edges(block.type, x);
      if (ratio > info_.aspect_ratio.value)
        info_.aspect_ratio = here, info_.aspect_ratio.value = ratio;
      const double jacobian = scaled_jacobian(block.type, x.data());
      if (jacobian < info_.scaled_jacobian.value)
        info_.scaled_jacobian = here, info_.scaled_jacobian.value = jacobian;
    }
  }

  /// Longest over shortest.
  double measure_edges(fem::CellType type, const std::vector<Vec3>& x) {
    const fem::CellEdges edges = fem::edges(type);
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (int i = 0; i < edges.count; ++i) {
      const double length =
          norm(x[std::size_t(edges.ends[i][1])] - x[std::size_t(edges.ends[i][0])]);
      least = std::min(least, length);
      largest = std::max(largest, length);
      info_.mean_edge += length;
      ++edges_;
    }
    info_.min_edge = std::min(info_.min_edge, least);
    info_.max_edge = std::max(info_.max_edge, largest);
    return least > 0.0 ? largest / least : std::numeric_limits<double>::infinity();
  }

  const MeshData& mesh_;
  MeshInfo info_;
  Global before_ = 0; ///< elements
  Global edges_ = 0;
};

void add_nodes(const MeshData& mesh, MeshInfo& info) {
  info.nodes = mesh.num_nodes();
  std::vector<char> used(std::size_t(info.nodes), 0);
  for (const BlockData& block : mesh.blocks)
    for (const Global n : block.nodes)
      used[std::size_t(n)] = 1;
  info.loose_nodes = std::count(used.begin(), used.end(), 0);
  for (std::size_t n = 0; n < used.size(); ++n)
    for (int i = 0; i < 3; ++i) {
      const double x = mesh.x[3 * n + std::size_t(i)];
      info.low[i] = n == 0 ? x : std::min(info.low[i], x);
      info.high[i] = n == 0 ? x : std::max(info.high[i], x);
    }
}

void add_sets(const MeshData& mesh, MeshInfo& info) {
  for (const auto& [name, nodes] : mesh.node_sets)
    info.node_sets.push_back({name, Global(nodes.size()), 0.0});
  for (const auto& [name, sides] : mesh.side_sets) {
    SetInfo set{name, Global(sides.size()), 0.0};
    for (const SideData& side : sides)
      set.area += fem::face_area(cell_side(mesh, side).type, side_points(mesh, side).data());
    info.side_sets.push_back(set);
  }
}

/// printf's format with its numbers.
template <class... Args> std::string formatted(const char* format, Args... args) {
  char line[400];
  std::snprintf(line, sizeof line, format, args...);
  return line;
}

std::string point_text(const Vec3& x) {
  return formatted("(%.6g, %.6g, %.6g)", x[0], x[1], x[2]);
}

std::string worst_text(const char* what, const WorstElement& worst) {
  return formatted("  worst %s %.4g: element %lld of block '", what, worst.value, worst.id) +
         worst.block + "' at " + point_text(worst.center) + "\n";
}

/// A name that stands for a side set and a node set has one line.
std::string sets_text(const MeshInfo& info) {
  std::map<std::string, std::string> nodes;
  for (const SetInfo& set : info.node_sets)
    nodes[set.name] = formatted("%lld nodes", set.members);
  std::string out;
  for (const SetInfo& set : info.side_sets) {
    const auto same = nodes.find(set.name);
    out += "  side set " + set.name + formatted(": %lld faces, area %.6g", set.members, set.area) +
           (same == nodes.end() ? "\n" : "; node set of " + same->second + "\n");
    if (same != nodes.end())
      nodes.erase(same);
  }
  for (const auto& [name, count] : nodes)
    out += "  node set " + name + ": " + count + "\n";
  return out;
}

} // namespace

MeshInfo info(const MeshData& mesh) {
  MeshInfo info = Survey(mesh).take();
  add_nodes(mesh, info);
  add_sets(mesh, info);
  return info;
}

std::string text(const MeshInfo& info) {
  std::string out =
      formatted("mesh: %lld nodes, %lld elements in the box ", info.nodes, info.elements) +
      point_text(info.low) + " to " + point_text(info.high) + "\n";
  if (info.loose_nodes > 0)
    out += formatted("  %lld nodes belong to no element\n", info.loose_nodes);
  for (const BlockInfo& block : info.blocks)
    out += formatted("  block %d ", block.id) + block.name +
           formatted(": %lld %s, volume %.6g\n", block.elements, fem::info(block.type).name,
                     block.volume);
  out += sets_text(info);
  out += formatted("  edges: shortest %.4g, mean %.4g, longest %.4g\n", info.min_edge,
                   info.mean_edge, info.max_edge);
  if (info.elements > 0)
    out += worst_text("aspect ratio (longest over shortest edge)", info.aspect_ratio) +
           worst_text("scaled Jacobian (1 is best, 0 or less is inside out)", info.scaled_jacobian);
  return out;
}

} // namespace abut::mesh
