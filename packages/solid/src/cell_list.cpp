// SPDX-License-Identifier: BSD-3-Clause
#include "cell_list.hpp"

namespace abut::solid {

void CellList::add(const Local* nodes, int count) {
  for (int a = 0; a < count; ++a) {
    const double* x = &mesh_.x[static_cast<std::size_t>(nodes[a]) * 3];
    node_.push_back(nodes[a]);
    x_.push_back({{x[0], x[1], x[2]}});
    connectivity_.nodes.push_back(mesh_.node[std::size_t(nodes[a])]);
  }
  connectivity_.offsets.push_back(static_cast<Local>(node_.size()));
}

void CellList::add(const mesh::Block& block) {
  const int n = fem::info(block.type).nodes;
  for (Local e = 0; e < block.size(); ++e)
    add(&block.nodes[static_cast<std::size_t>(e) * n], n);
  type_.resize(static_cast<std::size_t>(size()), block.type);
}

CellArrays CellList::arrays() const {
  return {make_view("abut::solid::first_node", connectivity_.offsets),
          make_view("abut::solid::node", node_), make_view("abut::solid::position", x_)};
}

View<const fem::CellType> CellList::types() const {
  return make_view("abut::solid::cell_type", type_);
}

} // namespace abut::solid
