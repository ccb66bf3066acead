// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_data.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/measure.hpp"
#include "abut/mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace abut::febio {

namespace {

std::vector<Global> sorted(std::vector<Global> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Whether b runs through the same corners in the same direction as a.
bool same_direction(const Global* a, const Global* b, std::size_t count) {
  const std::size_t start = static_cast<std::size_t>(std::find(b, b + count, a[0]) - b);
  return b[(start + 1) % count] == a[1];
}

struct CellBulk {
  double volume;
  Vec3 moment; ///< integral of the position
};

/// Of the shell itself, not of the cell that stands behind its face.
CellBulk shell_bulk(const Vec3* x, std::size_t corners, double thickness) {
  const double volume =
      thickness * fem::face_area(corners == 3 ? fem::FaceType::tri3 : fem::FaceType::quad4, x);
  Vec3 middle = Vec3::zero();
  for (std::size_t a = 0; a < corners; ++a)
    middle += 1.0 / static_cast<double>(corners) * x[a];
  return {volume, volume * middle};
}

} // namespace

MeshTranslation::MeshTranslation(const Model& model, Report& report) : model_(model) {
  data_.title = model.file;
  add_nodes(report);
  add_blocks();
  measure();
  add_node_sets(report);
  add_side_sets();
}

void MeshTranslation::add_nodes(Report& report) {
  const Mesh& mesh = model_.mesh;
  std::set<Global> used;
  for (const Domain& d : mesh.domains)
    used.insert(d.nodes.begin(), d.nodes.end());
  for (std::size_t n = 0; n < mesh.node_id.size(); ++n) {
    if (!used.count(mesh.node_id[n]))
      continue;
    index_.emplace(mesh.node_id[n], static_cast<Global>(data_.node_id.size()));
    data_.node_id.push_back(mesh.node_id[n]);
    for (std::size_t i = 0; i < 3; ++i)
      data_.x.push_back(mesh.x[3 * n + i]);
  }
  const std::size_t left_out = mesh.node_id.size() - data_.node_id.size();
  if (left_out > 0)
    report.add({mesh.line, "Mesh/Nodes", Fate::ignored,
                std::to_string(left_out) + " nodes that belong to no element"});
}

Vec3 MeshTranslation::position(Global id) const {
  const double* x = &data_.x[3 * static_cast<std::size_t>(index_.at(id))];
  return {{x[0], x[1], x[2]}};
}

void MeshTranslation::add_blocks() {
  for (const Domain& d : model_.mesh.domains) {
    mesh::BlockData block;
    block.id = static_cast<int>(data_.blocks.size()) + 1;
    block.name = d.name;
    block.type = d.cell;
    block.element_id = d.id;
    for (const Global id : d.nodes)
      block.nodes.push_back(index_.at(id));
    data_.blocks.push_back(std::move(block));
  }
}

void MeshTranslation::measure() {
  for (const Domain& d : model_.mesh.domains) {
    const std::size_t n = static_cast<std::size_t>(fem::info(d.cell).nodes);
    Bulk bulk;
    Vec3 moment = Vec3::zero();
    for (std::size_t e = 0; e < d.id.size(); ++e) {
      Vec3 x[fem::max_cell_nodes];
      for (std::size_t a = 0; a < n; ++a)
        x[a] = position(d.nodes[e * n + a]);
      const fem::CellMeasure m = fem::measure_cell(d.cell, x);
      if (!(m.least > 0.0)) {
        std::ostringstream text;
        text << model_.where(d.lines[e]) << ": <elem>: element " << d.id[e]
             << " is inside out or degenerate: its Jacobian has determinant " << m.least
             << ", expected > 0. Check the order of its nodes";
        throw InputError(text.str());
      }
      const CellBulk own =
          d.is_shell ? shell_bulk(x + n / 2, n / 2, d.thickness) : CellBulk{m.volume, m.moment};
      bulk.volume += own.volume;
      bulk.volumes.push_back(own.volume);
      moment += own.moment;
    }
    if (bulk.volume > 0.0) // a shell may have no thickness
      bulk.centroid = 1.0 / bulk.volume * moment;
    bulk_.push_back(bulk);
  }
}

void MeshTranslation::add_node_sets(Report& report) {
  for (const NodeSet& set : model_.mesh.node_sets) {
    std::vector<Global> ids;
    for (const Global id : sorted(set.nodes))
      if (index_.count(id))
        ids.push_back(id);
    set_nodes_[set.name] = ids;
    if (set.name.compare(0, 6, "@edge:") == 0)
      continue; // a place, not a set of the file
    if (ids.empty()) {
      report.add({set.line, "Mesh/NodeSet '" + set.name + "'", Fate::ignored,
                  "none of its nodes belongs to an element"});
      continue;
    }
    std::vector<Global>& indices = data_.node_sets[set.name];
    for (const Global id : ids)
      indices.push_back(index_.at(id));
  }
}

void MeshTranslation::add_side_sets() {
  const mesh::SideIndex sides(data_);
  for (const Surface& surface : model_.mesh.surfaces) {
    std::vector<mesh::SideData>& list = data_.side_sets[surface.name];
    std::size_t outward = 0;
    for (const Facet& facet : surface.facets) {
      std::vector<Global> corners;
      for (std::size_t a = 0; a < facet.corners; ++a) {
        const auto node = index_.find(facet.nodes[a]);
        corners.push_back(node == index_.end() ? -1 : node->second); // -1: of no element
      }
      const auto found = sides.find(corners.data(), static_cast<int>(corners.size()));
      if (found.empty())
        throw InputError(model_.where(facet.line) + ": face of surface '" + surface.name +
                         "' is no side of an element");
      const auto same = std::find_if(found.begin(), found.end(), [&](const mesh::SideData& side) {
        return same_direction(corners.data(), mesh::side_nodes(data_, side).data(), corners.size());
      });
      outward += same != found.end();
      list.push_back(same == found.end() ? found[0] : *same);
    }
    if (outward != 0 && outward != surface.facets.size())
      throw InputError(model_.where(surface.line) + ": surface '" + surface.name +
                       "' has faces that point out of their elements and others that point in");
    outwards_[surface.name] = outward > 0;
    if (surface.facets.empty())
      data_.side_sets.erase(surface.name);
  }
}

std::vector<Global> MeshTranslation::nodes_of(const std::string& place, int line) const {
  std::vector<Global> ids;
  const auto named = [&](const char* prefix) {
    const std::string p = prefix;
    return place.compare(0, p.size(), p) == 0 ? place.substr(p.size()) : "";
  };
  const std::string surface = named("@surface:"), elements = named("@elem_set:");
  bool found = false;
  for (const Surface& s : model_.mesh.surfaces)
    if (s.name == surface) {
      found = true;
      for (const Facet& f : s.facets)
        ids.insert(ids.end(), f.nodes.begin(), f.nodes.end());
    }
  for (const ElementSet& set : model_.mesh.element_sets)
    if (set.name == elements) {
      found = true;
      const std::set<Global> wanted(set.elements.begin(), set.elements.end());
      for (const Domain& d : model_.mesh.domains) {
        const std::size_t n = static_cast<std::size_t>(fem::info(d.cell).nodes);
        for (std::size_t e = 0; e < d.id.size(); ++e)
          if (wanted.count(d.id[e]))
            ids.insert(ids.end(), d.nodes.begin() + static_cast<std::ptrdiff_t>(e * n),
                       d.nodes.begin() + static_cast<std::ptrdiff_t>((e + 1) * n));
      }
    }
  if (const auto set = set_nodes_.find(place); set != set_nodes_.end())
    return set->second;
  if (found)
    return sorted(ids);
  std::vector<std::string> names;
  for (const auto& entry : set_nodes_)
    names.push_back(entry.first);
  throw InputError(model_.where(line) + ": there is no node set '" + place + "'; " +
                   nearest_word_hint(place, names.data(), names.size()));
}

std::string MeshTranslation::set_of(const std::vector<Global>& nodes, const std::string& place) {
  const auto own = set_nodes_.find(place);
  if (own != set_nodes_.end() && own->second == nodes && place[0] != '@')
    return place;
  for (const auto& [name, ids] : set_nodes_)
    if (ids == nodes && name[0] != '@')
      return name;
  const std::string surface = place.compare(0, 9, "@surface:") == 0 ? place.substr(9) : "";
  if (data_.side_sets.count(surface) && !data_.node_sets.count(surface) &&
      nodes_of(place, 0) == nodes)
    return surface;
  std::string name = place.substr(place[0] == '@' ? place.find(':') + 1 : 0) + "_rest";
  while (data_.node_sets.count(name) || data_.side_sets.count(name))
    name += "_";
  set_nodes_[name] = nodes;
  for (const Global id : nodes)
    data_.node_sets[name].push_back(index_.at(id));
  return name;
}

std::string MeshTranslation::add_side_set(std::string name,
                                          const std::vector<mesh::SideData>& sides) {
  while (data_.node_sets.count(name) || data_.side_sets.count(name))
    name += "_";
  data_.side_sets[name] = sides;
  return name;
}

double MeshTranslation::face_size(const std::string& surface) const {
  double sum = 0.0;
  std::size_t count = 0;
  for (const Surface& s : model_.mesh.surfaces)
    if (s.name == surface)
      for (const Facet& f : s.facets) {
        const Vec3 a = position(f.nodes[0]), b = position(f.nodes[1]), c = position(f.nodes[2]);
        const double area = f.corners == 3 ? 0.5 * norm(cross(b - a, c - a))
                                           : 0.5 * norm(cross(c - a, position(f.nodes[3]) - b));
        sum += std::sqrt(area);
        ++count;
      }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double MeshTranslation::inverse_depth(const mesh::SideData& side) const {
  const std::vector<Vec3> x = mesh::side_points(data_, side);
  return fem::face_area(mesh::cell_side(data_, side).type, x.data()) /
         bulk_[std::size_t(side.block)].volumes[std::size_t(side.element)];
}

} // namespace abut::febio
