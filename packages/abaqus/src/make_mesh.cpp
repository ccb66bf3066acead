// SPDX-License-Identifier: BSD-3-Clause
#include "make_mesh.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/measure.hpp"
#include "abut/mesh/sides.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace abut::abaqus {

namespace {

std::vector<std::array<Global, 3>> sorted(const std::vector<mesh::SideData>& sides) {
  std::vector<std::array<Global, 3>> keys;
  for (const mesh::SideData& s : sides)
    keys.push_back({s.block, s.element, s.side});
  std::sort(keys.begin(), keys.end());
  return keys;
}

} // namespace

MeshTranslation::MeshTranslation(const Model& model, Report& report)
    : model_(model), report_(report), index_(model.nodes.size(), -1), place_(model.elements.size()),
      section_(model.elements.size(), -1), rigid_(model.elements.size(), -1) {
  data_.title = model.files[0];
  assign();
  add_solids();
  add_facets();
  number();
  require_upright(report);
  add_sets();
}

void MeshTranslation::say(const Place& place, const std::string& path, Fate fate,
                          const std::string& note) {
  report_.add({place.line, place.file == 0 ? path : model_.where(place) + ": " + path, fate, note});
}

Vec3 MeshTranslation::position(Global n) const {
  const double* x = &data_.x[3 * static_cast<std::size_t>(n)];
  return {{x[0], x[1], x[2]}};
}

/// To which section or rigid body each element belongs.
void MeshTranslation::assign() {
  std::size_t again = 0;
  for (std::size_t s = 0; s < model_.sections.size(); ++s)
    for (const int e : model_.sections[s].elements) {
      again += section_[std::size_t(e)] >= 0;
      section_[std::size_t(e)] = static_cast<int>(s);
    }
  if (again > 0)
    say(model_.sections.back().place, "*SOLID SECTION", Fate::used,
        std::to_string(again) + " elements are in several sections: the last one counts");
  for (std::size_t r = 0; r < model_.rigid_bodies.size(); ++r)
    for (const int e : model_.rigid_bodies[r].elements) {
      if (rigid_[std::size_t(e)] >= 0 && rigid_[std::size_t(e)] != static_cast<int>(r))
        throw InputError(model_.where(model_.rigid_bodies[r].place) + ": *RIGID BODY: element " +
                         std::to_string(model_.elements[std::size_t(e)].label) +
                         " is in another rigid body already");
      rigid_[std::size_t(e)] = static_cast<int>(r);
    }
  std::map<std::string, std::pair<Place, std::size_t>> without;
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    const Element& element = model_.elements[e];
    if (rigid_[e] >= 0 || (section_[e] >= 0 && element.type->cell))
      continue;
    ++without.try_emplace(element.type->name, element.place, 0).first->second.second;
  }
  for (const auto& [type, found] : without)
    say(found.first, "*ELEMENT, TYPE=" + type, Fate::refused,
        std::to_string(found.second) + " elements are in no " +
            (element_type(type)->is_facet() ? "*RIGID BODY" : "*SOLID SECTION or *RIGID BODY"));
}

int MeshTranslation::mesh_node(int node) {
  int& at = index_[std::size_t(node)];
  if (at < 0) {
    at = static_cast<int>(source_.size());
    source_.push_back(node);
    const auto& x = model_.nodes[std::size_t(node)].x;
    data_.x.insert(data_.x.end(), x.begin(), x.end());
  }
  return at;
}

void MeshTranslation::add_solids() {
  // Nodes keep the order of the file.
  std::vector<bool> used(model_.nodes.size(), false);
  for (const Element& e : model_.elements)
    for (int a = 0; a < e.type->nodes; ++a)
      used[std::size_t(model_.nodes_of(e)[a])] = true;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (used[n])
      mesh_node(static_cast<int>(n));
  std::map<std::tuple<int, int, std::string, fem::CellType>, int> block_of;
  std::map<std::tuple<int, int, std::string>, int> body_of;
  for (std::size_t e = 0; e < model_.elements.size(); ++e) {
    const Element& element = model_.elements[e];
    const ElementType& type = *element.type;
    if (!type.cell || (section_[e] < 0 && rigid_[e] < 0))
      continue;
    const int section = rigid_[e] >= 0 ? -1 : section_[e];
    const char* const word = rigid_[e] >= 0 ? nullptr : type.element;
    const std::string key = word ? word : "";
    const auto [at, is_new] = block_of.try_emplace({section, rigid_[e], key, *type.cell},
                                                   static_cast<int>(data_.blocks.size()));
    if (is_new) {
      data_.blocks.emplace_back().type = *type.cell;
      elements_.emplace_back();
      const auto [body, first] =
          body_of.try_emplace({section, rigid_[e], key}, static_cast<int>(bodies_.size()));
      if (first)
        bodies_.push_back({section, rigid_[e], word, {}});
      bodies_[std::size_t(body->second)].blocks.push_back(at->second);
    }
    mesh::BlockData& block = data_.blocks[std::size_t(at->second)];
    place_[e] = {at->second, static_cast<Global>(elements_[std::size_t(at->second)].size()), -1};
    elements_[std::size_t(at->second)].push_back(static_cast<int>(e));
    for (int a = 0; a < type.nodes; ++a)
      block.nodes.push_back(mesh_node(model_.nodes_of(element)[type.order ? type.order[a] : a]));
  }
}

