// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/reference_checks.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/element_kernel.hpp"

#include <algorithm>
#include <sstream>

namespace abut::solid {
namespace {

struct ReferenceMeasure {
  double least = 0.0; ///< smallest determinant
  double volume = 0.0;
};

template <fem::CellType C>
ReferenceMeasure measure(const mesh::Mesh& mesh, const mesh::Block& block, Local element) {
  constexpr int n = ReferenceCell<C>::nodes;
  const ReferenceCell<C>& cell = reference_cell<C>();
  double x[3][n];
  for (int a = 0; a < n; ++a) {
    const Local node = block.nodes[static_cast<std::size_t>(element) * n + a];
    for (int i = 0; i < 3; ++i)
      x[i][a] = mesh.x[static_cast<std::size_t>(node) * 3 + i];
  }
  ReferenceMeasure m;
  for (int p = 0; p < ReferenceCell<C>::points; ++p) {
    const double d = det(nodal_gradient(x, cell.dN[p]));
    m.least = p == 0 ? d : std::min(m.least, d);
    m.volume += cell.weight[p] * d;
  }
  return m;
}

ReferenceMeasure measure(const mesh::Mesh& mesh, const mesh::Block& block, Local element) {
  return fem::dispatch_cell(
      block.type, [&](auto shape) { return measure<decltype(shape)::type>(mesh, block, element); });
}

} // namespace

std::vector<BadElement> bad_elements(const mesh::Mesh& mesh) {
  std::vector<BadElement> bad;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    for (Local e = 0; e < block.size(); ++e) {
      const double det = measure(mesh, block, e).least;
      if (!(det > 0.0))
        bad.push_back({static_cast<int>(b), block.element_id[e], det});
    }
  }
  return bad;
}

void check_elements(const mesh::Mesh& mesh) {
  const std::vector<BadElement> bad = bad_elements(mesh);
  const Global count = mesh.comm.sum(static_cast<Global>(bad.size()));
  mesh.comm.together([&] {
    if (bad.empty())
      return;
    const mesh::Block& block = mesh.blocks[bad[0].block];
    std::ostringstream message;
    message.precision(6);
    message << "element " << bad[0].element_id << " (" << fem::info(block.type).name
            << ") of block '" << block.name
            << "' is inside out or degenerate in the mesh: its reference Jacobian has determinant "
            << bad[0].det << ", expected > 0";
    if (count > 1)
      message << " (" << count << " such elements in all)";
    throw InputError(message.str());
  });
}

double element_volume(const mesh::Mesh& mesh, int block, Local element) {
  return measure(mesh, mesh.blocks[block], element).volume;
}

} // namespace abut::solid
