// SPDX-License-Identifier: BSD-3-Clause
#include "make_mesh.hpp"

#include "element_type.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/measure.hpp"
#include "abut/mesh/sides.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace abut::gmsh {

namespace {

using translation::Fate;
using translation::Report;

constexpr const char* dimensions[] = {"point", "curve", "surface", "volume"};

/// A physical group, or an entity that is in none.
struct Group {
  int dim = 0, tag = 0;
  bool is_physical = true;

  friend bool operator<(const Group& a, const Group& b) {
    return std::tie(a.dim, a.is_physical, a.tag) < std::tie(b.dim, b.is_physical, b.tag);
  }
};

class Translation {
public:
  Translation(const Model& model, Report& report) : model_(model), report_(report) {}

  mesh::MeshData run() {
    if (has_strange_volumes())
      return {};
    index_nodes();
    add_blocks();
    if (data_.blocks.empty())
      throw InputError(model_.where(model_.elements_at) +
                       ": $Elements: no element has a volume; abut needs hexahedra, tetrahedra or "
                       "prisms (gmsh -3 makes them)");
    keep_used_nodes();
    require_upright();
    add_surfaces();
    add_lower(1);
    add_lower(0);
    return std::move(data_);
  }

private:
  void say(std::size_t at, const std::string& path, Fate fate, const std::string& note) {
    report_.add({static_cast<long long>(at), path, fate, note});
  }

  /// "volume group 'steel'", "surface 7 of no group"
  std::string path(const Group& group) const {
    const std::string dim = dimensions[group.dim];
    return group.is_physical ? dim + " group '" + name(group) + "'"
                             : dim + " " + std::to_string(group.tag) + " of no group";
  }

  std::string name(const Group& group) const {
    const auto found = model_.names.find({group.dim, group.tag});
    const bool has_name =
        group.is_physical && found != model_.names.end() && !found->second.empty();
    return has_name ? found->second
                    : std::string(dimensions[group.dim]) + "_" + std::to_string(group.tag);
  }

  /// Groups of a list of elements: the physical ones, else its entity.
  static std::vector<Group> groups_of(const Elements& list) {
    std::vector<Group> groups;
    for (const int tag : list.physical)
      groups.push_back({list.entity.first, tag, true});
    if (groups.empty())
      groups.push_back({list.entity.first, list.entity.second, false});
    return groups;
  }

  bool has_strange_volumes() {
    std::map<int, std::pair<std::size_t, std::size_t>> strange; // type: first place, count
    for (const Elements& list : model_.elements)
      if (list.entity.first == 3 && !element_type(list.type)->cell && !list.id.empty()) {
        auto& [first, count] = strange.try_emplace(list.type, list.at[0], 0).first->second;
        count += list.id.size();
      }
    for (const auto& [type, found] : strange)
      say(found.first, element_type(type)->name, Fate::refused,
          std::to_string(found.second) + " of them, which abut lacks; it has hexahedra of 8, 20 "
                                         "and 27 nodes, tetrahedra of 4 and 10, prisms of 6");
    return !strange.empty();
  }

  void index_nodes() {
    for (std::size_t n = 0; n < model_.node_id.size(); ++n)
      if (!index_.emplace(model_.node_id[n], static_cast<Global>(n)).second)
        throw InputError(model_.where(model_.nodes_at) + ": $Nodes: there are two nodes " +
                         std::to_string(model_.node_id[n]));
  }

  /// Indices in the file of the nodes of an element, in its order there.
  std::vector<Global> nodes_of(const Elements& list, std::size_t e) const {
    const auto n = static_cast<std::size_t>(element_type(list.type)->nodes);
    std::vector<Global> nodes;
    for (std::size_t a = e * n; a < (e + 1) * n; ++a) {
      const auto found = index_.find(list.nodes[a]);
      if (found == index_.end())
        throw InputError(model_.where(list.at[e]) + ": $Elements: element " +
                         std::to_string(list.id[e]) + " has node " + std::to_string(list.nodes[a]) +
                         ", which is not among the nodes");
      if (std::find(nodes.begin(), nodes.end(), found->second) != nodes.end())
        throw InputError(model_.where(list.at[e]) + ": $Elements: element " +
                         std::to_string(list.id[e]) + " has node " + std::to_string(list.nodes[a]) +
                         " twice");
      nodes.push_back(found->second);
    }
    return nodes;
  }

