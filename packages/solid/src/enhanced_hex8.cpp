// SPDX-License-Identifier: BSD-3-Clause
#include "block_loops_impl.hpp"

namespace abut::solid {

std::unique_ptr<BlockLoops> make_enhanced_loops(const CellArrays& cells, const Material& material) {
  const View<EnhancedReference> reference("abut::solid::enhanced_reference",
                                          std::size_t(cells.size()));
  Kokkos::parallel_for(
      "abut::solid::enhanced_references", Range(0, cells.size()),
      EnhancedReferences{cells, cell_table<fem::CellType::hex8>(), at_rest(material), reference});
  return std::visit(
      [&](const auto& m) -> std::unique_ptr<BlockLoops> {
        using Elements = EnhancedElements<std::decay_t<decltype(m)>>;
        return std::make_unique<TypedLoops<Elements>>(Elements{cells, reference, m});
      },
      material);
}

} // namespace abut::solid
