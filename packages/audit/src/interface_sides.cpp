// SPDX-License-Identifier: BSD-3-Clause
#include "interface_sides.hpp"

#include "ask.hpp"

namespace abut::audit {

namespace {

constexpr int told_apart = 64;

std::uint64_t bit(int interface) {
  return std::uint64_t(1) << (interface % told_apart);
}

/// (N) whether the side set has the node, wherever its faces are. Collective.
std::vector<int> marks_of(const mesh::Mesh& mesh, const mesh::Surface& surface,
                          const NodeExchange& exchange) {
  std::vector<int> marks(mesh.node.size(), 0);
  for (const Local n : surface.field_index)
    marks[std::size_t(n)] = 1;
  exchange.max_to_owners(marks.data());
  exchange.to_ghosts(marks.data());
  return marks;
}

std::set<Global> pieces_of(const Comm& comm, const mesh::Surface& surface,
                           const std::vector<Global>& of_node) {
  std::set<Global> mine;
  for (const Local n : surface.field_index)
    mine.insert(of_node[std::size_t(n)]);
  const auto all = share(comm, std::vector<Global>(mine.begin(), mine.end()));
  return {all.begin(), all.end()};
}

} // namespace

InterfaceSides::InterfaceSides(const mesh::Mesh& mesh, const std::vector<Interface>& interfaces,
                               const NodeExchange& exchange, const std::vector<Global>& of_node)
    : of_node_(mesh.node.size()) {
  for (int i = 0; i < static_cast<int>(interfaces.size()); ++i) {
    const Interface& given = interfaces[std::size_t(i)];
    PiecesOf& pieces = pieces_.emplace_back();
    for (const bool first : {true, false}) {
      const auto surface = mesh::extract_surface(mesh, first ? given.primary : given.secondary);
      (first ? pieces.primary : pieces.secondary) = pieces_of(mesh.comm, surface, of_node);
      const std::vector<int> marks = marks_of(mesh, surface, exchange);
      for (std::size_t n = 0; i < told_apart && n < marks.size(); ++n)
        if (!marks[n])
          (first ? of_node_[n].primary : of_node_[n].secondary) &= ~bit(i);
    }
  }
}

Sides InterfaceSides::of_nodes(const Local* nodes, int count) const {
  Sides sides;
  for (int a = 0; a < count; ++a)
    sides.keep(of_node_[std::size_t(nodes[a])]);
  return sides;
}

bool InterfaceSides::joins_bodies(int interface, Global a, Global b) const {
  const PiecesOf& p = pieces_[std::size_t(interface)];
  return (p.primary.count(a) && p.secondary.count(b)) ||
         (p.primary.count(b) && p.secondary.count(a));
}

bool InterfaceSides::joins_faces(int interface, const Sides& a, const Sides& b) const {
  return interface >= told_apart || (a.primary & b.secondary & bit(interface)) ||
         (b.primary & a.secondary & bit(interface));
}

} // namespace abut::audit
