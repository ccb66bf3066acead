// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/search/queries.hpp"

namespace abut::search {

/// The answer of `nearest` by trying every face: what the tree is checked against.
template <class Query>
KOKKOS_INLINE_FUNCTION Nearest nearest_by_trying_all(const Faces& faces, const Query& q) {
  Vec3 y[fem::max_face_nodes];
  double least = q.reach;
  for (Local face = 0; face < faces.size(); ++face) {
    faces.coordinates(face, y);
    const FaceMeeting m = q.meet(faces.type(face), y);
    if (m.found && std::fabs(m.distance) < least)
      least = std::fabs(m.distance);
  }
  for (Local face = 0; face < faces.size(); ++face) {
    faces.coordinates(face, y);
    const FaceMeeting m = q.meet(faces.type(face), y);
    const double tie = same_distance * diagonal(face_box(faces.type(face), y));
    if (m.found && std::fabs(m.distance) <= least + tie)
      return {face, {m.xi[0], m.xi[1]}, m.distance};
  }
  return {};
}

} // namespace abut::search
