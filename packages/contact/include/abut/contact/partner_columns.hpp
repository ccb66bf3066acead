// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/point_force.hpp"

/// How the partner of a point moves with the nodes of the two faces, one row per column node: the
/// derivative of a scalar f by node q is the vector row f_q, D f = sum f_q . Du_q.
/// Column nodes: primary (n1), then those of the face (n2). docs/theory/friction.md derives it.
namespace abut::contact {

inline KOKKOS_FUNCTION void add_dyad(Mat3& m, const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m[i][j] += a[i] * b[j];
}

/// v . M, the row of a scalar product with a vector whose derivative is M.
inline KOKKOS_FUNCTION Vec3 row_times(const Vec3& v, const Mat3& m) {
  return {{v[0] * m[0][0] + v[1] * m[1][0] + v[2] * m[2][0],
           v[0] * m[0][1] + v[1] * m[1][1] + v[2] * m[2][1],
           v[0] * m[0][2] + v[1] * m[1][2] + v[2] * m[2][2]}};
}

/// The primary at the point with the surface gradients a_c of its shape functions:
/// D n = -sum a_c (n . Du_c), D J = J sum a_c . Du_c.
struct PrimaryColumns {
  PrimaryPoint<double> at;
  Vec3 gradient[fem::max_face_nodes]; ///< (n1) a_c [1/length]
};

inline KOKKOS_FUNCTION void primary_columns(const PointShape& shape, const Vec3* x,
                                            PrimaryColumns& p) {
  p.at = primary_point(shape, x);
  Vec3 dual[2];
  contravariant(p.at, dual);
  for (int a = 0; a < shape.nodes; ++a)
    p.gradient[a] = shape.dN[a][0] * dual[0] + shape.dN[a][1] * dual[1];
}

/// Derivatives of the partner: xi, gap and the contact normal, D c = -sum_alpha dual^alpha (x)
/// turn_alpha.
struct PartnerColumns {
  static constexpr int max_columns = 2 * fem::max_face_nodes;
  fem::FacePoint<double> face;
  Vec3 c;
  double gap;
  Vec3 dual[2]; ///< contravariant basis of the surface that c is normal to [1/length]
  Vec3 row_xi[2][max_columns];
  Vec3 row_gap[max_columns];
  Vec3 turn[2][max_columns];
};

/// Of the closest point: A_ab D xi^b = (Dx - Dx2) . g_a + gap c . N_b,a Du_b with A = m - gap kappa
/// and D c = -g^a (x) (c . N_b,a Du_b + kappa_ab D xi^b). False at a centre of curvature,
/// det A < 1e-6 det m.
inline KOKKOS_FUNCTION bool closest_columns(const ContactPoint& c, const PrimaryColumns& p,
                                            const Vec3* y, PartnerColumns& s) {
  fem::face_point(c.face, y, c.xi, s.face);
  const Vec3 &g1 = s.face.tangent[0], &g2 = s.face.tangent[1];
  const Vec3 area = cross(g1, g2);
  const double det_m = dot(area, area);
  s.c = (1.0 / std::sqrt(det_m)) * area;
  s.gap = dot(s.c, p.at.x - s.face.x);
  const double kappa[3] = {dot(s.c, s.face.second[0]), dot(s.c, s.face.second[1]),
                           dot(s.c, s.face.second[2])};
  const double m00 = dot(g1, g1), m11 = dot(g2, g2), m01 = dot(g1, g2);
  const double a00 = m00 - s.gap * kappa[0], a11 = m11 - s.gap * kappa[1],
               a01 = m01 - s.gap * kappa[2];
  const double det_a = a00 * a11 - a01 * a01;
  if (det_a < 1e-6 * det_m)
    return false;
  s.dual[0] = (1.0 / det_m) * (m11 * g1 - m01 * g2);
  s.dual[1] = (1.0 / det_m) * (m00 * g2 - m01 * g1);
  const double i00 = a11 / det_a, i11 = a00 / det_a, i01 = -a01 / det_a;
  const Vec3 d[2] = {i00 * g1 + i01 * g2, i01 * g1 + i11 * g2};
  const int n1 = c.shape.nodes, n = n1 + fem::face_nodes(c.face);
  for (int q = 0; q < n; ++q) {
    const bool primary = q < n1;
    const double B = primary ? c.shape.N[q] : -s.face.N[q - n1];
    const double N1 = primary ? 0.0 : s.face.dN[q - n1][0];
    const double N2 = primary ? 0.0 : s.face.dN[q - n1][1];
    s.row_gap[q] = B * s.c;
    s.row_xi[0][q] = B * d[0] + (s.gap * (i00 * N1 + i01 * N2)) * s.c;
    s.row_xi[1][q] = B * d[1] + (s.gap * (i01 * N1 + i11 * N2)) * s.c;
    s.turn[0][q] = N1 * s.c + kappa[0] * s.row_xi[0][q] + kappa[2] * s.row_xi[1][q];
    s.turn[1][q] = N2 * s.c + kappa[2] * s.row_xi[0][q] + kappa[1] * s.row_xi[1][q];
  }
  return true;
}

/// Solves g_a D xi^a - m Dq = R for a line of direction m that meets a face: D xi^a = xi[a] . R and
/// Dq = -distance . R.
struct LineSolver {
  Vec3 xi[2], distance;
};

/// False when the line is parallel to the face.
inline KOKKOS_FUNCTION bool line_solver(const fem::FacePoint<double>& face, const Vec3& m,
                                        LineSolver& line) {
  const Vec3 area = cross(face.tangent[0], face.tangent[1]);
  const double slope = dot(area, m);
  if (!(std::fabs(slope) > search::parallel_line * std::sqrt(dot(area, area) * dot(m, m))))
    return false;
  line.distance = (1.0 / slope) * area;
  line.xi[0] = (1.0 / slope) * cross(face.tangent[1], m);
  line.xi[1] = (1.0 / slope) * cross(m, face.tangent[0]);
  return true;
}

/// Of the ray along the primary normal. False when it is parallel to the face.
inline KOKKOS_FUNCTION bool ray_columns(const ContactPoint& c, const PrimaryColumns& p,
                                        const Vec3* y, PartnerColumns& s) {
  fem::face_point(c.face, y, c.xi, s.face);
  const Vec3& n = p.at.normal;
  s.c = -n;
  s.gap = dot(s.c, p.at.x - s.face.x);
  contravariant(p.at, s.dual);
  LineSolver line;
  if (!line_solver(s.face, s.c, line))
    return false;
  const int n1 = c.shape.nodes, n2 = fem::face_nodes(c.face);
  for (int a = 0; a < n1; ++a) {
    const auto row = [&](const Vec3& v) {
      return c.shape.N[a] * v - (s.gap * dot(v, p.gradient[a])) * n;
    };
    s.row_gap[a] = row(line.distance);
    for (int k = 0; k < 2; ++k) {
      s.row_xi[k][a] = row(line.xi[k]);
      s.turn[k][a] = c.shape.dN[a][k] * s.c;
    }
  }
  for (int b = 0; b < n2; ++b) {
    s.row_gap[n1 + b] = -s.face.N[b] * line.distance;
    for (int k = 0; k < 2; ++k) {
      s.row_xi[k][n1 + b] = -s.face.N[b] * line.xi[k];
      s.turn[k][n1 + b] = Vec3::zero();
    }
  }
  return true;
}

inline KOKKOS_FUNCTION bool partner_columns(const ContactPoint& c, const PrimaryColumns& p,
                                            const Vec3* y, PartnerColumns& s) {
  return c.ray ? ray_columns(c, p, y, s) : closest_columns(c, p, y, s);
}

} // namespace abut::contact
