// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/partner_columns.hpp"

/// Derivatives of the trial tangential tractions, one 3x3 block per column node.
/// docs/theory/friction.md derives them.
namespace abut::contact {

/// Derivative of a vector that turns with the primary, D v_c = -(v_n a_c - (v_T . a_c) n) (x) n +
/// (n x v_T) (x) om_c with v_n = v . n and om_c the row of the rotation about n.
class TurnedColumns {
public:
  /// v: any vector with constant components on the turned axes of `stored` and the normal.
  KOKKOS_INLINE_FUNCTION TurnedColumns(const StoredTraction& stored, const PrimaryColumns& p,
                                       const Vec3& v)
      : p_(p), normal_part_(dot(p.at.normal, v)), tangential_(v - normal_part_ * p.at.normal),
        spin_(cross(p.at.normal, tangential_)) {
    const Vec3& n = p.at.normal;
    const Vec3 f1 = stored.frame[0][0] * p.at.tangent[0] + stored.frame[0][1] * p.at.tangent[1];
    const Vec3 f2 = stored.frame[1][0] * p.at.tangent[0] + stored.frame[1][1] * p.at.tangent[1];
    const Vec3 q = f1 - cross(n, f2);
    const double square = dot(q, q);
    const double scale = square > 0.0 ? 1.0 / square : 0.0; // nothing stored: v is along n
    const Vec3 e1 = scale * q, e2 = cross(n, e1);
    for (int a = 0; a < 2; ++a)
      turn_[a] = stored.frame[0][a] * e2 - stored.frame[1][a] * e1;
  }

  KOKKOS_INLINE_FUNCTION double normal_part() const { return normal_part_; }
  KOKKOS_INLINE_FUNCTION const Vec3& tangential() const { return tangential_; }

  /// Row om_c of primary node a.
  KOKKOS_INLINE_FUNCTION Vec3 turn(const PointShape& shape, int a) const {
    return shape.dN[a][0] * turn_[0] + shape.dN[a][1] * turn_[1];
  }

