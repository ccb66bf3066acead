// SPDX-License-Identifier: BSD-3-Clause
#include "abut/search/bvh.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <numeric>

namespace abut::search {

namespace {
constexpr Local leaf_size = 4;

/// Halves a list of boxes until leaf_size are left.
template <int D> struct Halving {
  const std::vector<Box<D>>& boxes;
  std::vector<TreeNode<D>> nodes;
  std::vector<Local> items;

  double center(Local item, int i) const {
    return 0.5 * (boxes[item].low[i] + boxes[item].high[i]);
  }

  Local split(Local first, Local count) {
    const auto id = static_cast<Local>(nodes.size());
    nodes.push_back({});
    Box<D> box = Box<D>::empty(), centers = Box<D>::empty();
    for (Local k = first; k < first + count; ++k) {
      box.add(boxes[items[k]]);
      double c[D];
      for (int i = 0; i < D; ++i)
        c[i] = center(items[k], i);
      centers.add(c);
    }
    nodes[id].box = box;
    if (count <= leaf_size) {
      nodes[id].first = first;
      nodes[id].count = count;
      return id;
    }
    int axis = 0;
    for (int i = 1; i < D; ++i)
      if (centers.high[i] - centers.low[i] > centers.high[axis] - centers.low[axis])
        axis = i;
    const Local half = count / 2;
    std::nth_element(items.begin() + first, items.begin() + first + half,
                     items.begin() + first + count, [&](Local a, Local b) {
                       const double ca = center(a, axis), cb = center(b, axis);
                       return ca != cb ? ca < cb : a < b;
                     });
    split(first, half);
    nodes[id].right = split(first + half, count - half);
    return id;
  }
};

} // namespace

template <int D> void Bvh<D>::build(const std::vector<Box<D>>& boxes) {
  Halving<D> halving{boxes, {}, std::vector<Local>(boxes.size())};
  std::iota(halving.items.begin(), halving.items.end(), 0);
  halving.nodes.reserve(boxes.size());
  if (!boxes.empty())
    halving.split(0, static_cast<Local>(boxes.size()));
  nodes_ = make_view("abut::search::nodes", halving.nodes);
  items_ = make_view("abut::search::items", halving.items);
  boxes_ = View<Box<D>>("abut::search::boxes", boxes.size());
  place(boxes);
}

template <int D> void Bvh<D>::place(const std::vector<Box<D>>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    boxes_(i) = boxes[std::size_t(items_(i))];
}

template <int D> void Bvh<D>::refit(const std::vector<Box<D>>& boxes) {
  ABUT_REQUIRE(boxes.size() == boxes_.extent(0), "refit needs the boxes the tree was built on");
  place(boxes);
  for (auto id = nodes_.extent(0); id-- > 0;) {
    TreeNode<D>& node = nodes_(id);
    node.box = Box<D>::empty();
    for (Local k = node.first; k < node.first + node.count; ++k)
      node.box.add(boxes_(k));
    if (node.count > 0)
      continue;
    node.box.add(nodes_(id + 1).box);
    node.box.add(nodes_(node.right).box);
  }
}

template <int D> std::vector<Box<D>> Bvh<D>::summary(int levels) const {
  std::vector<Box<D>> result;
  if (size() == 0)
    return result;
  std::vector<std::pair<Local, int>> open{{0, 0}};
  while (!open.empty()) {
    const auto [id, level] = open.back();
    open.pop_back();
    const TreeNode<D>& node = nodes_(id);
    if (level == levels || node.count > 0) {
      result.push_back(node.box);
    } else {
      open.push_back({id + 1, level + 1});
      open.push_back({node.right, level + 1});
    }
  }
  return result;
}

template class Bvh<2>;
template class Bvh<3>;

} // namespace abut::search
