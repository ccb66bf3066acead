// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/inertia_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/mass.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace abut::solid {

namespace {

constexpr int max_fields = 8;
using Host = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::IndexType<Local>>;

} // namespace

InertiaContribution::InertiaContribution(const mesh::Mesh& mesh,
                                         const std::vector<BlockDensity>& blocks,
                                         const TimeIntegration& rule, std::vector<Lead> lead)
    : mesh_(mesh), motion_(rule, lead) {
  ABUT_REQUIRE(mesh.dim == 3, "solids are three-dimensional");
  ABUT_REQUIRE(motion_.size() == 3 * static_cast<std::size_t>(mesh.num_local()), "three a node");
  symmetric_ = !mesh.comm.any(std::count(lead.begin(), lead.end(), Lead::rigid) > 0);
  first_entry_.push_back(0);
  for (const BlockDensity& part : blocks) {
    const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(part.block)];
    const int n = fem::info(block.type).nodes;
    for (Local e = 0; e < block.size(); ++e) {
      const Local* nodes = &block.nodes[static_cast<std::size_t>(e) * n];
      double x[3 * fem::max_cell_nodes];
      for (int a = 0; a < n; ++a) {
        nodes_.push_back(nodes[a]);
        connectivity_.nodes.push_back(mesh.node[nodes[a]]);
        std::copy_n(&mesh.x[3 * static_cast<std::size_t>(nodes[a])], 3, &x[3 * a]);
      }
      connectivity_.offsets.push_back(static_cast<Local>(nodes_.size()));
      mass_.resize(mass_.size() + static_cast<std::size_t>(mass_size(n)));
      element_mass(block.type, x, part.density, &mass_[first_entry_.back()]);
      first_entry_.push_back(mass_.size());
    }
  }
}

void InertiaContribution::prepare(const NodalFields& fields) {
  ABUT_REQUIRE(fields.fields == 3, "the displacement is all there is");
  motion_.move(fields.time, fields.u);
}

void InertiaContribution::residual(const NodalFields& fields, const ResidualScatter& scatter) {
  const double* acceleration = motion_.acceleration().data();
  Kokkos::parallel_for("abut::solid::inertia", Host(0, connectivity_.cells()), [&](const Local c) {
    const Local first = connectivity_.offsets[c], n = connectivity_.size(c);
    const double* m = &mass_[first_entry_[c]];
    double r[fem::max_cell_nodes * max_fields] = {};
    for (Local b = 0; b < n; ++b) {
      const double* of = acceleration + 3 * static_cast<std::size_t>(nodes_[first + b]);
      for (Local a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          r[a * fields.fields + i] += m[mass_index(a, b)] * of[i];
    }
    scatter.add(c, r);
  });
}

void InertiaContribution::tangent(const NodalFields&, const TangentScatter& scatter) {
  TangentScatter displacement = scatter; // adds the displacement part of each node block only
  displacement.fields = 3;
  std::vector<double> k(9 * fem::max_cell_nodes * fem::max_cell_nodes);
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    const Local first = connectivity_.offsets[c], n = connectivity_.size(c);
    const double* m = &mass_[first_entry_[c]];
    std::fill(k.begin(), k.end(), 0.0);
    for (Local b = 0; b < n; ++b)
      for (int i = 0; i < 3; ++i) {
        const double slope =
            motion_.slope(3 * static_cast<std::size_t>(nodes_[first + b]) + std::size_t(i));
        for (Local a = 0; a < n; ++a)
          k[static_cast<std::size_t>(3 * a + i) * 3 * n + 3 * b + i] = m[mass_index(a, b)] * slope;
      }
    displacement.add(c, k.data());
  }
}

Momentum InertiaContribution::momentum(const NodalFields& fields) const {
  Momentum total;
  const std::vector<double>& v = motion_.velocity();
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    const Local first = connectivity_.offsets[c], n = connectivity_.size(c);
    const double* m = &mass_[first_entry_[c]];
    for (Local a = 0; a < n; ++a) {
      const auto node = static_cast<std::size_t>(nodes_[first + a]);
      Vec3 x, of_a, of_all = Vec3::zero(); // position, velocity, momentum of the node's share
      for (int i = 0; i < 3; ++i) {
        x[i] = mesh_.x[3 * node + i] + fields.u[3 * node + i];
        of_a[i] = v[3 * node + i];
        for (Local b = 0; b < n; ++b)
          of_all[i] += m[mass_index(a, b)] * v[3 * std::size_t(nodes_[first + b]) + i];
      }
      total.linear += of_all;
      total.angular += cross(x, of_all);
      total.kinetic_energy += 0.5 * dot(of_a, of_all);
    }
  }
  return total;
}

} // namespace abut::solid
