// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/element_fields.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/cell_shape.hpp"
#include "block_loops.hpp"

#include <cmath>
#include <numeric>

namespace abut::solid {

double ElementFields::total_energy() const {
  return std::accumulate(energy.begin(), energy.end(), 0.0);
}

double von_mises(const double s[6]) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

ElementFields element_fields(const mesh::Mesh& mesh, int block, const Material& material,
                             const NodalFields& fields) {
  ABUT_REQUIRE(block >= 0 && block < static_cast<int>(mesh.blocks.size()), "no such block");
  const mesh::Block& b = mesh.blocks[block];
  const std::size_t n = static_cast<std::size_t>(b.size());
  ElementFields out;
  out.stress.resize(n * voigt_size);
  out.von_mises.resize(n);
  out.energy.resize(n);
  fem::dispatch_cell(b.type, [&](auto shape) {
    BlockLoops<decltype(shape)::type>::averages(mesh, b, material, fields, out.stress.data(),
                                                out.energy.data());
  });
  for (std::size_t e = 0; e < n; ++e)
    out.von_mises[e] = von_mises(out.stress.data() + e * voigt_size);
  return out;
}

} // namespace abut::solid
