// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/surfaces.hpp"

#include "abut/mesh/select_sides.hpp"
#include "abut/mesh/sides.hpp"
#include "abut/scene/names.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace abut::scene {

namespace {

using Sides = std::vector<mesh::SideData>;

/// Makes surfaces, those first that others are made of.
class Surfaces {
public:
  Surfaces(const Options& options, mesh::MeshData& mesh, const Where& where)
      : options_(options), mesh_(mesh), where_(where), outer_(mesh::SideIndex(mesh).outer()) {
    for (const auto& entry : mesh.side_sets)
      names_.push_back(entry.first);
    for (const auto& entry : mesh.node_sets)
      node_sets_.push_back(entry.first);
    for (const SurfaceOptions& surface : options.surfaces) {
      const std::string path = "surfaces." + surface.name;
      if (mesh.side_sets.count(surface.name))
        fail(path, "the mesh has a side set of this name");
      if (mesh.node_sets.count(surface.name))
        fail(path, "the mesh has a node set of this name");
      names_.push_back(surface.name);
    }
  }

  void make_all() {
    for (const SurfaceOptions& surface : options_.surfaces)
      make(surface);
    for (const SurfaceOptions& surface : options_.surfaces)
      mesh_.node_sets[surface.name] = mesh::nodes_of_sides(mesh_, mesh_.side_sets.at(surface.name));
  }

private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw InputError(where_(path) + ": " + message);
  }

  void make(const SurfaceOptions& surface) {
    if (mesh_.side_sets.count(surface.name))
      return;
    being_made_.insert(surface.name);
    const std::string path = "surfaces." + surface.name;
    std::string story;
    Sides sides;
    if (surface.selects() || surface.join.empty())
      sides = selected(path, surface, story);
    for (const std::string& name : surface.join) {
      const Sides other = sides_of(path + ".join", name);
      Sides both;
      std::set_union(sides.begin(), sides.end(), other.begin(), other.end(),
                     std::back_inserter(both));
      sides = both;
      story += ", " + std::to_string(sides.size()) + " with '" + name + "'";
    }
    for (const std::string& name : surface.subtract) {
      const Sides other = sides_of(path + ".subtract", name);
      Sides rest;
      std::set_difference(sides.begin(), sides.end(), other.begin(), other.end(),
                          std::back_inserter(rest));
      sides = rest;
      story += ", " + std::to_string(sides.size()) + " without '" + name + "'";
    }
    if (sides.empty())
      fail(path, "no face is left: " + story.substr(story.empty() ? 0 : 2));
    mesh_.side_sets[surface.name] = sides;
    being_made_.erase(surface.name);
  }

  Sides selected(const std::string& path, const SurfaceOptions& surface, std::string& story) {
    Sides sides = surface.part_of.empty() ? outer_ : sides_of(path + ".part_of", surface.part_of);
    story = ", " + std::to_string(sides.size()) +
            (surface.part_of.empty() ? " outer faces" : " faces of '" + surface.part_of + "'");
    const auto keep = [&](const std::vector<char>& in_block, const std::string& words) {
      sides.erase(std::remove_if(sides.begin(), sides.end(),
                                 [&](const mesh::SideData& side) {
                                   return !in_block[std::size_t(side.block)];
                                 }),
                  sides.end());
      story += ", " + std::to_string(sides.size()) + " of " + words;
    };
    if (!surface.blocks.empty())
      keep(blocks(path + ".blocks", surface.blocks), "the blocks");
    for (const BodyOptions& body : options_.bodies) {
      if (body.name != surface.body)
        continue;
      if (body.blocks.empty())
        fail(path + ".body", "body '" + body.name + "' has no blocks");
      keep(blocks("bodies." + body.name + ".blocks", body.blocks), "the body");
    }
    if (!surface.selection.node_set.empty())
      require_name(where_, path + ".node_set", "node set", surface.selection.node_set, node_sets_);
    mesh::SelectedSides selected = mesh::select_sides(mesh_, std::move(sides), surface.selection);
    story += selected.story;
    return selected.sides;
  }

  /// (blocks) whether it is one of these, given by name or number.
  std::vector<char> blocks(const std::string& path, const std::vector<std::string>& words) const {
    std::vector<std::string> names;
    for (const mesh::BlockData& block : mesh_.blocks)
      names.push_back(block.name);
    std::vector<char> chosen(names.size(), 0);
    for (const std::string& word : words) {
      const int at = block_called(mesh_.blocks, word);
      if (at < 0)
        require_name(where_, path, "block", word, names);
      chosen[std::size_t(at)] = 1;
    }
    return chosen;
  }

  /// Ordered sides of a side set of the mesh or of a surface, which is made if need be.
  Sides sides_of(const std::string& path, const std::string& name) {
    if (being_made_.count(name))
      fail(path, "'" + name + "' is itself made of this surface");
    for (const SurfaceOptions& surface : options_.surfaces)
      if (surface.name == name)
        make(surface);
    require_name(where_, path, "side set or surface", name, names_);
    Sides sides = mesh_.side_sets.at(name);
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  const Options& options_;
  mesh::MeshData& mesh_;
  const Where& where_;
  Sides outer_;
  std::vector<std::string> names_; ///< side sets and surfaces
  std::vector<std::string> node_sets_;
  std::set<std::string> being_made_;
};

} // namespace

void add_surfaces(const Options& options, mesh::MeshData& mesh, const Where& where) {
  if (!options.surfaces.empty())
    Surfaces(options, mesh, where).make_all();
}

} // namespace abut::scene
