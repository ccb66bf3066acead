// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/face_shape.hpp"

namespace abut::fem {

/// Position, tangents and second derivatives of a face in space at one parameter point.
template <class T> struct FacePoint {
  T N[max_face_nodes];
  T dN[max_face_nodes][2];
  Vec<T, 3> x;          ///< position [length]
  Vec<T, 3> tangent[2]; ///< x,xi and x,eta
  Vec<T, 3> second[3];  ///< x,xi xi; x,eta eta; x,xi eta
};

/// Evaluates a face with nodes x (nodes) at xi. The nodes' scalar may be plainer than T.
template <class T, class S>
KOKKOS_INLINE_FUNCTION void face_point(FaceType type, const Vec<S, 3>* x, const T xi[2],
                                       FacePoint<T>& p) {
  dispatch_face(type, [&](auto shape) {
    using Shape = decltype(shape);
    T d2N[max_face_nodes][3];
    Shape::values(xi, p.N);
    Shape::derivatives(xi, p.dN);
    Shape::second_derivatives(xi, d2N);
    p.x = p.tangent[0] = p.tangent[1] = Vec<T, 3>::zero();
    p.second[0] = p.second[1] = p.second[2] = Vec<T, 3>::zero();
    for (int a = 0; a < Shape::nodes; ++a)
      for (int i = 0; i < 3; ++i) {
        p.x[i] += p.N[a] * x[a][i];
        for (int k = 0; k < 2; ++k)
          p.tangent[k][i] += p.dN[a][k] * x[a][i];
        for (int k = 0; k < 3; ++k)
          p.second[k][i] += d2N[a][k] * x[a][i];
      }
  });
}

} // namespace abut::fem
