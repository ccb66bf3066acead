// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

namespace abut::fem {

/// Corner pairs of the edges in the order in which Exodus numbers their middle nodes, which follow
/// the corners, where there are any: the middle node of edge e has the number corners + e.
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

inline CellEdges wedge_edges() {
  static const int ends[9][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4},
                                 {2, 5}, {3, 4}, {4, 5}, {5, 3}};
  return {9, ends};
}

inline CellEdges edges(CellType type) {
  const int corners = info(type).corners;
  return corners == 4 ? tet_edges() : corners == 6 ? wedge_edges() : hex_edges();
}

/// Middle node of the edge between two corners, or -1 when the cell has none.
inline int edge_node(CellType type, int a, int b) {
  if (info(type).nodes == info(type).corners)
    return -1;
  const CellEdges all = edges(type);
  for (int e = 0; e < all.count; ++e)
    if ((all.ends[e][0] == a && all.ends[e][1] == b) ||
        (all.ends[e][0] == b && all.ends[e][1] == a))
      return info(type).corners + e;
  return -1;
}

} // namespace abut::fem
