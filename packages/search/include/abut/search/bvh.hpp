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
  Local first = 0, count = 0; ///< places of a leaf; count 0: two halves, the left one comes next
  Local right = -1;
};

/// What kernels read of a Bvh. Copied by value; the arrays are shared with the Bvh, so that a copy
/// follows its refits and outlives the Bvh itself.
template <int D> struct Tree {
  View<const TreeNode<D>> nodes; ///< a parent stands before its children
  View<const Local> items;       ///< (places) in the order of the leaves
  View<const Box<D>> boxes;      ///< (places)
  Local size = 0;

  /// Calls visit(item) once for every item whose box passes test(box); a node is skipped as soon as
  /// its own box fails, so the test may sharpen as items are visited. No order is promised.
  template <class Test, class Visit>
  KOKKOS_INLINE_FUNCTION void traverse(const Test& test, const Visit& visit) const {
    if (size == 0)
      return;
    Local stack[max_open_nodes];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Local id = stack[--top];
      const TreeNode<D>& node = nodes(id);
      if (!test(node.box))
        continue;
      if (node.count > 0) {
        visit_leaf(node, test, visit);
      } else {
        stack[top++] = node.right;
        stack[top++] = id + 1;
      }
    }
  }

  /// The same from near to far, so that a test that sharpens shuts out more: bound(box) is how near
  /// anything in a box can be, negative where nothing in it counts, and test(box, bound) whether
  /// that is near enough yet.
  template <class Bound, class Test, class Visit>
  KOKKOS_INLINE_FUNCTION void traverse_nearest_first(const Bound& bound, const Test& test,
                                                     const Visit& visit) const {
    struct Open {
      Local node;
      double bound;
    };
    if (size == 0)
      return;
    const auto passes = [&](const Box<D>& box) {
      const double b = bound(box);
      return b >= 0.0 && test(box, b);
    };
    Open stack[max_open_nodes];
    int top = 0;
    Open next{0, bound(nodes(0).box)};
    for (;;) {
      const TreeNode<D>& node = nodes(next.node);
      if (next.bound >= 0.0 && test(node.box, next.bound)) {
        if (node.count == 0) {
          Open left{next.node + 1, bound(nodes(next.node + 1).box)};
          Open right{node.right, bound(nodes(node.right).box)};
          const bool swapped = right.bound >= 0.0 && (left.bound < 0.0 || right.bound < left.bound);
          next = swapped ? right : left;
          const Open& later = swapped ? left : right;
          if (later.bound >= 0.0)
            stack[top++] = later;
          continue;
        }
        visit_leaf(node, passes, visit);
      }
      if (top == 0)
        return;
      next = stack[--top];
    }
  }

private:
  template <class Test, class Visit>
  KOKKOS_INLINE_FUNCTION void visit_leaf(const TreeNode<D>& node, const Test& test,
                                         const Visit& visit) const {
    for (Local i = node.first; i < node.first + node.count; ++i)
      if (test(boxes(i)))
        visit(items(i));
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
  void place(const std::vector<Box<D>>& boxes); ///< in the order of the leaves

  View<TreeNode<D>> nodes_;
  View<Local> items_;
  View<Box<D>> boxes_;
};

extern template class Bvh<2>;
extern template class Bvh<3>;

} // namespace abut::search
