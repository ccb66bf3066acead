// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/mass.hpp"

#include "cell_list.hpp"
#include "kernels/mass.hpp"

#include <array>

namespace abut::solid {
namespace {

std::array<double, VolumeMoments::value_count> volume_moments(const mesh::Mesh& mesh,
                                                              const std::vector<int>& blocks) {
  CellList cells(mesh);
  for (const int b : blocks)
    cells.add(mesh.blocks[static_cast<std::size_t>(b)]);
  const View<double> moments("abut::solid::volume_moments", VolumeMoments::value_count);
  Kokkos::parallel_reduce("abut::solid::volume_moments", Range(0, cells.size()),
                          VolumeMoments{{cells.arrays(), cells.types(),
                                         make_view<MassCells>("abut::solid::mass_cells", 1)}},
                          moments);
  Kokkos::fence();
  std::array<double, VolumeMoments::value_count> sums;
  std::copy_n(moments.data(), sums.size(), sums.begin());
  mesh.comm.sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

} // namespace

MassProperties mass_properties(const mesh::Mesh& mesh, const std::vector<int>& blocks,
                               double density) {
  const auto sums = volume_moments(mesh, blocks);
  MassProperties result;
  result.mass = density * sums[0];
  if (!(sums[0] > 0.0))
    return result;
  Vec3& c = result.center;
  for (int i = 0; i < 3; ++i)
    c[i] = sums[1 + i] / sums[0];
  double second[3][3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    second[i][i] = density * sums[4 + i] - result.mass * c[i] * c[i];
    second[i][j] = second[j][i] = density * sums[7 + i] - result.mass * c[i] * c[j];
  }
  const double trace = second[0][0] + second[1][1] + second[2][2];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result.inertia[i][j] = (i == j ? trace : 0.0) - second[i][j];
  return result;
}

} // namespace abut::solid
