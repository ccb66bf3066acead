// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/graded_axis.hpp"

#include "abut/core/error.hpp"
#include "structured.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::meshgen {

namespace {

constexpr int most_cells = 10000;
constexpr const char* too_many = "a graded mesh would have more than 10000 cells in one direction: "
                                 "let it be coarser or grow faster";

/// Sizes of `count` cells after the core.
std::vector<double> tail(double ratio, int count, double size, double limit) {
  std::vector<double> cells;
  for (int i = 0; i < count; ++i)
    cells.push_back(size = std::min(size * ratio, limit));
  return cells;
}

double total(const std::vector<double>& cells) {
  double sum = 0.0;
  for (double c : cells)
    sum += c;
  return sum;
}

} // namespace

std::vector<double> graded_axis(double length, const Grading& g) {
  if (!(length > 0.0) || !(g.size > 0.0) || g.core < 0.0)
    throw InputError("a graded mesh needs a positive length and cell size");
  if (!(g.growth >= 1.0))
    throw InputError("growth must be at least 1");
  const double core = std::min(g.core, length);
  if (!(core / g.size < most_cells))
    throw InputError(too_many);
  const int core_cells = core > 0.0 ? std::max(1, int(std::lround(core / g.size))) : 0;
  const double h = core_cells > 0 ? core / core_cells : g.size;
  const double limit =
      g.max_size > 0.0 ? std::max(g.max_size, h) : std::numeric_limits<double>::infinity();

  std::vector<double> cells(static_cast<std::size_t>(core_cells), h);
  const double rest = length - core;
  if (rest > 1e-12 * length) {
    int count = 1;
    while (total(tail(g.growth, count, h, limit)) < rest * (1.0 - 1e-12))
      if (++count > most_cells)
        throw InputError(too_many);
    double low = 1.0, high = g.growth;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (total(tail(middle, count, h, limit)) < rest ? low : high) = middle;
    }
    std::vector<double> grown = tail(high, count, h, limit);
    // Removes the rounding of the bisection; more only when even equal cells are too long.
    const double scale = rest / total(grown);
    for (double c : grown)
      cells.push_back(c * scale);
  }

  std::vector<double> x{0.0};
  for (double c : cells)
    x.push_back(x.back() + c);
  x.back() = length;
  return x;
}

std::vector<double> uniform_axis(double first, double last, int cells) {
  if (cells < 1)
    throw InputError("a mesh needs at least one division in each direction");
  require_cells(cells);
  if (!(last > first))
    throw InputError("a mesh needs a positive size in each direction");
  std::vector<double> x(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i)
    x[i] = first + (last - first) * i / cells;
  x.back() = last;
  return x;
}

} // namespace abut::meshgen
