// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/search/box.hpp"

#include <vector>

namespace abut::search {

template <int D> struct TreeNode {
  Box<D> box;
  Local first = 0, count = 0; ///< items of a leaf
  Local left = -1, right = -1;
};

template <int D> struct Tree {
  const TreeNode<D>* nodes = nullptr;
  const Local* items = nullptr;
  const Box<D>* boxes = nullptr;
  Local size = 0;

  template <class Test, class Visit>
  KOKKOS_INLINE_FUNCTION void traverse(const Test& test, const Visit& visit) const {
    if (size == 0)
      return;
    int stack[64], top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const TreeNode<D>& node = nodes[stack[--top]];
      if (!test(node.box))
        continue;
      if (node.count > 0) {
        for (Local i = node.first; i < node.first + node.count; ++i)
          if (test(boxes[items[i]]))
            visit(items[i]);
      } else {
        stack[top++] = node.right;
        stack[top++] = node.left;
      }
    }
  }
};

/// Bounding volume hierarchy over boxes (of faces). Built once by median splits, refitted when the
/// boxes move; queries visit every item whose box passes a test, in no promised order.
template <int D> class Bvh {
public:
  /// Builds the tree over the items' boxes.
  void build(const std::vector<Box<D>>& boxes);
  /// Fits the same tree to moved boxes (same count as in build).
  void refit(const std::vector<Box<D>>& boxes);

  Local size() const { return static_cast<Local>(items_.size()); }

  /// Boxes of the nodes `levels` below the root (or leaves above): a summary of the whole set.
  std::vector<Box<D>> summary(int levels) const;

  /// Calls visit(item) for every item whose box passes `test(box)`; a node is skipped as soon as
  /// its own box fails, so the test may sharpen as items are visited.
  template <class Test, class Visit> void traverse(const Test& test, const Visit& visit) const {
    view().traverse(test, visit);
  }
  Tree<D> view() const { return {nodes_.data(), items_.data(), boxes_.data(), size()}; }

private:
  Local split(Local first, Local count);

  std::vector<TreeNode<D>> nodes_; ///< a parent stands before its children
  std::vector<Local> items_;
  std::vector<Box<D>> boxes_;
};

extern template class Bvh<2>;
extern template class Bvh<3>;

} // namespace abut::search