  /// Each element goes to the block of its first group; Gmsh lists it again for each further one.
  void add_blocks() {
    std::set<std::vector<Global>> seen;
    std::map<Group, std::size_t> left_out; // elements that other blocks have
    std::map<std::pair<Group, fem::CellType>, std::size_t> block_of;
    std::map<Group, std::size_t> first_at;
    for (const Elements& list : model_.elements) {
      if (list.entity.first != 3)
        continue;
      const ElementType& type = *element_type(list.type);
      const std::vector<Group> groups = groups_of(list);
      for (const Group& group : groups)
        if (!list.at.empty())
          first_at.emplace(group, list.at[0]);
      for (std::size_t e = 0; e < list.id.size(); ++e) {
        std::vector<Global> nodes = nodes_of(list, e), key = nodes;
        std::sort(key.begin(), key.end());
        const bool again = !seen.insert(key).second;
        for (std::size_t g = again ? 0 : 1; g < groups.size(); ++g)
          ++left_out[groups[g]];
        if (again)
          continue;
        const auto [at, is_new] =
            block_of.try_emplace({groups[0], *type.cell}, data_.blocks.size());
        if (is_new) {
          data_.blocks.emplace_back().type = *type.cell;
          places_.emplace_back();
        }
        mesh::BlockData& block = data_.blocks[at->second];
        for (int a = 0; a < type.nodes; ++a)
          block.nodes.push_back(nodes[std::size_t(type.order ? type.order[a] : a)]);
        block.element_id.push_back(list.id[e]);
        places_[at->second].push_back(list.at[e]);
      }
    }
    name_blocks(block_of);
    for (const auto& [key, b] : block_of)
      say(places_[b][0], path(key.first), Fate::used,
          "block '" + data_.blocks[b].name + "' of " +
              std::to_string(data_.blocks[b].element_id.size()) + " " + fem::info(key.second).name);
    for (const auto& [group, count] : left_out)
      say(first_at.at(group), path(group), Fate::ignored,
          std::to_string(count) + " elements that are in the block of another group already");
    number_elements();
  }

  /// Blocks of one group with cells of several types, and groups of one name, need several names.
  void name_blocks(const std::map<std::pair<Group, fem::CellType>, std::size_t>& block_of) {
    std::map<std::string, int> uses;
    for (const auto& entry : block_of)
      ++uses[name(entry.first.first)];
    std::set<std::string> taken;
    for (const auto& [key, b] : block_of) {
      mesh::BlockData& block = data_.blocks[b];
      block.id = static_cast<int>(b) + 1;
      block.name = name(key.first);
      if (uses[block.name] > 1)
        block.name += std::string("_") + fem::info(key.second).name;
      while (!taken.insert(block.name).second)
        block.name += "_" + std::to_string(key.first.tag);
    }
  }

  /// Element numbers are Gmsh's unless two volumes have the same.
  void number_elements() {
    std::set<Global> numbers;
    std::size_t count = 0;
    for (const mesh::BlockData& block : data_.blocks) {
      numbers.insert(block.element_id.begin(), block.element_id.end());
      count += block.element_id.size();
    }
    if (numbers.size() == count)
      return;
    for (mesh::BlockData& block : data_.blocks)
      block.element_id.clear();
    say(model_.elements_at, "element numbers", Fate::ignored,
        "some come twice; elements are numbered anew");
  }

  /// Leaves out nodes of no volume: centres of arcs, surfaces beside.
  void keep_used_nodes() {
    std::vector<Global> kept(model_.node_id.size(), -1);
    for (const mesh::BlockData& block : data_.blocks)
      for (const Global n : block.nodes)
        kept[std::size_t(n)] = 0;
    for (std::size_t n = 0; n < kept.size(); ++n) {
      if (kept[n] < 0)
        continue;
      kept[n] = static_cast<Global>(data_.node_id.size());
      data_.node_id.push_back(model_.node_id[n]);
      for (std::size_t i = 0; i < 3; ++i)
        data_.x.push_back(model_.x[3 * n + i]);
    }
    for (mesh::BlockData& block : data_.blocks)
      for (Global& n : block.nodes)
        n = kept[std::size_t(n)];
    kept_ = std::move(kept);
    const std::size_t left_out = kept_.size() - data_.node_id.size();
    if (left_out > 0)
      say(model_.nodes_at, "$Nodes", Fate::ignored,
          std::to_string(left_out) + " nodes that belong to no volume");
  }

  void require_upright() const {
    for (std::size_t b = 0; b < data_.blocks.size(); ++b) {
      const mesh::BlockData& block = data_.blocks[b];
      const auto n = static_cast<std::size_t>(fem::info(block.type).nodes);
      for (std::size_t e = 0; e < places_[b].size(); ++e) {
        Vec3 x[fem::max_cell_nodes];
        for (std::size_t a = 0; a < n; ++a) {
          const double* at = &data_.x[3 * std::size_t(block.nodes[e * n + a])];
          x[a] = {{at[0], at[1], at[2]}};
        }
        const double least = fem::measure_cell(block.type, x).least;
        if (least > 0.0)
          continue;
        std::ostringstream text;
        text << model_.where(places_[b][e]) << ": $Elements: this element of block '" << block.name
             << "' is inside out or degenerate: its Jacobian has determinant " << least
             << ", expected > 0";
        throw InputError(text.str());
      }
    }
  }