  /// Adds the block of primary node a.
  KOKKOS_INLINE_FUNCTION void add(const PointShape& shape, int a, Mat3& m) const {
    const Vec3 &n = p_.at.normal, &grad = p_.gradient[a];
    add_dyad(m, dot(tangential_, grad) * n - normal_part_ * grad, n);
    add_dyad(m, spin_, turn(shape, a));
  }

private:
  const PrimaryColumns& p_;
  double normal_part_;
  Vec3 tangential_, spin_, turn_[2];
};

/// Objective slip and its derivative: D r = moved_a D xi^a + slip^a N_d,a Du_d.
struct SlipColumns {
  Vec3 slip;
  double component[2]; ///< slip^a
  Vec3 moved[2];
};

inline KOKKOS_FUNCTION void objective_slip_columns(const ContactPoint& c, const PartnerColumns& s,
                                                   SlipColumns& r) {
  fem::FacePoint<double> then;
  fem::face_point(c.face, c.y_previous, c.xi, then);
  const PrimaryPoint<double> before = primary_point(c.shape, c.x_previous);
  const Vec3 d = then.x - before.x;
  const Vec3 &g1 = then.tangent[0], &g2 = then.tangent[1];
  const Vec3 area = cross(g1, g2);
  // Along the previous primary normal, or square to the previous secondary face.
  const Vec3& along = c.ray ? before.normal : area;
  const double slope = 1.0 / dot(area, along);
  const Vec3 dual[2] = {slope * cross(g2, along), slope * cross(along, g1)};
  const Vec3 off = c.ray ? Vec3::zero() : Vec3(dot(area, d) / dot(area, area) * area);
  r.slip = Vec3::zero();
  for (int a = 0; a < 2; ++a) {
    r.component[a] = dot(dual[a], d);
    r.slip += r.component[a] * s.face.tangent[a];
  }
  const Vec3* now2 = s.face.second;
  const Vec3* then2 = then.second;
  const double metric[2][2] = {{dot(dual[0], dual[0]), dot(dual[0], dual[1])},
                               {dot(dual[0], dual[1]), dot(dual[1], dual[1])}};
  for (int k = 0; k < 2; ++k) {
    const Vec3 &now_1k = k == 0 ? now2[0] : now2[2], &now_2k = k == 0 ? now2[2] : now2[1];
    const Vec3 &then_1k = k == 0 ? then2[0] : then2[2], &then_2k = k == 0 ? then2[2] : then2[1];
    const Vec3 bend = r.component[0] * then_1k + r.component[1] * then_2k;
    const double b[2] = {dot(off, then_1k), dot(off, then_2k)}; // zero for a ray
    r.moved[k] = s.face.tangent[k] + r.component[0] * now_1k + r.component[1] * now_2k;
    for (int a = 0; a < 2; ++a)
      r.moved[k] +=
          (metric[a][0] * b[0] + metric[a][1] * b[1] - dot(dual[a], bend)) * s.face.tangent[a];
  }
}

/// Trial traction w and its derivatives by the column nodes (n1+n2).
struct TrialColumns {
  Vec3 w;
  Mat3 block[PartnerColumns::max_columns];
};

/// Of incremental_trial: w = P z, z = lambda_T - eps theta r, P = I - c (x) c.
inline KOKKOS_FUNCTION void incremental_columns(const ContactPoint& c, const PrimaryColumns& p,
                                                const PartnerColumns& s, TrialColumns& t) {
  SlipColumns r;
  objective_slip_columns(c, s, r);
  const Vec3 carried = turned_traction(c.carried, p.at);
  const TurnedColumns turned(c.carried, p, carried);
  const double net_gap = s.gap - c.offset;
  const double stiffness = c.penalty * contact_share(c, net_gap);
  const Vec3 z = carried - stiffness * r.slip;
  const double cz = dot(s.c, z);
  t.w = z - cz * s.c;
  const auto project = [&](const Vec3& v) { return v - dot(s.c, v) * s.c; };
  const Vec3 moved[2] = {-stiffness * project(r.moved[0]), -stiffness * project(r.moved[1])};
  const Vec3 share = (-c.penalty * contact_share_slope(c, net_gap)) * project(r.slip);
  const Vec3 tilt[2] = {cz * s.dual[0] + dot(t.w, s.dual[0]) * s.c,
                        cz * s.dual[1] + dot(t.w, s.dual[1]) * s.c};
  const int n1 = c.shape.nodes, n = n1 + fem::face_nodes(c.face);
  for (int q = 0; q < n; ++q) {
    Mat3& m = t.block[q];
    m = Mat3::zero();
    if (q < n1) {
      turned.add(c.shape, q, m);
      add_dyad(m, -s.c, row_times(s.c, m));
    } else {
      const double* dN = s.face.dN[q - n1];
      const double along = -stiffness * (r.component[0] * dN[0] + r.component[1] * dN[1]);
      add_dyad(m, -along * s.c, s.c);
      for (int i = 0; i < 3; ++i)
        m[i][i] += along;
    }
    for (int k = 0; k < 2; ++k) {
      add_dyad(m, moved[k], s.row_xi[k][q]);
      add_dyad(m, tilt[k], s.turn[k][q]);
    }
    if (c.first)
      add_dyad(m, share, s.row_gap[q]);
  }
}

/// Of minus the penalty times literal_slip.
inline KOKKOS_FUNCTION void literal_columns(const ContactPoint& c, const PrimaryColumns& p,
                                            const PartnerColumns& s, TrialColumns& t) {
  const PrimaryPoint<double> before = primary_point(c.shape, c.x_previous);
  fem::FacePoint<double> then;
  fem::face_point(c.face, c.y_previous, c.xi, then);
  Vec3 twice[2]; // g + Delta g
  for (int a = 0; a < 2; ++a)
    twice[a] = 2.0 * p.at.tangent[a] - before.tangent[a];
  const Vec3 m = cross(p.at.tangent[0] - before.tangent[0], p.at.tangent[1]) +
                 cross(p.at.tangent[0], p.at.tangent[1] - before.tangent[1]);
  const Vec3& n = p.at.normal;
  const Vec3 rate = (1.0 / p.at.area) * m;
  const Vec3 r = s.gap * rate + (p.at.x - before.x) - (s.face.x - then.x);
  const double nr = dot(n, r), eps = c.penalty;
  t.w = -eps * (r - nr * n);
  const int n1 = c.shape.nodes, count = n1 + fem::face_nodes(c.face);
  for (int q = 0; q < count; ++q) {
    Mat3& d = t.block[q];
    d = Mat3::zero();
    const double N = q < n1 ? c.shape.N[q] : -s.face.N[q - n1];
    for (int i = 0; i < 3; ++i)
      d[i][i] = N;
    add_dyad(d, rate, s.row_gap[q]);
    for (int k = 0; k < 2; ++k)
      add_dyad(d, then.tangent[k] - s.face.tangent[k], s.row_xi[k][q]);
    if (q < n1) {
      const Vec3& grad = p.gradient[q];
      add_dyad(d, -s.gap * rate, grad);
      const Vec3 v =
          (s.gap / p.at.area) * (c.shape.dN[q][1] * twice[0] - c.shape.dN[q][0] * twice[1]);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3; // v x
        d[i][j] -= v[k];
        d[i][k] += v[j];
      }
      add_dyad(d, nr * grad, n);
      add_dyad(d, -n, row_times(n, d));
      add_dyad(d, dot(r, grad) * n, n);
    } else {
      add_dyad(d, -n, row_times(n, d));
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        d[i][j] *= -eps;
  }
}

} // namespace abut::contact