/// Each rigid body's facets lie on the side of it that surfaces name.
void MeshTranslation::add_facets() {
  std::map<int, std::vector<int>> facets;
  for (std::size_t e = 0; e < model_.elements.size(); ++e)
    if (model_.elements[e].type->is_facet() && rigid_[e] >= 0)
      facets[rigid_[e]].push_back(static_cast<int>(e));
  if (facets.empty())
    return;
  std::set<int> positive, negative;
  for (const auto& entry : model_.surfaces)
    for (const Face& f : entry.second.faces)
      if (model_.elements[std::size_t(f.element)].type->is_facet())
        (f.face == Face::negative ? negative : positive).insert(rigid_[std::size_t(f.element)]);
  for (const auto& [rigid, list] : facets) {
    if (positive.count(rigid) && negative.count(rigid))
      say(model_.rigid_bodies[std::size_t(rigid)].place, "*RIGID BODY", Fate::refused,
          "surfaces lie on both sides of its facets, SPOS and SNEG: abut makes solids behind one");
    extrude(rigid, list, !negative.count(rigid));
  }
}

/// A node behind each one of the facets, as far as their edges are long on average.
std::map<int, int> MeshTranslation::nodes_behind(const std::vector<int>& facets, bool positive,
                                                 double& depth) {
  std::map<int, Vec3> normal; // (nodes of the mesh) mean of the facets'
  double edges = 0.0;
  for (const int f : facets) {
    const Element& e = model_.elements[std::size_t(f)];
    const int* nodes = model_.nodes_of(e);
    const int n = e.type->nodes;
    Vec3 x[4];
    for (int a = 0; a < n; ++a)
      x[a] = position(mesh_node(nodes[a]));
    const Vec3 area = cross(x[2] - x[0], n == 4 ? x[3] - x[1] : x[1] - x[0]);
    const double sign = (n == 4 ? 1.0 : -1.0) / std::max(norm(area), 1e-300);
    for (int a = 0; a < n; ++a) {
      normal.try_emplace(mesh_node(nodes[a]), Vec3::zero()).first->second += sign * area;
      edges += norm(x[(a + 1) % n] - x[a]) / n;
    }
  }
  depth = edges / static_cast<double>(facets.size());
  std::map<int, int> behind;
  for (const auto& [n, direction] : normal) {
    const double length = norm(direction);
    const Vec3 x =
        position(n) + (positive ? -depth : depth) / (length > 0.0 ? length : 1.0) * direction;
    behind[n] = static_cast<int>(source_.size());
    source_.push_back(-1);
    for (int i = 0; i < 3; ++i)
      data_.x.push_back(x[i]);
  }
  return behind;
}

