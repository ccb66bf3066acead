// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/views.hpp"
#include "abut/search/box.hpp"

#include <vector>

namespace abut::search {

constexpr int max_open_nodes = 64; ///< halving 2^31 items needs half as many

template <int D> struct TreeNode {
  Box<D> box;
  Local first = 0, count = 0; ///< items of a leaf
  Local left = -1, right = -1;
};

/// What kernels read of a Bvh. Copied by value; the arrays are shared with the Bvh, so that a copy
/// follows its refits and outlives the Bvh itself.
template <int D> struct Tree {
  View<const TreeNode<D>> nodes; ///< a parent stands before its children
  View<const Local> items;
  View<const Box<D>> boxes; ///< (items)
  Local size = 0;

  /// Calls visit(item) once for every item whose box passes test(box); a node is skipped as soon as
  /// its own box fails, so the test may sharpen as items are visited. No order is promised.
  template <class Test, class Visit>
  KOKKOS_INLINE_FUNCTION void traverse(const Test& test, const Visit& visit) const {
    traverse(test, visit, [](const Box<D>&, const Box<D>&) { return true; });
  }
  /// The same, of two halves first the left one where left_first(left box, right box).
  template <class Test, class Visit, class LeftFirst>
  KOKKOS_INLINE_FUNCTION void traverse(const Test& test, const Visit& visit,
                                       const LeftFirst& left_first) const {
    if (size == 0)
      return;
    Local stack[max_open_nodes];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const TreeNode<D>& node = nodes(stack[--top]);
      if (!test(node.box))
        continue;
      if (node.count > 0) {
        for (Local i = node.first; i < node.first + node.count; ++i)
          if (test(boxes(items(i))))
            visit(items(i));
      } else {
        const bool ahead = left_first(nodes(node.left).box, nodes(node.right).box);
        stack[top++] = ahead ? node.right : node.left;
        stack[top++] = ahead ? node.left : node.right;
      }
    }
  }
};

/// Bounding volume hierarchy over boxes (of faces). Built once by median splits, refitted when the
/// boxes move; queries visit every item whose box passes a test, in no promised order. Building and
/// refitting run on the host.
template <int D> class Bvh {
public:
  Bvh() = default;
  Bvh(Bvh&&) = default;
  Bvh& operator=(Bvh&&) = default;
  Bvh(const Bvh&) = delete; // a copy would share the arrays
  Bvh& operator=(const Bvh&) = delete;

  /// Builds the tree over the items' boxes, in arrays of its own: trees given out keep the old
  /// ones.
  void build(const std::vector<Box<D>>& boxes);
  /// Fits the same tree to moved boxes (same count as in build); trees given out follow.
  void refit(const std::vector<Box<D>>& boxes);

  Local size() const { return static_cast<Local>(items_.extent(0)); }

  /// Boxes of the nodes `levels` below the root (or leaves above): a summary of the whole set.
  std::vector<Box<D>> summary(int levels) const;

  /// As Tree::traverse.
  template <class Test, class Visit> void traverse(const Test& test, const Visit& visit) const {
    view().traverse(test, visit);
  }
  Tree<D> view() const { return {nodes_, items_, boxes_, size()}; }

private:
  View<TreeNode<D>> nodes_;
  View<Local> items_;
  View<Box<D>> boxes_;
};

extern template class Bvh<2>;
extern template class Bvh<3>;

} // namespace abut::search
