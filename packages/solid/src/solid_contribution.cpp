// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/solid_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/cell_shape.hpp"
#include "block_loops.hpp"

#include <sstream>

namespace abut::solid {
namespace {

void require_upright(const mesh::Block& block, const Smallest& smallest) {
  if (smallest.det > 0.0)
    return;
  std::ostringstream message;
  message.precision(6);
  message << "element " << block.element_id[smallest.element] << " of block '" << block.name
          << "' is inverted: det F = " << smallest.det;
  throw SolveError(message.str());
}

} // namespace

SolidContribution::SolidContribution(const mesh::Mesh& mesh, int block, const Material& material)
    : mesh_(mesh), block_(block), material_(material) {
  ABUT_REQUIRE(mesh.dim == solid_dim, "solids are three-dimensional");
  ABUT_REQUIRE(block >= 0 && block < static_cast<int>(mesh.blocks.size()), "no such block");
  const mesh::Block& b = mesh.blocks[block];
  const int n = fem::info(b.type).nodes;
  connectivity_.offsets.reserve(b.size() + 1);
  connectivity_.nodes.reserve(b.nodes.size());
  for (Local e = 0; e < b.size(); ++e) {
    for (int a = 0; a < n; ++a)
      connectivity_.nodes.push_back(mesh.node[b.nodes[static_cast<std::size_t>(e) * n + a]]);
    connectivity_.offsets.push_back(static_cast<Local>(connectivity_.nodes.size()));
  }
}

void SolidContribution::residual(const NodalFields& fields, const ResidualScatter& scatter) {
  const mesh::Block& block = mesh_.blocks[block_];
  fem::dispatch_cell(block.type, [&](auto shape) {
    using Loops = BlockLoops<decltype(shape)::type>;
    require_upright(block, Loops::residual(mesh_, block, material_, fields, scatter));
  });
}

void SolidContribution::tangent(const NodalFields& fields, const TangentScatter& scatter) {
  const mesh::Block& block = mesh_.blocks[block_];
  fem::dispatch_cell(block.type, [&](auto shape) {
    using Loops = BlockLoops<decltype(shape)::type>;
    require_upright(block, Loops::tangent(mesh_, block, material_, fields, scatter));
  });
}

} // namespace abut::solid