void MeshTranslation::extrude(int rigid, const std::vector<int>& facets, bool positive) {
  double depth = 0.0;
  const std::map<int, int> behind = nodes_behind(facets, positive, depth);
  Body body{-1, rigid, nullptr, {}};
  for (const auto& [nodes, cell] :
       {std::pair(4, fem::CellType::hex8), {3, fem::CellType::wedge6}}) {
    mesh::BlockData block;
    block.type = cell;
    std::vector<int> list;
    for (const int f : facets) {
      const Element& e = model_.elements[std::size_t(f)];
      if (e.type->nodes != nodes)
        continue;
      // The lower face first: behind facets that look up, else the facet itself.
      for (const bool lower : {true, false})
        for (int a = 0; a < nodes; ++a) {
          const int n = mesh_node(model_.nodes_of(e)[a]);
          block.nodes.push_back(lower == positive ? behind.at(n) : n);
        }
      const int top = nodes == 4 ? 5 : 4;
      place_[std::size_t(f)] = {static_cast<int>(data_.blocks.size()),
                                static_cast<Global>(list.size()), positive ? top : top - 1};
      list.push_back(f);
    }
    if (list.empty())
      continue;
    body.blocks.push_back(static_cast<int>(data_.blocks.size()));
    data_.blocks.push_back(std::move(block));
    elements_.push_back(std::move(list));
  }
  const auto same =
      std::find_if(bodies_.begin(), bodies_.end(), [&](const Body& b) { return b.rigid == rigid; });
  if (same != bodies_.end())
    same->blocks.insert(same->blocks.end(), body.blocks.begin(), body.blocks.end());
  else
    bodies_.push_back(std::move(body));
  say(model_.rigid_bodies[std::size_t(rigid)].place, "*RIGID BODY", Fate::used,
      std::to_string(facets.size()) + " facets become solids of depth " + std::to_string(depth) +
          " behind the side that touches");
}

/// Names of blocks, and the file's numbers where each comes once.
void MeshTranslation::number() {
  std::set<std::string> taken;
  for (const Body& body : bodies_) {
    const std::string name = body.section >= 0 ? model_.sections[std::size_t(body.section)].set
                                               : model_.rigid_bodies[std::size_t(body.rigid)].name;
    for (const int b : body.blocks) {
      mesh::BlockData& block = data_.blocks[std::size_t(b)];
      block.id = b + 1;
      block.name = name;
      if (body.blocks.size() > 1)
        block.name += std::string("_") + fem::info(block.type).name;
      if (body.element)
        block.name += taken.count(block.name) ? std::string("_") + body.element : "";
      const std::string base = block.name;
      for (int i = 2; !taken.insert(block.name).second; ++i)
        block.name = base + "_" + std::to_string(i);
    }
  }
  std::set<Global> nodes, elements;
  std::size_t count = 0;
  Global largest = 0;
  for (const int n : source_)
    if (n >= 0)
      nodes.insert(model_.nodes[std::size_t(n)].label);
  if (!nodes.empty())
    largest = *nodes.rbegin();
  const auto made = static_cast<std::size_t>(std::count(source_.begin(), source_.end(), -1));
  const bool unique = nodes.size() + made == source_.size();
  for (const int n : source_)
    if (unique)
      data_.node_id.push_back(n >= 0 ? model_.nodes[std::size_t(n)].label : ++largest);
  for (const auto& list : elements_)
    for (const int e : list) {
      elements.insert(model_.elements[std::size_t(e)].label);
      ++count;
    }
  for (std::size_t b = 0; b < elements_.size() && elements.size() == count; ++b)
    for (const int e : elements_[b])
      data_.blocks[b].element_id.push_back(model_.elements[std::size_t(e)].label);
  if (!unique || elements.size() != count)
    say(model_.nodes[0].place, "numbers", Fate::used,
        "instances have the same numbers of nodes or elements: those are numbered anew");
}

void MeshTranslation::require_upright(Report&) const {
  for (std::size_t b = 0; b < data_.blocks.size(); ++b) {
    const mesh::BlockData& block = data_.blocks[b];
    const auto n = static_cast<std::size_t>(fem::info(block.type).nodes);
    for (std::size_t e = 0; e < elements_[b].size(); ++e) {
      Vec3 x[fem::max_cell_nodes];
      for (std::size_t a = 0; a < n; ++a)
        x[a] = position(block.nodes[e * n + a]);
      const double least = fem::measure_cell(block.type, x).least;
      if (least > 0.0)
        continue;
      const Element& element = model_.elements[std::size_t(elements_[b][e])];
      std::ostringstream text;
      text << model_.where(element.place) << ": *ELEMENT: element " << element.label
           << (element.type->is_facet() ? ", made a solid behind its facet," : "")
           << " is inside out or degenerate: its Jacobian has determinant " << least
           << ", expected > 0. Check the order of its nodes";
      throw InputError(text.str());
    }
  }
}

void MeshTranslation::add_sets() {
  for (const auto& entry : model_.node_sets) {
    const Set& set = entry.second;
    const std::vector<Global> nodes = nodes_of(set.members);
    if (nodes.empty())
      continue;
    data_.node_sets[set.name] = nodes;
    set_name_.emplace(nodes, set.name);
  }
  for (const auto& entry : model_.surfaces)
    if (!entry.second.of_nodes)
      surface(entry.first);
}

