// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/face_shape.hpp"
#include "abut/fem/quadrature.hpp"

/// One loaded face: from nodal coordinates to nodal forces and their derivative.
namespace abut::solid {

/// Shape functions of a face at points that integrate pressure on a deformed face exactly.
template <fem::FaceType F> struct ReferenceFace {
  static constexpr int nodes = fem::FaceShape<F>::nodes;
  static constexpr int points = F == fem::FaceType::quad4  ? 4
                                : F == fem::FaceType::tri3 ? 3
                                : F == fem::FaceType::tri6 ? 6
                                                           : 9;
  double weight[points];
  double N[points][nodes];
  double dN[points][nodes][2];

  ReferenceFace() {
    const fem::Rule<2> rule = fem::face_rule(F, fem::default_points(F));
    for (int p = 0; p < points; ++p) {
      weight[p] = rule.weight[p];
      fem::FaceShape<F>::values(rule.xi[p].data(), N[p]);
      fem::FaceShape<F>::derivatives(rule.xi[p].data(), dN[p]);
    }
  }
};

/// The one table of a face type (host).
template <fem::FaceType F> const ReferenceFace<F>& reference_face() {
  static const ReferenceFace<F> face;
  return face;
}

/// The tables of all face types, for loops over mixed ones: a base for each.
struct ReferenceFaces : ReferenceFace<fem::FaceType::quad4>,
                        ReferenceFace<fem::FaceType::quad8>,
                        ReferenceFace<fem::FaceType::quad9>,
                        ReferenceFace<fem::FaceType::tri3>,
                        ReferenceFace<fem::FaceType::tri6> {};

/// Tangents x,xi and x,eta of a face with nodes x at point p.
template <fem::FaceType F, class T>
KOKKOS_INLINE_FUNCTION void face_tangents(const ReferenceFace<F>& face, int p, const Vec<T, 3>* x,
                                          Vec<T, 3>& t1, Vec<T, 3>& t2) {
  t1 = t2 = Vec<T, 3>::zero();
  for (int a = 0; a < ReferenceFace<F>::nodes; ++a)
    for (int i = 0; i < 3; ++i) {
      t1[i] += face.dN[p][a][0] * x[a][i];
      t2[i] += face.dN[p][a][1] * x[a][i];
    }
}

/// Residual r_a = int p N_a n da of a pressure (points) p >= 0 that pushes against the outward
/// normal n of the current face x.
template <fem::FaceType F, class T>
KOKKOS_INLINE_FUNCTION void pressure_residual(const ReferenceFace<F>& face, const double* pressure,
                                              const Vec<T, 3>* x, Vec<T, 3>* r) {
  constexpr int n = ReferenceFace<F>::nodes;
  for (int a = 0; a < n; ++a)
    r[a] = Vec<T, 3>::zero();
  for (int p = 0; p < ReferenceFace<F>::points; ++p) {
    Vec<T, 3> t1, t2;
    face_tangents(face, p, x, t1, t2);
    const Vec<T, 3> normal = cross(t1, t2);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        r[a][i] += face.weight[p] * pressure[p] * face.N[p][a] * normal[i];
  }
}

/// Residual r_a = -int t N_a da of a traction (points) per area of the current face x.
template <fem::FaceType F, class T>
KOKKOS_INLINE_FUNCTION void traction_residual(const ReferenceFace<F>& face, const Vec3* traction,
                                              const Vec<T, 3>* x, Vec<T, 3>* r) {
  constexpr int n = ReferenceFace<F>::nodes;
  for (int a = 0; a < n; ++a)
    r[a] = Vec<T, 3>::zero();
  for (int p = 0; p < ReferenceFace<F>::points; ++p) {
    Vec<T, 3> t1, t2;
    face_tangents(face, p, x, t1, t2);
    const T area = face.weight[p] * norm(cross(t1, t2));
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        r[a][i] -= face.N[p][a] * traction[p][i] * area;
  }
}

/// Derivative k (3n, 3n) of traction_residual, node first, row by row; not symmetric:
/// k_ab = -int N_a t (N_b,xi x,eta x n + N_b,eta n x x,xi) dxi deta with the unit normal n.
template <fem::FaceType F>
KOKKOS_INLINE_FUNCTION void traction_tangent(const ReferenceFace<F>& face, const Vec3* traction,
                                             const Vec3* x, double* k) {
  constexpr int n = ReferenceFace<F>::nodes;
  for (int i = 0; i < 9 * n * n; ++i)
    k[i] = 0.0;
  for (int p = 0; p < ReferenceFace<F>::points; ++p) {
    Vec3 t1, t2;
    face_tangents(face, p, x, t1, t2);
    const Vec3 c = cross(t1, t2), normal = (1.0 / norm(c)) * c;
    const Vec3 by_xi = cross(t2, normal), by_eta = cross(normal, t1);
    for (int b = 0; b < n; ++b) {
      const Vec3 stretch = face.dN[p][b][0] * by_xi + face.dN[p][b][1] * by_eta;
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            k[(3 * a + i) * 3 * n + 3 * b + j] -=
                face.weight[p] * face.N[p][a] * traction[p][i] * stretch[j];
    }
  }
}

/// Derivative k (3n, 3n) of pressure_residual, node first, row by row; not symmetric:
/// k_ab = int p N_a (N_b,eta [x,xi]x - N_b,xi [x,eta]x) dxi deta with [v]x w = v x w.
template <fem::FaceType F>
KOKKOS_INLINE_FUNCTION void pressure_tangent(const ReferenceFace<F>& face, const double* pressure,
                                             const Vec3* x, double* k) {
  constexpr int n = ReferenceFace<F>::nodes;
  for (int i = 0; i < 9 * n * n; ++i)
    k[i] = 0.0;
  for (int p = 0; p < ReferenceFace<F>::points; ++p) {
    Vec3 t1, t2;
    face_tangents(face, p, x, t1, t2);
    for (int a = 0; a < n; ++a) {
      const double scale = face.weight[p] * pressure[p] * face.N[p][a];
      for (int b = 0; b < n; ++b) {
        Vec3 v; // axial vector of the skew block
        for (int i = 0; i < 3; ++i)
          v[i] = scale * (face.dN[p][b][1] * t1[i] - face.dN[p][b][0] * t2[i]);
        double* out = k + (3 * a) * (3 * n) + 3 * b;
        for (int i = 0; i < 3; ++i) {
          const int j = (i + 1) % 3, l = (i + 2) % 3;
          out[i * 3 * n + j] -= v[l];
          out[i * 3 * n + l] += v[j];
        }
      }
    }
  }
}

} // namespace abut::solid
