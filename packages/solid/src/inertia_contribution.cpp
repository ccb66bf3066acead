// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/inertia_contribution.hpp"

#include "abut/core/error.hpp"
#include "cell_list.hpp"
#include "kernels/inertia.hpp"
#include "kernels/mass.hpp"

#include <algorithm>

namespace abut::solid {
namespace {

/// Mass matrices of the cells; density: (cells).
MassArrays make_mass(const CellList& list, const std::vector<double>& density) {
  const CellArrays cells = list.arrays();
  std::vector<std::int64_t> first{0};
  for (Local c = 0; c < cells.size(); ++c)
    first.push_back(first.back() + mass_size(cells.nodes(c)));
  const View<double> packed = make_view<double>("abut::solid::mass", std::size_t(first.back()));
  const MassArrays mass{cells, make_view("abut::solid::first_mass", first), packed};
  Kokkos::parallel_for(
      "abut::solid::cell_mass", Range(0, cells.size()),
      CellMass{{cells, list.types(), make_view<MassCells>("abut::solid::mass_cells", 1)},
               make_view("abut::solid::density", density),
               mass.first,
               packed});
  return mass;
}

} // namespace

InertiaContribution::InertiaContribution(const mesh::Mesh& mesh,
                                         const std::vector<BlockDensity>& blocks,
                                         const TimeIntegration& rule, const std::vector<Lead>& lead)
    : motion_(rule, lead) {
  ABUT_REQUIRE(mesh.dim == 3, "solids are three-dimensional");
  ABUT_REQUIRE(motion_.size() == 3 * static_cast<std::size_t>(mesh.num_local()), "three a node");
  symmetric_ = !mesh.comm.any(std::count(lead.begin(), lead.end(), Lead::rigid) > 0);
  CellList cells(mesh);
  std::vector<double> density;
  for (const BlockDensity& part : blocks) {
    cells.add(mesh.blocks[static_cast<std::size_t>(part.block)]);
    density.resize(static_cast<std::size_t>(cells.size()), part.density);
  }
  connectivity_ = cells.connectivity();
  mass_ = make_mass(cells, density);
}

void InertiaContribution::prepare(const NodalFields& fields) {
  ABUT_REQUIRE(fields.fields == 3, "the displacement is all there is");
  motion_.move(fields.time, fields.u);
}

void InertiaContribution::residual(const NodalFields&, const ResidualScatter& scatter) {
  Kokkos::parallel_for("abut::solid::inertia", Range(0, mass_.cells.size()),
                       InertiaResidual{mass_, motion_.acceleration(), scatter});
}

void InertiaContribution::tangent(const NodalFields&, const TangentScatter& scatter) {
  Kokkos::parallel_for("abut::solid::inertia_tangent", Range(0, mass_.cells.size()),
                       InertiaTangent{mass_, motion_.slopes(), scatter});
}

Momentum InertiaContribution::momentum(const NodalFields& fields) const {
  const View<double> sums("abut::solid::momentum", CellMomentum::value_count);
  Kokkos::parallel_reduce("abut::solid::momentum", Range(0, mass_.cells.size()),
                          CellMomentum{mass_, motion_.velocity(), fields}, sums);
  Kokkos::fence();
  return {sums(0), {{sums(1), sums(2), sums(3)}}, {{sums(4), sums(5), sums(6)}}};
}

} // namespace abut::solid
