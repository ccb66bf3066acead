// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

namespace abut::fem {

/// Corner pairs of the edges in the order in which Exodus numbers their middle nodes, which follow
/// the corners: the middle node of edge e has the number corners + e.
struct CellEdges {
  int count;
  const int (*ends)[2];
};

inline CellEdges hex_edges() {
  static const int ends[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5},
                                  {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  return {12, ends};
}

inline CellEdges tet_edges() {
  static const int ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  return {6, ends};
}

/// Middle node of the edge between two corners, or -1 when the cell has none.
inline int edge_node(CellType type, int a, int b) {
  CellEdges edges{0, nullptr};
  if (type == CellType::hex20 || type == CellType::hex27)
    edges = hex_edges();
  if (type == CellType::tet10)
    edges = tet_edges();
  for (int e = 0; e < edges.count; ++e)
    if ((edges.ends[e][0] == a && edges.ends[e][1] == b) ||
        (edges.ends[e][0] == b && edges.ends[e][1] == a))
      return info(type).corners + e;
  return -1;
}

} // namespace abut::fem
