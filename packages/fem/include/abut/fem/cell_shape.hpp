// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

#include <Kokkos_Macros.hpp>

/// Shape functions of cells as point functions on any scalar T.
///
/// Reference cells: bricks [-1, 1]^3; tetrahedra {x, y, z >= 0, x + y + z <= 1}; wedges the
/// triangle {x, y >= 0, x + y <= 1} times z in [-1, 1]. Nodes in Exodus II order.
namespace abut::fem {

constexpr int cell_dim = 3; ///< parameters of a cell

/// values:      N[nodes]
/// derivatives: dN[nodes][3]
/// node:        parameters of a node
template <CellType C> struct CellShape;

struct HexDomain {
  KOKKOS_INLINE_FUNCTION static void node(int a, double xi[3]) {
    constexpr double table[27][3] = {
        {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1},  {1, 1, 1},
        {-1, 1, 1},   {0, -1, -1}, {1, 0, -1}, {0, 1, -1},  {-1, 0, -1}, {-1, -1, 0}, {1, -1, 0},
        {1, 1, 0},    {-1, 1, 0},  {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1},  {0, 0, 0},
        {0, 0, -1},   {0, 0, 1},   {-1, 0, 0}, {1, 0, 0},   {0, -1, 0},  {0, 1, 0}};
    for (int i = 0; i < 3; ++i)
      xi[i] = table[a][i];
  }
};

struct TetDomain {
  KOKKOS_INLINE_FUNCTION static void node(int a, double xi[3]) {
    constexpr double h = 0.5;
    constexpr double table[10][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {h, 0, 0},
                                     {h, h, 0}, {0, h, 0}, {0, 0, h}, {h, 0, h}, {0, h, h}};
    for (int i = 0; i < 3; ++i)
      xi[i] = table[a][i];
  }
};

template <> struct CellShape<CellType::hex8> : HexDomain {
  static constexpr CellType type = CellType::hex8;
  static constexpr int nodes = 8;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    for (int a = 0; a < nodes; ++a) {
      double p[3];
      node(a, p);
      N[a] = 0.125 * (1.0 + p[0] * xi[0]) * (1.0 + p[1] * xi[1]) * (1.0 + p[2] * xi[2]);
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[3], T (*dN)[3]) {
    for (int a = 0; a < nodes; ++a) {
      double p[3];
      node(a, p);
      const T f0 = 1.0 + p[0] * xi[0], f1 = 1.0 + p[1] * xi[1], f2 = 1.0 + p[2] * xi[2];
      dN[a][0] = 0.125 * p[0] * f1 * f2;
      dN[a][1] = 0.125 * p[1] * f0 * f2;
      dN[a][2] = 0.125 * p[2] * f0 * f1;
    }
  }
};

/// Serendipity: with s_i = xi_i xi_i(a), corners prod(1+s_i) (sum s_i - 2)/8, middles of the edges
/// along j: (1 - xi_j^2) prod_{i != j} (1+s_i)/4.
template <> struct CellShape<CellType::hex20> : HexDomain {
  static constexpr CellType type = CellType::hex20;
  static constexpr int nodes = 20;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    for (int a = 0; a < nodes; ++a) {
      T f[3], s;
      const int along = factors(a, xi, f, s);
      N[a] = f[0] * f[1] * f[2] * (along < 0 ? T(0.125 * (s - 2.0)) : T(0.25));
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[3], T (*dN)[3]) {
    for (int a = 0; a < nodes; ++a) {
      double p[3];
      node(a, p);
      T f[3], s;
      const int along = factors(a, xi, f, s);
      for (int i = 0; i < 3; ++i) {
        const T others = f[(i + 1) % 3] * f[(i + 2) % 3];
        if (along < 0)
          dN[a][i] = 0.125 * p[i] * others * (s - 2.0 + f[i]);
        else
          dN[a][i] = 0.25 * others * (i == along ? T(-2.0 * xi[i]) : T(p[i]));
      }
    }
  }

private:
  /// The three factors and the sum of the s_i; returns the direction of the edge, -1 at corners.
  template <class T>
  KOKKOS_INLINE_FUNCTION static int factors(int a, const T xi[3], T f[3], T& sum) {
    double p[3];
    node(a, p);
    int along = -1;
    sum = T(0.0);
    for (int i = 0; i < 3; ++i) {
      sum += p[i] * xi[i];
      f[i] = 1.0 + p[i] * xi[i];
      if (p[i] == 0.0) {
        f[i] = 1.0 - xi[i] * xi[i];
        along = i;
      }
    }
    return along;
  }
};

/// Tensor product of the quadratic Lagrange functions.
template <> struct CellShape<CellType::hex27> : HexDomain {
  static constexpr CellType type = CellType::hex27;
  static constexpr int nodes = 27;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    for (int a = 0; a < nodes; ++a) {
      double p[3];
      node(a, p);
      N[a] = line(p[0], xi[0]) * line(p[1], xi[1]) * line(p[2], xi[2]);
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[3], T (*dN)[3]) {
    for (int a = 0; a < nodes; ++a) {
      double p[3];
      node(a, p);
      const T l0 = line(p[0], xi[0]), l1 = line(p[1], xi[1]), l2 = line(p[2], xi[2]);
      dN[a][0] = line_derivative(p[0], xi[0]) * l1 * l2;
      dN[a][1] = l0 * line_derivative(p[1], xi[1]) * l2;
      dN[a][2] = l0 * l1 * line_derivative(p[2], xi[2]);
    }
  }

private:
  template <class T> KOKKOS_INLINE_FUNCTION static T line(double p, const T& x) {
    return p == 0.0 ? T(1.0 - x * x) : T(0.5 * x * (x + p));
  }
  template <class T> KOKKOS_INLINE_FUNCTION static T line_derivative(double p, const T& x) {
    return p == 0.0 ? T(-2.0 * x) : T(x + 0.5 * p);
  }
};

template <> struct CellShape<CellType::tet4> : TetDomain {
  static constexpr CellType type = CellType::tet4;
  static constexpr int nodes = 4;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    N[0] = 1.0 - xi[0] - xi[1] - xi[2];
    for (int i = 0; i < 3; ++i)
      N[i + 1] = xi[i];
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T[3], T (*dN)[3]) {
    for (int i = 0; i < 3; ++i) {
      dN[0][i] = T(-1.0);
      for (int a = 1; a < 4; ++a)
        dN[a][i] = T(a == i + 1 ? 1.0 : 0.0);
    }
  }
};

