// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/febio/model.hpp"
#include "abut/febio/report.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace abut::febio {

/// The mesh of a model as abut has it, with what the deck needs to know of it. Nodes of no element
/// are left out, as in FEBio.
class MeshTranslation {
public:
  /// Throws InputError for an inverted element or a face of no element.
  MeshTranslation(const Model& model, Report& report);

  mesh::MeshData& data() { return data_; }
  const mesh::MeshData& data() const { return data_; }

  /// Ids of the nodes of a place as boundary conditions name it: a node set, "@surface:NAME",
  /// "@elem_set:NAME", "@edge:NAME"; ascending, each once. Throws InputError with this line.
  std::vector<Global> nodes_of(const std::string& place, int line) const;

  /// Name of a node set, or of a side set that shares no name with one, with exactly these nodes;
  /// added to the mesh when there is none. `place` is where they come from.
  std::string set_of(const std::vector<Global>& nodes, const std::string& place);

  /// Adds faces as a side set and returns its name: this one, or a longer one where it is taken.
  std::string add_side_set(std::string name, const std::vector<mesh::SideData>& sides);

  /// Whether the faces of a surface, as listed in the file, point out of their elements.
  bool points_outwards(const std::string& surface) const { return outwards_.at(surface); }
  /// Mean square root of the areas of its faces, by their corners [length].
  double face_size(const std::string& surface) const;

  /// Volume and centroid of a domain in the reference configuration.
  struct Bulk {
    double volume = 0.0;
    std::vector<double> volumes; ///< (elements)
    Vec3 centroid = Vec3::zero();
  };
  const Bulk& bulk(std::size_t domain) const { return bulk_[domain]; }
  /// Area of a side over the volume of its element [1/length].
  double inverse_depth(const mesh::SideData& side) const;

private:
  void add_nodes(Report& report);
  void add_blocks();
  void add_node_sets(Report& report);
  void add_side_sets();
  void measure();
  Vec3 position(Global id) const;

  const Model& model_;
  mesh::MeshData data_;
  std::unordered_map<Global, Global> index_; ///< of node ids
  std::map<std::string, bool> outwards_;
  std::map<std::string, std::vector<Global>> set_nodes_; ///< ids, ascending
  std::vector<Bulk> bulk_;
};

} // namespace abut::febio
