// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/fem/cell.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/material.hpp"

#include <memory>

namespace abut::solid {

/// The element with the smallest det F of a loop; -1 and 1 when there is none below 1.
struct Smallest {
  double det = 1.0;
  Local element = -1;
};

/// Loops over a block's elements. What they read lies in views made once; cell type, formulation
/// and material are picked then, so that a loop knows them as types.
class BlockLoops {
public:
  virtual ~BlockLoops() = default;
  virtual Smallest residual(const NodalFields& fields, const ResidualScatter& scatter) const = 0;
  virtual Smallest tangent(const NodalFields& fields, const TangentScatter& scatter) const = 0;
  /// stress: (elements, 6); energy: (elements)
  virtual void averages(const NodalFields& fields, const View<double>& stress,
                        const View<double>& energy) const = 0;
  /// volume: (elements); strain: (elements, 6); stress: (elements, nodes, 6)
  virtual void recover(const NodalFields& fields, const View<double>& volume,
                       const View<double>& strain, const View<double>& stress) const = 0;
};

/// Displacement elements; instantiated for each cell type in a source file of its own.
template <fem::CellType C>
std::unique_ptr<BlockLoops> make_block_loops(const CellArrays& cells, const Material& material);

/// With the mean dilatation; the material must be uncoupled (else Defect).
template <fem::CellType C>
std::unique_ptr<BlockLoops> make_dilated_loops(const CellArrays& cells, const Material& material);

/// Enhanced hex8.
std::unique_ptr<BlockLoops> make_enhanced_loops(const CellArrays& cells, const Material& material);

} // namespace abut::solid
