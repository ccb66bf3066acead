// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/material.hpp"

namespace abut::solid {

constexpr int solid_dim = 3;

/// The element with the smallest det F of a loop.
struct Smallest {
  double det = 1.0;
  Local element = -1;
};

/// Loops over a block's elements: gather, evaluate, integrate, scatter. One instantiation per cell
/// type, each in a source file of its own; the material is picked once per loop.
template <fem::CellType C> struct BlockLoops {
  static Smallest residual(const mesh::Mesh& mesh, const mesh::Block& block,
                           const Material& material, const NodalFields& fields,
                           const ResidualScatter& scatter);
  static Smallest tangent(const mesh::Mesh& mesh, const mesh::Block& block,
                          const Material& material, const NodalFields& fields,
                          const TangentScatter& scatter);
  /// stress: (elements, 6); energy: (elements)
  static void averages(const mesh::Mesh& mesh, const mesh::Block& block, const Material& material,
                       const NodalFields& fields, double* stress, double* energy);
};

} // namespace abut::solid
