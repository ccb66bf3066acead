// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/corner_space.hpp"

#include "abut/fem/face_map.hpp"

namespace abut::contact {

void CornerSpace::values(Local face, const double xi[2], double* N) const {
  fem::dispatch_face(fem::is_triangle(surface_.type[face]) ? fem::FaceType::tri3
                                                           : fem::FaceType::quad4,
                     [&](auto shape) { decltype(shape)::values(xi, N); });
}

double CornerSpace::interpolate(Local face, const double* N, const std::vector<double>& data,
                                int component, int components) const {
  double value = 0.0;
  for (int a = 0; a < corners(face); ++a)
    value += N[a] * data[static_cast<std::size_t>(nodes(face)[a] * components + component)];
  return value;
}

} // namespace abut::contact
