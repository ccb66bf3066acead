// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/solid_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/cell_shape.hpp"
#include "block_loops.hpp"
#include "cell_list.hpp"

#include <sstream>

namespace abut::solid {
namespace {

/// fault: what an element is whose smallest det F is not positive.
void require_upright(const mesh::Block& block, const Smallest& smallest, const char* fault) {
  if (smallest.det > 0.0)
    return;
  std::ostringstream message;
  message.precision(6);
  message << "element " << block.element_id[smallest.element] << " of block '" << block.name
          << "' is " << fault << ": det F = " << smallest.det;
  throw SolveError(message.str());
}

std::unique_ptr<BlockLoops> make_loops(fem::CellType cell, const CellArrays& cells,
                                       const Material& material, ElementFormulation formulation) {
  if (formulation == ElementFormulation::enhanced)
    return make_enhanced_loops(cells, material);
  if (formulation == ElementFormulation::mean_dilatation)
    return cell == fem::CellType::hex8 ? make_dilated_loops<fem::CellType::hex8>(cells, material)
                                       : make_dilated_loops<fem::CellType::wedge6>(cells, material);
  return fem::dispatch_cell(
      cell, [&](auto shape) { return make_block_loops<decltype(shape)::type>(cells, material); });
}

} // namespace

SolidContribution::SolidContribution(const mesh::Mesh& mesh, int block, const Material& material,
                                     ElementFormulation formulation)
    : mesh_(mesh), block_(block), material_(material) {
  ABUT_REQUIRE(mesh.dim == 3, "solids are three-dimensional");
  ABUT_REQUIRE(block >= 0 && block < static_cast<int>(mesh.blocks.size()), "no such block");
  CellList cells(mesh);
  cells.add(mesh.blocks[block]);
  connectivity_ = cells.connectivity();
  const fem::CellType cell = mesh.blocks[block].type;
  const ElementFormulation elements = element_formulation(formulation, cell, material);
  if (elements == ElementFormulation::enhanced)
    fault_ = "inverted or folded at a corner";
  loops_ = make_loops(cell, cells.arrays(), material, elements);
}

SolidContribution::~SolidContribution() = default;

void SolidContribution::residual(const NodalFields& fields, const ResidualScatter& scatter) {
  ABUT_REQUIRE(fields.fields >= 3, "fields per node");
  require_upright(mesh_.blocks[block_], loops_->residual(fields, scatter), fault_);
}

void SolidContribution::tangent(const NodalFields& fields, const TangentScatter& scatter) {
  ABUT_REQUIRE(fields.fields >= 3, "fields per node");
  require_upright(mesh_.blocks[block_], loops_->tangent(fields, scatter), fault_);
}

ElementFields SolidContribution::element_fields(const NodalFields& fields) const {
  const auto n = static_cast<std::size_t>(connectivity_.cells());
  const View<double> stress("abut::solid::stress", voigt_size * n),
      energy("abut::solid::energy", n);
  loops_->averages(fields, stress, energy);
  ElementFields out;
  out.stress.assign(stress.data(), stress.data() + stress.extent(0));
  out.energy.assign(energy.data(), energy.data() + n);
  for (std::size_t e = 0; e < n; ++e)
    out.von_mises.push_back(von_mises(out.stress.data() + e * voigt_size));
  return out;
}

RecoveredFields SolidContribution::recovered_fields(const NodalFields& fields) const {
  const auto n = static_cast<std::size_t>(connectivity_.cells());
  const View<double> volume("abut::solid::volume", n),
      strain("abut::solid::strain", voigt_size * n),
      stress("abut::solid::nodal_stress", voigt_size * connectivity_.nodes.size());
  loops_->recover(fields, volume, strain, stress);
  const auto list = [](const View<double>& view) {
    return std::vector<double>(view.data(), view.data() + view.extent(0));
  };
  return {list(volume), list(strain), list(stress)};
}

} // namespace abut::solid
