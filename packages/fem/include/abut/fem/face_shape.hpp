// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"

#include <Kokkos_Macros.hpp>
#include <utility>

/// Lagrange and serendipity shape functions of faces as point functions on any scalar T.
///
/// Parameters xi = (xi, eta): quads in [-1, 1]^2; triangles in {xi, eta >= 0, xi + eta <= 1}.
/// Nodes: corners, then the middles of the edges (0-1, 1-2, ...), then the centre. The tangents
/// x,xi and x,eta of a cell's side have x,xi cross x,eta pointing out of the cell.
namespace abut::fem {

constexpr int face_dim = 2; ///< parameters of a face

/// values:             N[nodes]
/// derivatives:        dN[nodes][2], by xi and eta
/// second_derivatives: d2N[nodes][3], by xi xi, eta eta, xi eta
/// node:               parameters of a node
/// center:             parameters of the middle of the reference face
/// inside:             whether xi lies in the reference face enlarged by tolerance (in xi units)
template <FaceType F> struct FaceShape;

/// What all quads share.
struct QuadDomain {
  static constexpr int corners = 4;
  static constexpr bool triangle = false;

  KOKKOS_INLINE_FUNCTION static void node(int a, double xi[2]) {
    constexpr double table[9][2] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                    {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
    xi[0] = table[a][0];
    xi[1] = table[a][1];
  }
  KOKKOS_INLINE_FUNCTION static void center(double xi[2]) { xi[0] = xi[1] = 0.0; }
  template <class T> KOKKOS_INLINE_FUNCTION static bool inside(const T xi[2], double tolerance) {
    const double limit = 1.0 + tolerance;
    return xi[0] >= -limit && xi[0] <= limit && xi[1] >= -limit && xi[1] <= limit;
  }
};

/// What all triangles share.
struct TriangleDomain {
  static constexpr int corners = 3;
  static constexpr bool triangle = true;

