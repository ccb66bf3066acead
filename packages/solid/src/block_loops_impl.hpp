// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/vector_units.hpp"
#include "block_loops.hpp"
#include "kernels/elements.hpp"

namespace abut::solid {

template <class Functor>
Smallest smallest_over(const char* label, Local elements, const Functor& functor) {
  SmallestDet::value_type result;
  with_vector_units<SmallestDet::value_type>(functor, [&](const auto& kernel) {
    Kokkos::parallel_reduce(label, Range(0, elements), kernel, SmallestDet(result));
  });
  Smallest smallest;
  if (elements > 0 && result.val < smallest.det) {
    smallest.det = result.val;
    smallest.element = result.loc;
  }
  return smallest;
}

template <fem::CellType C, class M> class TypedLoops : public BlockLoops {
public:
  TypedLoops(const CellArrays& cells, const M& material)
      : elements_{cells, make_view("abut::solid::reference_cell", 1, reference_cell<C>()),
                  material} {}

  Smallest residual(const NodalFields& fields, const ResidualScatter& scatter) const override {
    return smallest_over("abut::solid::residual", elements_.cells.size(),
                         ElementResidual<C, M>{elements_, fields, scatter});
  }
  Smallest tangent(const NodalFields& fields, const TangentScatter& scatter) const override {
    return smallest_over("abut::solid::tangent", elements_.cells.size(),
                         ElementTangent<C, M>{elements_, fields, scatter});
  }
  void averages(const NodalFields& fields, const View<double>& stress,
                const View<double>& energy) const override {
    Kokkos::parallel_for("abut::solid::averages", Range(0, elements_.cells.size()),
                         ElementAverages<C, M>{elements_, fields, stress, energy});
  }

private:
  Elements<C, M> elements_;
};

template <fem::CellType C>
std::unique_ptr<BlockLoops> make_block_loops(const CellArrays& cells, const Material& material) {
  return std::visit(
      [&](const auto& m) -> std::unique_ptr<BlockLoops> {
        return std::make_unique<TypedLoops<C, std::decay_t<decltype(m)>>>(cells, m);
      },
      material);
}

} // namespace abut::solid
