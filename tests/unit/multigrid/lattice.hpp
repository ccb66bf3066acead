// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/trilinos.hpp"
#include "abut/multigrid/near_null_space.hpp"

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace abut::test {

/// A block of n x n x m bricks (n x m rectangles in the plane) whose bottom is fixed: stiffness of
/// an elastic body, E = 1, Poisson's ratio given, with a field of heat beside it where there are
/// four unknowns, or of heat alone where there is one. Rows lie on the ranks slice by slice.
struct Lattice {
  int fields = 3;
  int n = 4, m = 4;
  double flatness = 1.0; ///< edges of the base over the height of a brick
  double growth = 1.0;   ///< of an edge over the one before it, in each direction
  double poisson = 0.3;
  bool mean_dilatation = false; ///< the volume of a brick changes by its mean alone
  double penalty = 0.0; ///< [1] over E: the layer in the middle is but springs along its height

  int dim() const { return fields == 2 ? 2 : 3; }
  Global nodes() const { return Global(n + 1) * (dim() == 3 ? n + 1 : 1) * (m + 1); }
  std::array<int, 3> place(Global node) const {
    const int base = n + 1, depth = dim() == 3 ? n + 1 : 1;
    return {int(node % base), int(node / base % depth), int(node / base / depth)};
  }
  bool fixed(Global node) const {
    return place(node)[2] == 0 || (penalty > 0.0 && place(node)[2] == m);
  }
  bool is_open(Global node) const { return penalty > 0.0 && place(node)[2] == m / 2; }
  std::array<double, 3> point(Global node) const {
    const auto p = place(node);
    if (dim() == 2)
      return {flatness * distance(p[0]), distance(p[2]), 0.0};
    return {flatness * distance(p[0]), flatness * distance(p[1]), distance(p[2])};
  }
  /// Edges of the brick above and behind a node.
  std::array<double, 3> edges(Global node) const {
    const auto p = place(node);
    const auto edge = [&](int at) { return std::pow(growth, at); };
    if (dim() == 2)
      return {flatness * edge(p[0]), edge(p[2]), 1.0};
    return {flatness * edge(p[0]), flatness * edge(p[1]), edge(p[2])};
  }

private:
  double distance(int edges) const {
    return growth == 1.0 ? edges : (std::pow(growth, edges) - 1.0) / (growth - 1.0);
  }
};

/// Gradients of the corners' shape functions at the Gauss points: (points, corners).
using Gradients = std::vector<std::vector<std::array<double, 3>>>;
inline Gradients brick_gradients(int dim, const std::array<double, 3>& edge) {
  const auto corners = std::size_t{1} << dim;
  const auto sign = [](std::size_t corner, int d) { return corner >> d & 1 ? 1.0 : -1.0; };
  Gradients gradient(corners, std::vector<std::array<double, 3>>(corners));
  for (std::size_t point = 0; point < corners; ++point)
    for (std::size_t a = 0; a < corners; ++a)
      for (int d = 0; d < dim; ++d) {
        double g = sign(a, d) / edge[std::size_t(d)];
        for (int e = 0; e < dim; ++e)
          if (e != d)
            g *= 0.5 * (1.0 + sign(a, e) * sign(point, e) / std::sqrt(3.0));
        gradient[point][a][std::size_t(d)] = g;
      }
  return gradient;
}

/// Their means over the brick, at each point.
inline Gradients mean_of(const Gradients& gradient) {
  std::vector<std::array<double, 3>> mean(gradient.size());
  for (const auto& point : gradient)
    for (std::size_t a = 0; a < mean.size(); ++a)
      for (std::size_t d = 0; d < 3; ++d)
        mean[a][d] += point[a][d] / double(gradient.size());
  return Gradients(gradient.size(), mean);
}

/// Stiffness of one brick by two Gauss points to an edge: (corners, fields, corners, fields).
inline std::vector<double> brick(const Lattice& lattice, const std::array<double, 3>& edge) {
  const int dim = lattice.dim(), corners = 1 << dim, f = lattice.fields;
  const double mu = 0.5 / (1.0 + lattice.poisson);
  const double lambda = 2.0 * mu * lattice.poisson / (1.0 - 2.0 * lattice.poisson);
  const Gradients gradient = brick_gradients(dim, edge);
  const Gradients volume = lattice.mean_dilatation ? mean_of(gradient) : gradient;
  double weight = 1.0;
  for (int d = 0; d < dim; ++d)
    weight *= 0.5 * edge[std::size_t(d)];
  std::vector<double> k(std::size_t(corners * f * corners * f), 0.0);
  for (std::size_t point = 0; point < gradient.size(); ++point)
    for (int a = 0; a < corners; ++a)
      for (int b = 0; b < corners; ++b) {
        const auto &ga = gradient[point][std::size_t(a)], &gb = gradient[point][std::size_t(b)];
        const auto &va = volume[point][std::size_t(a)], &vb = volume[point][std::size_t(b)];
        double dot = 0.0;
        for (int d = 0; d < dim; ++d)
          dot += ga[std::size_t(d)] * gb[std::size_t(d)];
        for (int i = 0; i < f; ++i)
          for (int j = 0; j < f; ++j) {
            double& entry = k[std::size_t(((a * f + i) * corners + b) * f + j)];
            const bool heat = f == 1 || i == 3 || j == 3;
            if (heat)
              entry += i == j ? weight * dot : 0.0;
            else
              entry += weight *
                       (lambda * va[std::size_t(i)] * vb[std::size_t(j)] +
                        mu * ga[std::size_t(j)] * gb[std::size_t(i)] + (i == j ? mu * dot : 0.0));
          }
      }
  return k;
}

/// Stiffness of the springs that stand for a brick, along the height of the corners' displacements.
inline std::vector<double> springs(const Lattice& lattice) {
  const int dim = lattice.dim(), corners = 1 << dim, f = lattice.fields, top = corners / 2;
  std::vector<double> k(std::size_t(corners * f * corners * f), 0.0);
  for (int a = 0; a < corners; ++a)
    for (const int b : {a, a ^ top})
      k[std::size_t(((a * f + dim - 1) * corners + b) * f + dim - 1)] =
          (a == b ? 1.0 : -1.0) * lattice.penalty / top;
  return k;
}

/// The matrix, with fixed rows and columns that hold only a unit diagonal. Collective.
inline RCP<Matrix> stiffness(const Comm& comm, const Lattice& lattice) {
  const int dim = lattice.dim(), corners = 1 << dim, f = lattice.fields;
  const Global slices = lattice.m + 1, slice = lattice.nodes() / slices;
  const Global first = slices * comm.rank() / comm.size() * slice;
  const Global last = slices * (comm.rank() + 1) / comm.size() * slice;
  const auto map = rcp(new Map(std::size_t(lattice.nodes() * f), std::size_t((last - first) * f), 0,
                               teuchos_comm(comm)));
  std::map<std::pair<Global, Global>, double> entry;
  for (Global node = 0; node < lattice.nodes(); ++node) {
    const auto p = lattice.place(node);
    if (p[0] == lattice.n || (dim == 3 && p[1] == lattice.n) || p[2] == lattice.m)
      continue;
    const auto k = lattice.is_open(node) ? springs(lattice) : brick(lattice, lattice.edges(node));
    const auto corner = [&](int a) {
      const int up = dim == 3 ? a >> 2 & 1 : a >> 1 & 1, across = dim == 3 ? a >> 1 & 1 : 0;
      return node + (a & 1) + Global(across) * (lattice.n + 1) + Global(up) * slice;
    };
    for (int a = 0; a < corners; ++a)
      for (int b = 0; b < corners; ++b) {
        const Global row = corner(a), column = corner(b);
        if (row < first || row >= last || lattice.fixed(row) || lattice.fixed(column))
          continue;
        for (int i = 0; i < f; ++i)
          for (int j = 0; j < f; ++j)
            entry[{row * f + i, column * f + j}] +=
                k[std::size_t(((a * f + i) * corners + b) * f + j)];
      }
  }
  for (Global row = first; row < last; ++row)
    for (int i = 0; i < f && lattice.fixed(row); ++i)
      entry[{row * f + i, row * f + i}] = 1.0;
  const auto matrix = rcp(new Matrix(map, std::size_t(27 * f)));
  for (const auto& [at, value] : entry)
    matrix->insertGlobalValues(at.first, Teuchos::tuple(at.second), Teuchos::tuple(value));
  matrix->fillComplete();
  return matrix;
}

/// Places of this rank's rows.
inline std::vector<multigrid::RowPlace> row_places(const Map& map, const Lattice& lattice) {
  std::vector<multigrid::RowPlace> places(local_size(map) / std::size_t(lattice.fields));
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i].point =
        lattice.point(map.getGlobalElement(Local(i) * lattice.fields) / lattice.fields);
  return places;
}

} // namespace abut::test
