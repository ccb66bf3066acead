// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/duplicates.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace abut::mesh {

namespace {

Global key(Global node) {
  return node;
}
std::tuple<int, Global, int> key(const SideData& side) {
  return {side.block, side.element, side.side};
}

template <class Sets>
void drop(Sets& sets, const std::string& what, const std::string& members,
          std::vector<std::string>& said) {
  for (auto& [name, list] : sets) {
    std::set<decltype(key(list.front()))> seen;
    const auto is_again = [&](const auto& member) { return !seen.insert(key(member)).second; };
    const auto end = std::remove_if(list.begin(), list.end(), is_again);
    const auto count = list.end() - end;
    list.erase(end, list.end());
    if (count > 0)
      said.push_back(what + " '" + name + "' lists " + members +
                     " more than once; each counts once (" + std::to_string(count) + " left out)");
  }
}

} // namespace

std::vector<std::string> drop_duplicates(MeshData& mesh) {
  std::vector<std::string> said;
  drop(mesh.node_sets, "node set", "nodes", said);
  drop(mesh.side_sets, "side set", "faces", said);
  return said;
}

} // namespace abut::mesh