std::vector<Global> MeshTranslation::nodes_of(const std::vector<int>& nodes) const {
  std::vector<Global> list;
  for (const int n : nodes)
    if (index(n) >= 0)
      list.push_back(index(n));
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::string MeshTranslation::node_set(const std::vector<Global>& nodes, const std::string& name) {
  const auto found = set_name_.find(nodes);
  if (found != set_name_.end())
    return found->second;
  std::string free = name;
  for (int i = 2; data_.node_sets.count(free) || data_.side_sets.count(free); ++i)
    free = name + "_" + std::to_string(i);
  data_.node_sets[free] = nodes;
  set_name_.emplace(nodes, free);
  return free;
}

std::string MeshTranslation::side_set(std::vector<mesh::SideData> sides, const std::string& name) {
  const auto key = sorted(sides);
  const auto found = side_set_name_.find(key);
  if (found != side_set_name_.end())
    return found->second;
  std::string free = name;
  for (int i = 2; data_.side_sets.count(free); ++i)
    free = name + "_" + std::to_string(i);
  data_.side_sets[free] = std::move(sides);
  side_set_name_.emplace(key, free);
  return free;
}

std::vector<mesh::SideData> MeshTranslation::sides_of(const std::vector<Face>& faces) const {
  std::vector<mesh::SideData> sides;
  std::set<int> outer;
  for (const Face& f : faces) {
    const Location& at = place_[std::size_t(f.element)];
    const ElementType& type = *model_.elements[std::size_t(f.element)].type;
    if (f.face == Face::outer)
      outer.insert(f.element);
    else if (at.block >= 0)
      sides.push_back(
          {at.block, at.element, type.cell ? exodus_side(*type.cell, f.face) : at.side});
  }
  if (!outer.empty())
    for (const mesh::SideData& side : mesh::SideIndex(data_).outer())
      if (outer.count(elements_[std::size_t(side.block)][std::size_t(side.element)]))
        sides.push_back(side);
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

std::string MeshTranslation::surface(const std::string& key) {
  const Surface& s = model_.surfaces.at(key);
  std::vector<mesh::SideData> sides = sides_of(s.faces);
  if (s.of_nodes) {
    const std::vector<Global> nodes = nodes_of(s.nodes);
    const std::set<Global> members(nodes.begin(), nodes.end());
    for (const mesh::SideData& side : mesh::SideIndex(data_).outer()) {
      const std::vector<Global> corners = mesh::side_nodes(data_, side);
      const int count = fem::face_corners(mesh::cell_side(data_, side).type);
      if (std::all_of(corners.begin(), corners.begin() + count,
                      [&](Global n) { return members.count(n) > 0; }))
        sides.push_back(side);
    }
    const std::vector<Global> covered = mesh::nodes_of_sides(data_, sides);
    std::vector<Global> bare;
    std::set_difference(nodes.begin(), nodes.end(), covered.begin(), covered.end(),
                        std::back_inserter(bare));
    if (!bare.empty() || nodes.empty()) {
      say(s.place, "*SURFACE, TYPE=NODE", Fate::refused,
          std::to_string(bare.size()) + " of the " + std::to_string(nodes.size()) +
              " nodes of surface '" + s.name +
              "' are on no outer face with all corners in it: abut needs faces, TYPE=ELEMENT");
      return s.name;
    }
  }
  return side_set(std::move(sides), s.name);
}

double MeshTranslation::face_size(const std::string& side_set) const {
  const auto found = data_.side_sets.find(side_set);
  if (found == data_.side_sets.end() || found->second.empty())
    return 1.0;
  double sum = 0.0;
  for (const mesh::SideData& side : found->second) {
    const std::vector<Vec3> x = mesh::side_points(data_, side);
    sum += std::sqrt(fem::face_area(mesh::cell_side(data_, side).type, x.data()));
  }
  return sum / static_cast<double>(found->second.size());
}

bool MeshTranslation::is_deformable(const std::string& side_set) const {
  const auto found = data_.side_sets.find(side_set);
  return found != data_.side_sets.end() &&
         std::any_of(found->second.begin(), found->second.end(), [&](const mesh::SideData& side) {
           return rigid_[std::size_t(
                      elements_[std::size_t(side.block)][std::size_t(side.element)])] < 0;
         });
}

} // namespace abut::abaqus
