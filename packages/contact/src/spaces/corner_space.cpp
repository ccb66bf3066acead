// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/corner_space.hpp"

#include "abut/fem/face_map.hpp"

namespace abut::contact {

void corner_values(fem::FaceType type, const double xi[2], double* N) {
  fem::dispatch_face(fem::is_triangle(type) ? fem::FaceType::tri3 : fem::FaceType::quad4,
                     [&](auto shape) { decltype(shape)::values(xi, N); });
}

double corner_share(const double* N, int corners, int a) {
  return a < corners       ? N[a]
         : a < 2 * corners ? 0.5 * (N[a - corners] + N[(a - corners + 1) % corners])
                           : 0.25;
}

void CornerSpace::values(Local face, const double xi[2], double* N) const {
  corner_values(surface_.type[face], xi, N);
}

double CornerSpace::interpolate(Local face, const double* N, const std::vector<double>& data,
                                int component, int components) const {
  double value = 0.0;
  for (int a = 0; a < corners(face); ++a)
    value += N[a] * data[static_cast<std::size_t>(nodes(face)[a] * components + component)];
  return value;
}

} // namespace abut::contact
