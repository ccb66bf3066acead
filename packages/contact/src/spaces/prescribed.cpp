// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/prescribed.hpp"

#include "abut/core/tensor.hpp"

namespace abut::contact {

namespace {
constexpr double held_share = 0.99; ///< of the square of the normal, in prescribed directions
} // namespace

std::vector<char> held_nodes(const mesh::Surface& surface, const CornerSpace& space,
                             const std::vector<char>& directions) {
  constexpr std::size_t width = 6; // reference normal, prescribed components
  const std::size_t nodes = surface.node.size();
  std::vector<double> sums(nodes * width, 0.0);
  for (Local f = 0; f < surface.num_faces(); ++f) {
    const Local* node = space.nodes(f);
    const auto edge = [&](int a, int b) {
      const double *from = &surface.x[3 * std::size_t(node[a])],
                   *to = &surface.x[3 * std::size_t(node[b])];
      return Vec3{{to[0] - from[0], to[1] - from[1], to[2] - from[2]}};
    };
    const Vec3 normal =
        space.corners(f) == 4 ? cross(edge(0, 2), edge(1, 3)) : cross(edge(0, 1), edge(0, 2));
    for (int a = 0; a < space.corners(f); ++a)
      for (int i = 0; i < 3; ++i)
        sums[std::size_t(node[a]) * width + std::size_t(i)] += normal[i];
  }
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t i = 0; i < 3; ++i)
      sums[n * width + 3 + i] = (directions[n] >> i) & 1;
  space.sum(sums, width);
  std::vector<char> held(nodes, 0);
  for (std::size_t n = 0; n < nodes; ++n) {
    const double* s = &sums[n * width];
    double along = 0.0, all = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      all += s[i] * s[i];
      along += s[3 + i] > 0.0 ? s[i] * s[i] : 0.0;
    }
    held[n] = along > held_share * all;
  }
  return held;
}

} // namespace abut::contact
