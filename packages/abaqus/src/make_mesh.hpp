// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/abaqus/model.hpp"
#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/translation/report.hpp"

#include <map>
#include <string>
#include <vector>

namespace abut::abaqus {

using translation::Fate;
using translation::Report;

/// Blocks of one section with one word for their elements, or of one rigid body.
struct Body {
  int section = -1, rigid = -1; ///< index in the model; the other is -1
  const char* element = nullptr;
  std::vector<int> blocks;
};

/// The mesh of a model as abut has it, with what the deck needs to know of it. Nodes of no element
/// are left out; rigid facets become bricks and prisms behind the side that touches.
class MeshTranslation {
public:
  /// Throws InputError for an inverted element.
  MeshTranslation(const Model& model, Report& report);

  mesh::MeshData& data() { return data_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  /// Index of a node in the mesh; -1: of no element.
  int index(int node) const { return index_[std::size_t(node)]; }
  /// Block of an element; -1: it has none.
  int block(int element) const { return place_[std::size_t(element)].block; }

  /// Nodes of the mesh among these, ascending, each once.
  std::vector<Global> nodes_of(const std::vector<int>& nodes) const;
  /// Name of a node set with exactly these nodes; made from `name` when there is none.
  std::string node_set(const std::vector<Global>& nodes, const std::string& name);
  /// Name of a side set with exactly these sides, in any order; made from `name` when there is
  /// none.
  std::string side_set(std::vector<mesh::SideData> sides, const std::string& name);
  /// Sides of faces, each once.
  std::vector<mesh::SideData> sides_of(const std::vector<Face>& faces) const;
  /// Name of the side set of a surface. Those of nodes get the outer faces of which they have all
  /// corners; refused when these do not have all its nodes.
  std::string surface(const std::string& key);
  /// Mean square root of the areas of its faces [length].
  double face_size(const std::string& side_set) const;
  /// Whether a face of the surface belongs to a deformable body.
  bool is_deformable(const std::string& side_set) const;

private:
  struct Location {
    int block = -1;
    Global element = 0;
    int side = -1; ///< of a facet that became a solid: the side that touches
  };
  void assign();
  void add_solids();
  void add_facets();
  std::map<int, int> nodes_behind(const std::vector<int>& facets, bool positive, double& depth);
  void extrude(int rigid, const std::vector<int>& facets, bool positive);
  void number();
  void require_upright(Report& report) const;
  void add_sets();
  int mesh_node(int node);
  Vec3 position(Global n) const;
  void say(const Place& place, const std::string& path, Fate fate, const std::string& note);

  const Model& model_;
  Report& report_;
  mesh::MeshData data_;
  std::vector<int> index_;           ///< (nodes)
  std::vector<Location> place_;      ///< (elements)
  std::vector<int> section_, rigid_; ///< (elements) or -1
  std::vector<int> source_;          ///< (nodes of the mesh) of the model; -1: made by extrusion
  std::vector<std::vector<int>> elements_; ///< (blocks, elements) of the model
  std::vector<Body> bodies_;
  std::map<std::vector<Global>, std::string> set_name_;
  std::map<std::vector<std::array<Global, 3>>, std::string> side_set_name_;
};

} // namespace abut::abaqus
