// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/core/views.hpp"
#include "abut/mesh/surface.hpp"

#include <vector>

namespace abut::contact {

/// How far the round surface that quad4 faces stand for lies outside of the middle of each, by what
/// the surface bends along xi and along eta: (faces, 2), negative where it is hollow; zero on other
/// faces. A face of length L between edges at which the surface bends by phi, to the same side at
/// both, rises by L phi/8, the sagitta of the arc. Edges where the surface ends or has a corner say
/// nothing; then the opposite one does. Collective. [length]
std::vector<double> facet_rises(const Comm& comm, const mesh::Surface& surface);

/// The rise at a point of the face's parameter plane; rise: the face's two.
KOKKOS_INLINE_FUNCTION double rise_at(const double* rise, const double xi[2]) {
  return rise[0] * (1.0 - xi[0] * xi[0]) + rise[1] * (1.0 - xi[1] * xi[1]);
}

} // namespace abut::contact
