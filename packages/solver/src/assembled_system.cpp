// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/assembled_system.hpp"

namespace abut::solver {

AssembledSystem::AssembledSystem(assembly::EquationSystem& equations) : equations_(equations) {
  const assembly::DofMap& dofs = equations.dofs();
  const mesh::Mesh& mesh = dofs.mesh();
  for (Local r = 0; r < dofs.num_rows(); ++r) {
    const auto n = static_cast<std::size_t>(dofs.node_of_row(r));
    for (int i = 0; i < 3; ++i)
      coordinates_.push_back(i < mesh.dim ? mesh.x[n * std::size_t(mesh.dim) + std::size_t(i)]
                                          : 0.0);
  }
}

} // namespace abut::solver
