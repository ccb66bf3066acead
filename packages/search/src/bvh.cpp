// SPDX-License-Identifier: BSD-3-Clause
#include "abut/search/bvh.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <numeric>

namespace abut::search {

namespace {
constexpr Local leaf_size = 4;
}

template <int D> void Bvh<D>::build(const std::vector<Box<D>>& boxes) {
  boxes_ = boxes;
  nodes_.clear();
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  if (items_.empty())
    return;
  nodes_.reserve(boxes.size());
  split(0, size());
}

template <int D> Local Bvh<D>::split(Local first, Local count) {
  const auto id = static_cast<Local>(nodes_.size());
  nodes_.push_back({});
  Box<D> box = Box<D>::empty(), centers = Box<D>::empty();
  const auto center = [&](Local item, int i) {
    return 0.5 * (boxes_[item].low[i] + boxes_[item].high[i]);
  };
  for (Local k = first; k < first + count; ++k) {
    box.add(boxes_[items_[k]]);
    double c[D];
    for (int i = 0; i < D; ++i)
      c[i] = center(items_[k], i);
    centers.add(c);
  }
  nodes_[id].box = box;
  if (count <= leaf_size) {
    nodes_[id].first = first;
    nodes_[id].count = count;
    return id;
  }
  int axis = 0;
  for (int i = 1; i < D; ++i)
    if (centers.high[i] - centers.low[i] > centers.high[axis] - centers.low[axis])
      axis = i;
  const Local half = count / 2;
  std::nth_element(items_.begin() + first, items_.begin() + first + half,
                   items_.begin() + first + count, [&](Local a, Local b) {
                     const double ca = center(a, axis), cb = center(b, axis);
                     return ca != cb ? ca < cb : a < b;
                   });
  const Local left = split(first, half);
  const Local right = split(first + half, count - half);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

template <int D> void Bvh<D>::refit(const std::vector<Box<D>>& boxes) {
  ABUT_REQUIRE(boxes.size() == boxes_.size(), "refit needs the boxes the tree was built on");
  boxes_ = boxes;
  for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
    node->box = Box<D>::empty();
    for (Local k = node->first; k < node->first + node->count; ++k)
      node->box.add(boxes_[items_[k]]);
    if (node->count > 0)
      continue;
    node->box.add(nodes_[node->left].box);
    node->box.add(nodes_[node->right].box);
  }
}

template <int D> std::vector<Box<D>> Bvh<D>::summary(int levels) const {
  std::vector<Box<D>> result;
  if (nodes_.empty())
    return result;
  std::vector<std::pair<Local, int>> open{{0, 0}};
  while (!open.empty()) {
    const auto [id, level] = open.back();
    open.pop_back();
    const TreeNode<D>& node = nodes_[id];
    if (level == levels || node.count > 0) {
      result.push_back(node.box);
    } else {
      open.push_back({node.left, level + 1});
      open.push_back({node.right, level + 1});
    }
  }
  return result;
}

template class Bvh<2>;
template class Bvh<3>;

} // namespace abut::search
