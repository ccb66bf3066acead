// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples.hpp"

#include "abut/audit/belief.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace abut::audit {

/// A set of interfaces, each for one of its sides, by their bits. Of those beyond the 64th nothing
/// is told apart: everything belongs to them.
struct Sides {
  std::uint64_t primary = ~std::uint64_t(0), secondary = ~std::uint64_t(0);

  void keep(const Sides& o) {
    primary &= o.primary;
    secondary &= o.secondary;
  }
};

/// Which nodes and pieces the surfaces of interfaces have.
class InterfaceSides {
public:
  /// of_node: pieces (N). Collective.
  InterfaceSides(const mesh::Mesh& mesh, const std::vector<Interface>& interfaces,
                 const NodeExchange& exchange, const std::vector<Global>& of_node);

  int size() const { return static_cast<int>(pieces_.size()); }
  /// Interfaces that have all these corners of a face, (count).
  Sides of_nodes(const Local* nodes, int count) const;
  bool joins_bodies(int interface, Global a, Global b) const;
  /// a, b: those of the two faces.
  bool joins_faces(int interface, const Sides& a, const Sides& b) const;

private:
  struct PiecesOf {
    std::set<Global> primary, secondary;
  };
  std::vector<Sides> of_node_; ///< (N)
  std::vector<PiecesOf> pieces_;
};

} // namespace abut::audit
