// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/mass.hpp"

#include "abut/fem/cell_shape.hpp"
#include "abut/fem/quadrature.hpp"

#include <algorithm>

namespace abut::solid {

namespace {

/// Points per direction that integrate N_a N_b det J.
constexpr int mass_points(fem::CellType type) {
  return type == fem::CellType::hex20 || type == fem::CellType::hex27 ? 4
         : type == fem::CellType::tet4                                ? 2
                                                                      : 3;
}

/// visit(weight with volume, N) for the points of a cell with reference coordinates x (n,3).
template <fem::CellType C, class Visit>
void visit_mass_points(const double* x, const Visit& visit) {
  using Shape = fem::CellShape<C>;
  static const fem::Rule<3> rule = fem::cell_rule(C, mass_points(C));
  for (int p = 0; p < rule.size(); ++p) {
    double N[Shape::nodes], dN[Shape::nodes][3];
    Shape::values(rule.xi[p].data(), N);
    Shape::derivatives(rule.xi[p].data(), dN);
    Mat3 jacobian = Mat3::zero();
    for (int a = 0; a < Shape::nodes; ++a)
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          jacobian[i][k] += x[3 * a + i] * dN[a][k];
    visit(rule.weight[p] * det(jacobian), N);
  }
}

} // namespace

void element_mass(fem::CellType type, const double* x, double density, double* m) {
  fem::dispatch_cell(type, [&](auto shape) {
    constexpr int n = decltype(shape)::nodes;
    std::fill_n(m, mass_size(n), 0.0);
    visit_mass_points<decltype(shape)::type>(x, [&](double volume, const double* N) {
      for (int a = 0; a < n; ++a)
        for (int b = 0; b <= a; ++b)
          m[mass_index(a, b)] += density * volume * N[a] * N[b];
    });
  });
}

MassProperties mass_properties(const mesh::Mesh& mesh, const std::vector<int>& blocks,
                               double density) {
  double sums[10] = {}; // volume, int x, int x x^T (xx, yy, zz, xy, yz, zx)
  for (const int b : blocks) {
    const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(b)];
    fem::dispatch_cell(block.type, [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      for (Local e = 0; e < block.size(); ++e) {
        double nodes[3 * n];
        for (int a = 0; a < n; ++a)
          std::copy_n(&mesh.x[3 * std::size_t(block.nodes[std::size_t(e) * n + a])], 3,
                      &nodes[3 * a]);
        visit_mass_points<decltype(shape)::type>(nodes, [&](double volume, const double* N) {
          double x[3] = {};
          for (int a = 0; a < n; ++a)
            for (int i = 0; i < 3; ++i)
              x[i] += N[a] * nodes[3 * a + i];
          sums[0] += volume;
          for (int i = 0; i < 3; ++i) {
            sums[1 + i] += volume * x[i];
            sums[4 + i] += volume * x[i] * x[i];
            sums[7 + i] += volume * x[i] * x[(i + 1) % 3];
          }
        });
      }
    });
  }
  mesh.comm.sum(sums, 10);
  MassProperties result;
  result.mass = density * sums[0];
  if (!(sums[0] > 0.0))
    return result;
  Vec3& c = result.center;
  for (int i = 0; i < 3; ++i)
    c[i] = sums[1 + i] / sums[0];
  double second[3][3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    second[i][i] = density * sums[4 + i] - result.mass * c[i] * c[i];
    second[i][j] = second[j][i] = density * sums[7 + i] - result.mass * c[i] * c[j];
  }
  const double trace = second[0][0] + second[1][1] + second[2][2];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result.inertia[i][j] = (i == j ? trace : 0.0) - second[i][j];
  return result;
}

} // namespace abut::solid
