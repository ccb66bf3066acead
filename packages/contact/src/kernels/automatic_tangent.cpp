// SPDX-License-Identifier: BSD-3-Clause
#include <Sacado.hpp>

namespace abut {
using Dual = Sacado::Fad::SFad<double, 81>;
inline double value_of(const Dual& x) {
  return x.val();
}
} // namespace abut

#include "automatic_tangent.hpp"

namespace abut::contact {

bool automatic_tangent(const ContactPoint& c, const Vec3* x, const Vec3* y, const Vec3* z,
                       bool one_face, double* k) {
  const int n1 = c.shape.nodes, n2 = fem::face_nodes(c.face);
  const int n3 = one_face ? 0 : fem::face_nodes(c.anchor_face);
  const int n = 3 * (n1 + n2 + n3);
  Vec<Dual, 3> u[3 * fem::max_face_nodes];
  for (int a = 0; a < n1 + n2 + n3; ++a)
    for (int i = 0; i < 3; ++i)
      u[a][i] = Dual(81, 3 * a + i,
                     a < n1        ? x[a][i]
                     : a < n1 + n2 ? y[a - n1][i]
                                   : z[a - n1 - n2][i]);
  Dual r[81];
  for (Dual& v : r)
    v = 0.0;
  const auto t = point_traction<Dual>(c, u, u + n1, one_face ? u + n1 : u + n1 + n2);
  point_force(c, t, r);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      k[i * n + j] += r[i].dx(j);
  return true;
}

} // namespace abut::contact
