// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/face_map.hpp"

/// Point physics of facet-on-facet contact: closest-point gap with the secondary normal.
///
/// Signs: gap g > 0 open; the theory text (eq. 564-594) writes g > 0 for penetration, so its g is
/// minus the gap here. The contact pressure t = <lambda - eps gap> >= 0 per reference primary area.
namespace abut::contact {

/// What a point and its projection on a secondary face define.
template <class T> struct FacetGap {
  T gap;                ///< [length]
  Vec<T, 3> normal;     ///< outward normal of the secondary face
  Vec<T, 3> tangent[2]; ///< secondary tangents at the projection
  T N[fem::max_face_nodes];
  T dN[fem::max_face_nodes][2];
  T metric[2][2];    ///< m_ab = y,a . y,b
  T curvature[2][2]; ///< kappa_ab = normal . y,ab (negative on a convex body)
};

/// Gap of the point x to the secondary face with nodes y, at its projection xi.
template <class T, class S>
KOKKOS_INLINE_FUNCTION FacetGap<T> facet_gap(fem::FaceType type, const Vec<S, 3>* y,
                                             const Vec<T, 3>& x, const T xi[2]) {
  fem::FacePoint<T> p;
  fem::face_point(type, y, xi, p);
  FacetGap<T> q;
  const Vec<T, 3> area = cross(p.tangent[0], p.tangent[1]);
  q.normal = (T(1.0) / norm(area)) * area;
  q.gap = dot(q.normal, x - p.x);
  for (int a = 0; a < fem::face_nodes(type); ++a) {
    q.N[a] = p.N[a];
    q.dN[a][0] = p.dN[a][0];
    q.dN[a][1] = p.dN[a][1];
  }
  q.tangent[0] = p.tangent[0];
  q.tangent[1] = p.tangent[1];
  q.metric[0][0] = dot(p.tangent[0], p.tangent[0]);
  q.metric[1][1] = dot(p.tangent[1], p.tangent[1]);
  q.metric[0][1] = q.metric[1][0] = dot(p.tangent[0], p.tangent[1]);
  q.curvature[0][0] = dot(q.normal, p.second[0]);
  q.curvature[1][1] = dot(q.normal, p.second[1]);
  q.curvature[0][1] = q.curvature[1][0] = dot(q.normal, p.second[2]);
  return q;
}

/// Tangent of a pressed point without friction, with all metric and curvature terms (eq. 586 with
/// the omitted kappa_11, kappa_22): symmetric, exact for interior projections.
///   K_pq = w { B_p B_q S + t [ B_p r_q (x) n + B_q n (x) r_p + gap G_pq n (x) n ] }
///   S = eps n (x) n + t q^ab y,a (x) y,b,   q = m^-1 kappa A^-1,   A = m - gap kappa
///   r_b = (A^-1)^ab N_b,b y,a and G_bd = (A^-1)^ab N_b,a N_d,b on secondary nodes, zero on
///   primary.
/// k is (n1+n2)*3 square, row by row; the block is added. Returns false, adding nothing, when A is
/// singular: the point lies at the centre of curvature of the secondary face.
inline KOKKOS_FUNCTION bool facet_tangent(int n1, const double* N1, int n2,
                                          const FacetGap<double>& q, double weight, double penalty,
                                          double pressure, double* k) {
  const double A[2][2] = {
      {q.metric[0][0] - q.gap * q.curvature[0][0], q.metric[0][1] - q.gap * q.curvature[0][1]},
      {q.metric[0][1] - q.gap * q.curvature[0][1], q.metric[1][1] - q.gap * q.curvature[1][1]}};
  const double det_m = q.metric[0][0] * q.metric[1][1] - q.metric[0][1] * q.metric[0][1];
  const double det_a = A[0][0] * A[1][1] - A[0][1] * A[0][1];
  if (det_a < 1e-6 * det_m)
    return false;
  const Mat<double, 2> a = {
      {{A[1][1] / det_a, -A[0][1] / det_a}, {-A[0][1] / det_a, A[0][0] / det_a}}};
  const Mat<double, 2> m = {{{q.metric[1][1] / det_m, -q.metric[0][1] / det_m},
                             {-q.metric[0][1] / det_m, q.metric[0][0] / det_m}}};
  const Mat<double, 2> kappa = {
      {{q.curvature[0][0], q.curvature[0][1]}, {q.curvature[0][1], q.curvature[1][1]}}};
  const Mat<double, 2> c = m * kappa * a;
  double S[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      S[i][j] = penalty * q.normal[i] * q.normal[j];
      for (int s = 0; s < 2; ++s)
        for (int t = 0; t < 2; ++t)
          S[i][j] += pressure * c[s][t] * q.tangent[s][i] * q.tangent[t][j];
    }
  constexpr int max_nodes = 2 * fem::max_face_nodes;
  double B[max_nodes], d[max_nodes][2];
  Vec3 r[max_nodes];
  const int n = n1 + n2;
  for (int p = 0; p < n; ++p) {
    B[p] = p < n1 ? N1[p] : -q.N[p - n1];
    r[p] = Vec3::zero();
    d[p][0] = d[p][1] = 0.0;
    if (p < n1)
      continue;
    for (int s = 0; s < 2; ++s) {
      d[p][s] = a[s][0] * q.dN[p - n1][0] + a[s][1] * q.dN[p - n1][1];
      r[p] += d[p][s] * q.tangent[s];
    }
  }
  for (int p = 0; p < n; ++p)
    for (int s = 0; s < n; ++s) {
      const double bb = weight * B[p] * B[s];
      double g = 0.0;
      if (p >= n1 && s >= n1)
        g = q.gap * (d[p][0] * q.dN[s - n1][0] + d[p][1] * q.dN[s - n1][1]);
      const double wt = weight * pressure;
      for (int i = 0; i < 3; ++i) {
        double* row = k + (3 * p + i) * 3 * n + 3 * s;
        for (int j = 0; j < 3; ++j)
          row[j] +=
              bb * S[i][j] + wt * (B[p] * r[s][i] * q.normal[j] + B[s] * q.normal[i] * r[p][j] +
                                   g * q.normal[i] * q.normal[j]);
      }
    }
  return true;
}

} // namespace abut::contact