/// With the volume coordinates l: l(2l-1) at corners, 4 l l' between them.
template <> struct CellShape<CellType::tet10> : TetDomain {
  static constexpr CellType type = CellType::tet10;
  static constexpr int nodes = 10;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    const T l[4] = {1.0 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
    for (int a = 0; a < 4; ++a)
      N[a] = l[a] * (2.0 * l[a] - 1.0);
    for (int e = 0; e < 6; ++e)
      N[4 + e] = 4.0 * l[end(e, 0)] * l[end(e, 1)];
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[3], T (*dN)[3]) {
    const T l[4] = {1.0 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
    for (int i = 0; i < 3; ++i) {
      const double d[4] = {-1.0, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
      for (int a = 0; a < 4; ++a)
        dN[a][i] = d[a] * (4.0 * l[a] - 1.0);
      for (int e = 0; e < 6; ++e) {
        const int p = end(e, 0), q = end(e, 1);
        dN[4 + e][i] = 4.0 * (d[p] * l[q] + d[q] * l[p]);
      }
    }
  }

private:
  KOKKOS_INLINE_FUNCTION static int end(int edge, int which) {
    constexpr int table[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    return table[edge][which];
  }
};

template <> struct CellShape<CellType::wedge6> {
  static constexpr CellType type = CellType::wedge6;
  static constexpr int nodes = 6;

  KOKKOS_INLINE_FUNCTION static void node(int a, double xi[3]) {
    xi[0] = a % 3 == 1 ? 1.0 : 0.0;
    xi[1] = a % 3 == 2 ? 1.0 : 0.0;
    xi[2] = a < 3 ? -1.0 : 1.0;
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[3], T* N) {
    const T l[3] = {1.0 - xi[0] - xi[1], xi[0], xi[1]};
    for (int a = 0; a < 3; ++a) {
      N[a] = 0.5 * l[a] * (1.0 - xi[2]);
      N[a + 3] = 0.5 * l[a] * (1.0 + xi[2]);
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[3], T (*dN)[3]) {
    constexpr double d[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    const T l[3] = {1.0 - xi[0] - xi[1], xi[0], xi[1]};
    for (int a = 0; a < 3; ++a) {
      for (int i = 0; i < 2; ++i) {
        dN[a][i] = 0.5 * d[a][i] * (1.0 - xi[2]);
        dN[a + 3][i] = 0.5 * d[a][i] * (1.0 + xi[2]);
      }
      dN[a][2] = -0.5 * l[a];
      dN[a + 3][2] = 0.5 * l[a];
    }
  }
};

/// Calls f(CellShape<C>{}) with the C that `type` names and returns what it returns.
template <class Function>
KOKKOS_INLINE_FUNCTION decltype(auto) dispatch_cell(CellType type, Function&& f) {
  switch (type) {
  case CellType::hex20:
    return f(CellShape<CellType::hex20>{});
  case CellType::hex27:
    return f(CellShape<CellType::hex27>{});
  case CellType::tet4:
    return f(CellShape<CellType::tet4>{});
  case CellType::tet10:
    return f(CellShape<CellType::tet10>{});
  case CellType::wedge6:
    return f(CellShape<CellType::wedge6>{});
  default:
    return f(CellShape<CellType::hex8>{});
  }
}

} // namespace abut::fem
