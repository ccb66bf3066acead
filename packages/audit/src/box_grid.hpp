// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/types.hpp"

#include <algorithm>
#include <vector>

namespace abut::audit {

/// How far a quadratic cell may leave the box of its nodes, in the box's lengths: a parabola
/// through three of them whose middle one is as far out as an end.
constexpr double bulge = 0.125;

/// Axis-aligned; empty when low > high.
struct Box {
  Vec3 low{{1e300, 1e300, 1e300}}, high{{-1e300, -1e300, -1e300}};

  void add(const Vec3& x) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], x[i]);
      high[i] = std::max(high[i], x[i]);
    }
  }
  void add(const Box& b) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], b.low[i]);
      high[i] = std::max(high[i], b.high[i]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
  bool holds(const Vec3& x) const {
    for (int i = 0; i < 3; ++i)
      if (x[i] < low[i] || x[i] > high[i])
        return false;
    return true;
  }
  bool meets(const Box& b) const {
    for (int i = 0; i < 3; ++i)
      if (low[i] > b.high[i] || b.low[i] > high[i])
        return false;
    return true;
  }
  /// By a part of its own lengths.
  void widen(double part) {
    for (int i = 0; i < 3; ++i) {
      const double by = part * (high[i] - low[i]);
      low[i] -= by;
      high[i] += by;
    }
  }
  Box around(double distance) const {
    Box b = *this;
    for (int i = 0; i < 3; ++i)
      b.low[i] -= distance, b.high[i] += distance;
    return b;
  }
  double diagonal() const { return is_empty() ? 0.0 : norm(high - low); }
  double nearest(const Vec3& x) const;  ///< distance of x, 0 inside
  double farthest(const Vec3& x) const; ///< largest distance from x to a point of the box
};

/// Boxes sorted into the cells of a uniform grid around all of them.
class BoxGrid {
public:
  BoxGrid() = default;
  explicit BoxGrid(std::vector<Box> boxes);

  bool is_empty() const { return boxes_.empty(); }
  const Box& bounds() const { return bounds_; }
  double cell() const { return cell_; } ///< longest side of a cell
  const Box& box(Local item) const { return boxes_[std::size_t(item)]; }

  /// visit(item) for each box that holds x.
  template <class Visit> void at(const Vec3& x, const Visit& visit) const {
    if (boxes_.empty() || !bounds_.holds(x))
      return;
    const int c = index(place(x, 0), place(x, 1), place(x, 2));
    for (Local k = first_[std::size_t(c)]; k < first_[std::size_t(c) + 1]; ++k)
      if (boxes_[std::size_t(items_[std::size_t(k)])].holds(x))
        visit(items_[std::size_t(k)]);
  }

  /// visit(item) once for each box that meets the region.
  template <class Visit> void in(const Box& region, const Visit& visit) const {
    if (boxes_.empty() || !bounds_.meets(region))
      return;
    int from[3], to[3];
    for (int i = 0; i < 3; ++i) {
      from[i] = place(region.low, i);
      to[i] = place(region.high, i);
    }
    for (int x = from[0]; x <= to[0]; ++x)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int z = from[2]; z <= to[2]; ++z) {
          const int c = index(x, y, z), here[3] = {x, y, z};
          for (Local k = first_[std::size_t(c)]; k < first_[std::size_t(c) + 1]; ++k) {
            const Box& box = boxes_[std::size_t(items_[std::size_t(k)])];
            if (box.meets(region) && begins(box, from, here))
              visit(items_[std::size_t(k)]);
          }
        }
  }

private:
  int place(const Vec3& x, int i) const {
    const double cells = (x[i] - bounds_.low[i]) * per_length_[i];
    return static_cast<int>(std::clamp(cells, 0.0, double(count_[i] - 1)));
  }
  int index(int x, int y, int z) const { return (x * count_[1] + y) * count_[2] + z; }
  /// Whether this is the first of the region's cells that has the box.
  bool begins(const Box& box, const int from[3], const int here[3]) const {
    for (int i = 0; i < 3; ++i)
      if (std::max(place(box.low, i), from[i]) != here[i])
        return false;
    return true;
  }
  void size_cells();
  void fill();

  std::vector<Box> boxes_;
  Box bounds_;
  int count_[3] = {1, 1, 1};
  double per_length_[3] = {0, 0, 0};
  double cell_ = 0.0;
  std::vector<Local> first_, items_; ///< (cells+1), (entries)
};

} // namespace abut::audit
