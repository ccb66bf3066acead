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

/// E: a kind of elements of kernels/elements.hpp.
template <class E> class TypedLoops : public BlockLoops {
public:
  explicit TypedLoops(const E& elements) : elements_(elements) {}

  Smallest residual(const NodalFields& fields, const ResidualScatter& scatter) const override {
    return smallest_over("abut::solid::residual", elements_.cells.size(),
                         ElementResidual<E>{elements_, fields, scatter});
  }
  Smallest tangent(const NodalFields& fields, const TangentScatter& scatter) const override {
    return smallest_over("abut::solid::tangent", elements_.cells.size(),
                         ElementTangent<E>{elements_, fields, scatter});
  }
  void averages(const NodalFields& fields, const View<double>& stress,
                const View<double>& energy) const override {
    Kokkos::parallel_for("abut::solid::averages", Range(0, elements_.cells.size()),
                         ElementAverages<E>{elements_, fields, stress, energy});
  }
  void recover(const NodalFields& fields, const View<double>& volume, const View<double>& strain,
               const View<double>& stress) const override {
    Kokkos::parallel_for("abut::solid::recover", Range(0, elements_.cells.size()),
                         ElementRecovery<E>{elements_, fields, volume, strain, stress});
  }

private:
  E elements_;
};

template <fem::CellType C> View<const ReferenceCell<C>> cell_table() {
  return make_view("abut::solid::reference_cell", 1, reference_cell<C>());
}

template <fem::CellType C>
std::unique_ptr<BlockLoops> make_block_loops(const CellArrays& cells, const Material& material) {
  return std::visit(
      [&](const auto& m) -> std::unique_ptr<BlockLoops> {
        using Elements = DisplacementElements<C, std::decay_t<decltype(m)>>;
        return std::make_unique<TypedLoops<Elements>>(Elements{cells, cell_table<C>(), m});
      },
      material);
}

template <fem::CellType C>
std::unique_ptr<BlockLoops> make_dilated_loops(const CellArrays& cells, const Material& material) {
  return std::visit(
      [&](const auto& m) -> std::unique_ptr<BlockLoops> {
        using M = std::decay_t<decltype(m)>;
        if constexpr (M::uncoupled) {
          using Elements = DilatedElements<C, M>;
          return std::make_unique<TypedLoops<Elements>>(Elements{cells, cell_table<C>(), m});
        }
        throw Defect("the mean dilatation is for uncoupled materials");
      },
      material);
}

} // namespace abut::solid
