// SPDX-License-Identifier: BSD-3-Clause
#include "aggregates.hpp"

#include <algorithm>

namespace abut::multigrid {

namespace {

constexpr Local none = -1, undecided = -2;

class Aggregation {
public:
  explicit Aggregation(const StrengthGraph& graph)
      : graph_(graph), rows_(static_cast<Local>(graph.offset.size()) - 1) {
    result_.of_row.assign(std::size_t(rows_), undecided);
    for (Local i = 0; i < rows_; ++i)
      if (begin(i) == end(i))
        group(i) = none;
  }

  Aggregates run() {
    take_whole_neighbourhoods();
    join_neighbours();
    take_the_rest();
    return std::move(result_);
  }

private:
  std::vector<Local>::const_iterator begin(Local i) const {
    return graph_.neighbour.begin() + graph_.offset[std::size_t(i)];
  }
  std::vector<Local>::const_iterator end(Local i) const { return begin(i + 1); }
  Local& group(Local i) { return result_.of_row[std::size_t(i)]; }

  void found(Local root) {
    group(root) = result_.count;
    for (auto j = begin(root); j != end(root); ++j)
      if (group(*j) == undecided)
        group(*j) = result_.count;
    ++result_.count;
  }

  void take_whole_neighbourhoods() {
    for (Local i = 0; i < rows_; ++i)
      if (group(i) == undecided &&
          std::none_of(begin(i), end(i), [&](Local j) { return group(j) >= 0; }))
        found(i);
  }

  void join_neighbours() {
    const std::vector<Local> before = result_.of_row;
    std::vector<Local> near;
    for (Local i = 0; i < rows_; ++i) {
      if (before[std::size_t(i)] != undecided)
        continue;
      near.clear();
      for (auto j = begin(i); j != end(i); ++j)
        if (before[std::size_t(*j)] >= 0)
          near.push_back(before[std::size_t(*j)]);
      if (near.empty())
        continue;
      std::sort(near.begin(), near.end());
      std::ptrdiff_t most = 0;
      for (auto first = near.begin(); first != near.end();) {
        const auto last = std::upper_bound(first, near.end(), *first);
        if (last - first > most)
          most = last - first, group(i) = *first;
        first = last;
      }
    }
  }

  void take_the_rest() {
    for (Local i = 0; i < rows_; ++i)
      if (group(i) == undecided)
        found(i);
  }

  const StrengthGraph& graph_;
  Local rows_;
  Aggregates result_;
};

} // namespace

Aggregates aggregate(const StrengthGraph& graph) {
  return Aggregation(graph).run();
}

} // namespace abut::multigrid