  bool has_physical(int dim) const {
    return std::any_of(model_.elements.begin(), model_.elements.end(), [=](const Elements& list) {
      return list.entity.first == dim && !list.physical.empty();
    });
  }

  /// Members of each group of a dimension, with the place of the first.
  struct Members {
    std::size_t at = 0;
    std::vector<std::pair<const Elements*, std::size_t>> elements;
  };
  std::map<Group, Members> members(int dim) const {
    std::map<Group, Members> result;
    for (const Elements& list : model_.elements)
      for (std::size_t e = 0; list.entity.first == dim && e < list.id.size(); ++e)
        for (const Group& group : groups_of(list)) {
          Members& m = result[group];
          if (m.elements.empty())
            m.at = list.at[e];
          m.elements.emplace_back(&list, e);
        }
    return result;
  }

  void add_surfaces() {
    const bool named_alone = has_physical(2);
    const mesh::SideIndex index(data_);
    for (const auto& [group, members] : members(2)) {
      if (named_alone && !group.is_physical) {
        say(members.at, path(group), Fate::ignored, "other surfaces are in groups");
        continue;
      }
      std::vector<mesh::SideData> sides;
      std::size_t nowhere = 0, between = 0;
      for (const auto& [list, e] : members.elements) {
        std::vector<Global> corners = nodes_of(*list, e);
        corners.resize(std::size_t(element_type(list->type)->corners));
        for (Global& n : corners)
          n = kept_[std::size_t(n)];
        const auto found = index.find(corners.data(), static_cast<int>(corners.size()));
        nowhere += found.empty();
        between += found.size() > 1;
        if (!found.empty())
          sides.push_back(found[0]);
      }
      add_side_set(group, members.at, std::move(sides), nowhere, between);
    }
  }

  void add_side_set(const Group& group, std::size_t at, std::vector<mesh::SideData> sides,
                    std::size_t nowhere, std::size_t between) {
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    if (nowhere > 0)
      say(at, path(group), Fate::ignored,
          std::to_string(nowhere) + " faces that are no side of a volume");
    if (sides.empty())
      return;
    const std::string set = free_name(group);
    say(at, path(group), Fate::used,
        "side set and node set '" + set + "' of " + std::to_string(sides.size()) + " faces" +
            (between > 0 ? ", " + std::to_string(between) +
                               " of them between two elements, as a side of the first"
                         : ""));
    data_.node_sets[set] = mesh::nodes_of_sides(data_, sides);
    data_.side_sets[set] = std::move(sides);
  }

  /// Curves or points; those of no group are geometry.
  void add_lower(int dim) {
    std::size_t left_out = 0, at_first = 0;
    for (const auto& [group, members] : members(dim)) {
      if (!group.is_physical) {
        at_first = left_out++ == 0 ? members.at : at_first;
        continue;
      }
      std::set<Global> nodes;
      for (const auto& [list, e] : members.elements)
        for (const Global n : nodes_of(*list, e))
          if (kept_[std::size_t(n)] >= 0)
            nodes.insert(kept_[std::size_t(n)]);
      if (nodes.empty()) {
        say(members.at, path(group), Fate::ignored, "none of its nodes belongs to a volume");
        continue;
      }
      const std::string set = free_name(group);
      data_.node_sets[set].assign(nodes.begin(), nodes.end());
      say(members.at, path(group), Fate::used,
          "node set '" + set + "' of " + std::to_string(nodes.size()) + " nodes");
    }
    if (left_out > 0)
      say(at_first, std::string(dimensions[dim]) + "s of no group", Fate::ignored,
          std::to_string(left_out) + " of them");
  }

  /// The group's name, with its dimension where another group has it.
  std::string free_name(const Group& group) const {
    std::string set = name(group);
    if (data_.node_sets.count(set))
      set += std::string("_") + dimensions[group.dim];
    while (data_.node_sets.count(set))
      set += "_" + std::to_string(group.tag);
    return set;
  }

  const Model& model_;
  Report& report_;
  mesh::MeshData data_;
  std::unordered_map<Global, Global> index_;     ///< of node numbers, in the file
  std::vector<Global> kept_;                     ///< (nodes of the file) index in the mesh or -1
  std::vector<std::vector<std::size_t>> places_; ///< (blocks, elements)
};

} // namespace

mesh::MeshData make_mesh(const Model& model, translation::Report& report) {
  return Translation(model, report).run();
}

} // namespace abut::gmsh
