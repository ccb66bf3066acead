// SPDX-License-Identifier: BSD-3-Clause
#include "strength.hpp"

#include "row_messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::multigrid {

namespace {

using Scalars = BlockMatrix<float, 1, 1>;

/// What each coupling of the owned rows is worth, in both directions.
class Evolution {
public:
  Evolution(const Scalars& energies, const Distribution& rows)
      : rows_(rows), size_(sizes(energies)) {
    Scalars step = first_step(energies);
    constexpr int squarings = 2; // four steps
    for (int n = 0; n < squarings; ++n)
      step = squared(step);
    spread_ = step;
    remains_ = remains(step);
    rows.exchange().to_ghosts(size_.data());
    rows.exchange().to_ghosts(remains_.data());
  }

  std::vector<char> strong(double drop_tolerance) const {
    std::vector<float> least(static_cast<std::size_t>(rows_.size()), infinite);
    for_couplings([&](Local i, Local, Local k) {
      least[std::size_t(i)] = std::min(least[std::size_t(i)], from_row(i, k));
    });
    rows_.exchange().to_ghosts(least.data());
    const auto factor = static_cast<float>(drop_tolerance);
    std::vector<char> result(static_cast<std::size_t>(spread_.blocks()), 1);
    for_couplings([&](Local i, Local j, Local k) {
      result[std::size_t(k)] = from_row(i, k) <= factor * least[std::size_t(i)] ||
                               from_column(j, k) <= factor * least[std::size_t(j)];
    });
    return result;
  }

private:
  static constexpr float infinite = std::numeric_limits<float>::infinity();

  std::vector<float> sizes(const Scalars& s) const {
    std::vector<float> size(static_cast<std::size_t>(rows_.size()), 0.0F);
    for (Local i = 0; i < s.rows; ++i)
      for (Local k = s.offset(i); k < s.offset(i + 1); ++k)
        size[std::size_t(i)] += std::fabs(s.value(k));
    return size;
  }

  static Scalars same_places(const Scalars& s) {
    return {s.rows, s.offset, s.column, View<float>("multigrid: evolution", s.column.size())};
  }

  Scalars first_step(const Scalars& s) const {
    Scalars w = same_places(s);
    for (Local i = 0; i < s.rows; ++i)
      for (Local k = s.offset(i); k < s.offset(i + 1); ++k) {
        const float size = size_[std::size_t(i)];
        w.value(k) = (s.column(k) == i ? 1.0F : 0.0F) - (size > 0.0F ? s.value(k) / size : 0.0F);
      }
    return w;
  }

  Scalars squared(const Scalars& w) const {
    const auto extended = with_ghost_rows(w, rows_, rows_);
    const Scalars& all = extended.matrix;
    Scalars result = same_places(w);
    std::vector<float> sum(static_cast<std::size_t>(extended.columns.size())); // of any place
    for (Local i = 0; i < w.rows; ++i) {
      const Local first = w.offset(i), last = w.offset(i + 1);
      for (Local k = first; k < last; ++k)
        sum[std::size_t(w.column(k))] = 0.0F; // what else the row reaches is not read
      for (Local k = first; k < last; ++k) {
        const float share = w.value(k);
        const Local end = all.offset(w.column(k) + 1);
        for (Local e = all.offset(w.column(k)); e < end; ++e)
          sum[std::size_t(all.column(e))] += share * all.value(e);
      }
      for (Local k = first; k < last; ++k)
        result.value(k) = sum[std::size_t(w.column(k))];
    }
    return result;
  }

  std::vector<float> remains(const Scalars& w) const {
    std::vector<float> diagonal(static_cast<std::size_t>(rows_.size()), 0.0F);
    for (Local i = 0; i < w.rows; ++i)
      for (Local k = w.offset(i); k < w.offset(i + 1); ++k)
        if (w.column(k) == i)
          diagonal[std::size_t(i)] = w.value(k);
    return diagonal;
  }

  static float distance(float remains, float reached) {
    return remains > 0.0F && reached > 0.0F ? std::fabs(1.0F - remains / reached) : infinite;
  }
  /// From row i to the column of its entry k: D times a power of W is symmetric.
  float from_row(Local i, Local k) const {
    const float there = size_[std::size_t(spread_.column(k))];
    return there > 0.0F ? distance(remains_[std::size_t(i)],
                                   spread_.value(k) * size_[std::size_t(i)] / there)
                        : infinite;
  }
  /// From column j of entry k to the row.
  float from_column(Local j, Local k) const {
    return distance(remains_[std::size_t(j)], spread_.value(k));
  }

  template <class F> void for_couplings(const F& f) const {
    for (Local i = 0; i < spread_.rows; ++i)
      for (Local k = spread_.offset(i); k < spread_.offset(i + 1); ++k)
        if (spread_.column(k) != i)
          f(i, spread_.column(k), k);
  }

  const Distribution& rows_;
  std::vector<float> size_;    ///< (rows with ghosts) D
  std::vector<float> remains_; ///< (rows with ghosts) diagonal of the power of W
  Scalars spread_;             ///< the power of W
};

} // namespace

std::vector<char> evolution_strength(const BlockMatrix<float, 1, 1>& energies,
                                     const Distribution& rows, double drop_tolerance) {
  return Evolution(energies, rows).strong(drop_tolerance);
}

} // namespace abut::multigrid