  KOKKOS_INLINE_FUNCTION static void node(int a, double xi[2]) {
    constexpr double table[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    xi[0] = table[a][0];
    xi[1] = table[a][1];
  }
  KOKKOS_INLINE_FUNCTION static void center(double xi[2]) { xi[0] = xi[1] = 1.0 / 3.0; }
  template <class T> KOKKOS_INLINE_FUNCTION static bool inside(const T xi[2], double tolerance) {
    return xi[0] >= -tolerance && xi[1] >= -tolerance && xi[0] + xi[1] <= 1.0 + tolerance;
  }
};

template <> struct FaceShape<FaceType::quad4> : QuadDomain {
  static constexpr FaceType type = FaceType::quad4;
  static constexpr int nodes = 4;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[2], T* N) {
    const T xm = 1.0 - xi[0], xp = 1.0 + xi[0], ym = 1.0 - xi[1], yp = 1.0 + xi[1];
    N[0] = 0.25 * xm * ym;
    N[1] = 0.25 * xp * ym;
    N[2] = 0.25 * xp * yp;
    N[3] = 0.25 * xm * yp;
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[2], T (*dN)[2]) {
    const T xm = 1.0 - xi[0], xp = 1.0 + xi[0], ym = 1.0 - xi[1], yp = 1.0 + xi[1];
    dN[0][0] = -0.25 * ym;
    dN[1][0] = 0.25 * ym;
    dN[2][0] = 0.25 * yp;
    dN[3][0] = -0.25 * yp;
    dN[0][1] = -0.25 * xm;
    dN[1][1] = -0.25 * xp;
    dN[2][1] = 0.25 * xp;
    dN[3][1] = 0.25 * xm;
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void second_derivatives(const T[2], T (*d2N)[3]) {
    constexpr double mixed[4] = {0.25, -0.25, 0.25, -0.25};
    for (int a = 0; a < 4; ++a) {
      d2N[a][0] = T(0.0);
      d2N[a][1] = T(0.0);
      d2N[a][2] = T(mixed[a]);
    }
  }
};

/// Serendipity: with s = xi xi_a and t = eta eta_a,
/// corners (1+s)(1+t)(s+t-1)/4, middles (1-xi^2)(1+t)/2 and (1+s)(1-eta^2)/2.
template <> struct FaceShape<FaceType::quad8> : QuadDomain {
  static constexpr FaceType type = FaceType::quad8;
  static constexpr int nodes = 8;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[2], T* N) {
    for (int a = 0; a < nodes; ++a) {
      double p[2];
      node(a, p);
      const T s = xi[0] * p[0], t = xi[1] * p[1];
      if (a < 4)
        N[a] = 0.25 * (1.0 + s) * (1.0 + t) * (s + t - 1.0);
      else if (p[0] == 0.0)
        N[a] = 0.5 * (1.0 - xi[0] * xi[0]) * (1.0 + t);
      else
        N[a] = 0.5 * (1.0 + s) * (1.0 - xi[1] * xi[1]);
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[2], T (*dN)[2]) {
    for (int a = 0; a < nodes; ++a) {
      double p[2];
      node(a, p);
      const T s = xi[0] * p[0], t = xi[1] * p[1];
      if (a < 4) {
        dN[a][0] = 0.25 * p[0] * (1.0 + t) * (2.0 * s + t);
        dN[a][1] = 0.25 * p[1] * (1.0 + s) * (2.0 * t + s);
      } else if (p[0] == 0.0) {
        dN[a][0] = -xi[0] * (1.0 + t);
        dN[a][1] = 0.5 * p[1] * (1.0 - xi[0] * xi[0]);
      } else {
        dN[a][0] = 0.5 * p[0] * (1.0 - xi[1] * xi[1]);
        dN[a][1] = -xi[1] * (1.0 + s);
      }
    }
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void second_derivatives(const T xi[2], T (*d2N)[3]) {
    for (int a = 0; a < nodes; ++a) {
      double p[2];
      node(a, p);
      const T s = xi[0] * p[0], t = xi[1] * p[1];
      if (a < 4) {
        d2N[a][0] = 0.5 * (1.0 + t);
        d2N[a][1] = 0.5 * (1.0 + s);
        d2N[a][2] = 0.25 * p[0] * p[1] * (1.0 + 2.0 * s + 2.0 * t);
      } else if (p[0] == 0.0) {
        d2N[a][0] = -(1.0 + t);
        d2N[a][1] = T(0.0);
        d2N[a][2] = -p[1] * xi[0];
      } else {
        d2N[a][0] = T(0.0);
        d2N[a][1] = -(1.0 + s);
        d2N[a][2] = -p[0] * xi[1];
      }
    }
  }
};

/// Tensor product of the quadratic Lagrange functions.
template <> struct FaceShape<FaceType::quad9> : QuadDomain {
  static constexpr FaceType type = FaceType::quad9;
  static constexpr int nodes = 9;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[2], T* N) {
    T l[2][3];
    line(xi, l);
    for (int a = 0; a < nodes; ++a)
      N[a] = l[0][index(a, 0)] * l[1][index(a, 1)];
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[2], T (*dN)[2]) {
    T l[2][3], d[2][3];
    line(xi, l);
    line_derivatives(xi, d);
    for (int a = 0; a < nodes; ++a) {
      dN[a][0] = d[0][index(a, 0)] * l[1][index(a, 1)];
      dN[a][1] = l[0][index(a, 0)] * d[1][index(a, 1)];
    }
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void second_derivatives(const T xi[2], T (*d2N)[3]) {
    constexpr double curvature[3] = {1.0, -2.0, 1.0};
    T l[2][3], d[2][3];
    line(xi, l);
    line_derivatives(xi, d);
    for (int a = 0; a < nodes; ++a) {
      const int i = index(a, 0), j = index(a, 1);
      d2N[a][0] = curvature[i] * l[1][j];
      d2N[a][1] = curvature[j] * l[0][i];
      d2N[a][2] = d[0][i] * d[1][j];
    }
  }

private:
  /// Which of the points -1, 0, 1 the node has in a direction.
  KOKKOS_INLINE_FUNCTION static int index(int a, int direction) {
    double p[2];
    node(a, p);
    return static_cast<int>(p[direction]) + 1;
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void line(const T xi[2], T (*l)[3]) {
    for (int i = 0; i < 2; ++i) {
      l[i][0] = 0.5 * xi[i] * (xi[i] - 1.0);
      l[i][1] = 1.0 - xi[i] * xi[i];
      l[i][2] = 0.5 * xi[i] * (xi[i] + 1.0);
    }
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void line_derivatives(const T xi[2], T (*d)[3]) {
    for (int i = 0; i < 2; ++i) {
      d[i][0] = xi[i] - 0.5;
      d[i][1] = -2.0 * xi[i];
      d[i][2] = xi[i] + 0.5;
    }
  }
};

template <> struct FaceShape<FaceType::tri3> : TriangleDomain {
  static constexpr FaceType type = FaceType::tri3;
  static constexpr int nodes = 3;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[2], T* N) {
    N[0] = 1.0 - xi[0] - xi[1];
    N[1] = xi[0];
    N[2] = xi[1];
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T[2], T (*dN)[2]) {
    constexpr double d[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 2; ++i)
        dN[a][i] = T(d[a][i]);
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void second_derivatives(const T[2], T (*d2N)[3]) {
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 3; ++i)
        d2N[a][i] = T(0.0);
  }
};

/// With the area coordinates l0 = 1-xi-eta, l1 = xi, l2 = eta: l(2l-1) and 4 l l'.
template <> struct FaceShape<FaceType::tri6> : TriangleDomain {
  static constexpr FaceType type = FaceType::tri6;
  static constexpr int nodes = 6;

  template <class T> KOKKOS_INLINE_FUNCTION static void values(const T xi[2], T* N) {
    const T l0 = 1.0 - xi[0] - xi[1], l1 = xi[0], l2 = xi[1];
    N[0] = l0 * (2.0 * l0 - 1.0);
    N[1] = l1 * (2.0 * l1 - 1.0);
    N[2] = l2 * (2.0 * l2 - 1.0);
    N[3] = 4.0 * l0 * l1;
    N[4] = 4.0 * l1 * l2;
    N[5] = 4.0 * l2 * l0;
  }
  template <class T> KOKKOS_INLINE_FUNCTION static void derivatives(const T xi[2], T (*dN)[2]) {
    const T l0 = 1.0 - xi[0] - xi[1], l1 = xi[0], l2 = xi[1];
    dN[0][0] = dN[0][1] = 1.0 - 4.0 * l0;
    dN[1][0] = 4.0 * l1 - 1.0;
    dN[1][1] = T(0.0);
    dN[2][0] = T(0.0);
    dN[2][1] = 4.0 * l2 - 1.0;
    dN[3][0] = 4.0 * (l0 - l1);
    dN[3][1] = -4.0 * l1;
    dN[4][0] = 4.0 * l2;
    dN[4][1] = 4.0 * l1;
    dN[5][0] = -4.0 * l2;
    dN[5][1] = 4.0 * (l0 - l2);
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void second_derivatives(const T[2], T (*d2N)[3]) {
    constexpr double d[6][3] = {{4, 4, 4},   {4, 0, 0}, {0, 4, 0},
                                {-8, 0, -4}, {0, 0, 4}, {0, -8, -4}};
    for (int a = 0; a < 6; ++a)
      for (int i = 0; i < 3; ++i)
        d2N[a][i] = T(d[a][i]);
  }
};

/// Calls f(FaceShape<F>{}) with the F that `type` names and returns what it returns.
template <class Function>
KOKKOS_INLINE_FUNCTION decltype(auto) dispatch_face(FaceType type, Function&& f) {
  switch (type) {
  case FaceType::quad8:
    return f(FaceShape<FaceType::quad8>{});
  case FaceType::quad9:
    return f(FaceShape<FaceType::quad9>{});
  case FaceType::tri3:
    return f(FaceShape<FaceType::tri3>{});
  case FaceType::tri6:
    return f(FaceShape<FaceType::tri6>{});
  default:
    return f(FaceShape<FaceType::quad4>{});
  }
}

} // namespace abut::fem
