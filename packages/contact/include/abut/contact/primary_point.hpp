// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"

/// The primary surface at an integration point, and tractions that turn with it.
namespace abut::contact {

/// Shape functions of a primary face at one of its points.
struct PointShape {
  int nodes = 0;
  const double* N = nullptr;       ///< (nodes)
  const double (*dN)[2] = nullptr; ///< (nodes, 2)
};

template <class T> struct PrimaryPoint {
  Vec<T, 3> x;          ///< [length]
  Vec<T, 3> tangent[2]; ///< g_1, g_2
  Vec<T, 3> normal;     ///< unit, out of the body
  T area;               ///< |g_1 x g_2|
};

/// x: (nodes) positions of the face's nodes.
template <class T>
KOKKOS_INLINE_FUNCTION PrimaryPoint<T> primary_point(const PointShape& shape, const Vec<T, 3>* x) {
  PrimaryPoint<T> p;
  p.x = p.tangent[0] = p.tangent[1] = Vec<T, 3>::zero();
  for (int a = 0; a < shape.nodes; ++a) {
    p.x += shape.N[a] * x[a];
    p.tangent[0] += shape.dN[a][0] * x[a];
    p.tangent[1] += shape.dN[a][1] * x[a];
  }
  const Vec<T, 3> area = cross(p.tangent[0], p.tangent[1]);
  p.area = norm(area);
  p.normal = (T(1.0) / p.area) * area;
  return p;
}

/// Contravariant basis g^1, g^2 of a surface with tangents g and unit normal n.
template <class T>
KOKKOS_INLINE_FUNCTION void contravariant(const PrimaryPoint<T>& p, Vec<T, 3> dual[2]) {
  dual[0] = (T(1.0) / p.area) * cross(p.tangent[1], p.normal);
  dual[1] = (T(1.0) / p.area) * cross(p.normal, p.tangent[0]);
}

/// A traction kept on axes that follow the primary surface: the rotation of the surface gradient's
/// polar decomposition, whatever the numbering of the face's nodes.
struct StoredTraction {
  double component[3] = {0.0, 0.0, 0.0};         ///< along E_1, E_2 and the normal [pressure]
  double frame[2][2] = {{0.0, 0.0}, {0.0, 0.0}}; ///< A_ia = E_i . G^a when stored [1/length]
};

inline KOKKOS_FUNCTION StoredTraction store_traction(const PrimaryPoint<double>& p,
                                                     const Vec3& traction) {
  const Vec3 e1 = (1.0 / norm(p.tangent[0])) * p.tangent[0];
  const Vec3 e[2] = {e1, cross(p.normal, e1)};
  Vec3 dual[2];
  contravariant(p, dual);
  StoredTraction s;
  for (int i = 0; i < 2; ++i) {
    s.component[i] = dot(e[i], traction);
    for (int a = 0; a < 2; ++a)
      s.frame[i][a] = dot(e[i], dual[a]);
  }
  s.component[2] = dot(p.normal, traction);
  return s;
}

/// The axes E_1, E_2 of a stored traction in the present configuration.
template <class T>
KOKKOS_INLINE_FUNCTION void turned_axes(const StoredTraction& s, const PrimaryPoint<T>& p,
                                        Vec<T, 3> e[2]) {
  const Vec<T, 3> f1 = s.frame[0][0] * p.tangent[0] + s.frame[0][1] * p.tangent[1];
  const Vec<T, 3> f2 = s.frame[1][0] * p.tangent[0] + s.frame[1][1] * p.tangent[1];
  const Vec<T, 3> q = f1 - cross(p.normal, f2);
  e[0] = (T(1.0) / norm(q)) * q;
  e[1] = cross(p.normal, e[0]);
}

/// The stored traction in the present configuration; zero when nothing was stored.
template <class T>
KOKKOS_INLINE_FUNCTION Vec<T, 3> turned_traction(const StoredTraction& s,
                                                 const PrimaryPoint<T>& p) {
  if (s.component[0] == 0.0 && s.component[1] == 0.0 && s.component[2] == 0.0)
    return Vec<T, 3>::zero();
  Vec<T, 3> e[2];
  turned_axes(s, p, e);
  return s.component[0] * e[0] + s.component[1] * e[1] + s.component[2] * p.normal;
}

} // namespace abut::contact
