// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/resultant.hpp"

#include "abut/solid/load_contribution.hpp"

#include <utility>
#include <vector>

namespace abut::solid {

Vec3 resultant(const mesh::Mesh& mesh, const LoadOptions& load, std::function<double(double)> curve,
               double t) {
  Vec3 force = Vec3::zero();
  mesh.comm.together([&] {
    LoadContribution contribution(mesh, load, std::move(curve));
    const std::vector<double> u(3 * mesh.node.size(), 0.0);
    const NodalFields fields{u.data(), 3, t};
    contribution.prepare(fields);
    // One row for all nodes: what is scattered to it adds up.
    const Connectivity& cells = contribution.connectivity();
    const std::vector<Local> row(cells.nodes.size(), 0);
    contribution.residual(fields, {3, cells.offsets.data(), row.data(), &force[0]});
  });
  mesh.comm.sum(&force[0], 3);
  return Vec3::zero() - force; // no minus before a zero
}

} // namespace abut::solid
