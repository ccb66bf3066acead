// SPDX-License-Identifier: BSD-3-Clause
#include "box_grid.hpp"

#include <cmath>

namespace abut::audit {

double Box::nearest(const Vec3& x) const {
  double s = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double d = std::max({low[i] - x[i], x[i] - high[i], 0.0});
    s += d * d;
  }
  return std::sqrt(s);
}

double Box::farthest(const Vec3& x) const {
  double s = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double d = std::max(std::fabs(low[i] - x[i]), std::fabs(x[i] - high[i]));
    s += d * d;
  }
  return std::sqrt(s);
}

BoxGrid::BoxGrid(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  for (const Box& b : boxes_)
    bounds_.add(b);
  if (boxes_.empty())
    return;
  size_cells();
  fill();
}

/// As large as a box on average, and not many more than boxes.
void BoxGrid::size_cells() {
  Vec3 mean = Vec3::zero();
  for (const Box& b : boxes_)
    mean += (1.0 / double(boxes_.size())) * (b.high - b.low);
  const double most = 2.0 * double(boxes_.size()) + 64.0;
  double wanted[3], cells = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double range = bounds_.high[i] - bounds_.low[i];
    wanted[i] = mean[i] > 0.0 ? std::clamp(range / mean[i], 1.0, 1e4) : 1.0;
    cells *= wanted[i];
  }
  const double shrink = cells > most ? std::cbrt(most / cells) : 1.0;
  for (int i = 0; i < 3; ++i) {
    const double range = bounds_.high[i] - bounds_.low[i];
    count_[i] = std::max(1, static_cast<int>(wanted[i] * shrink));
    per_length_[i] = range > 0.0 ? count_[i] / range : 0.0;
    cell_ = std::max(cell_, range / count_[i]);
  }
}

void BoxGrid::fill() {
  const auto each_cell = [&](const Box& b, const auto& visit) {
    for (int x = place(b.low, 0); x <= place(b.high, 0); ++x)
      for (int y = place(b.low, 1); y <= place(b.high, 1); ++y)
        for (int z = place(b.low, 2); z <= place(b.high, 2); ++z)
          visit(std::size_t(index(x, y, z)));
  };
  first_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]) + 1, 0);
  for (const Box& b : boxes_)
    each_cell(b, [&](std::size_t c) { ++first_[c + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c)
    first_[c] += first_[c - 1];
  items_.resize(std::size_t(first_.back()));
  std::vector<Local> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    each_cell(boxes_[i],
              [&](std::size_t c) { items_[std::size_t(next[c]++)] = static_cast<Local>(i); });
}

} // namespace abut::audit
