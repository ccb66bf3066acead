// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/cell.hpp"

namespace abut::fem {

struct CellMeasure {
  double volume = 0.0;        ///< [length^3]
  double least = 0.0;         ///< smallest Jacobian determinant at the integration points
  Vec3 moment = Vec3::zero(); ///< integral of the position over the volume
};

/// By the default rule; x: node positions in the order of Exodus II.
CellMeasure measure_cell(CellType type, const Vec3* x);

/// Area by the default rule; x: node positions [length^2].
double face_area(FaceType type, const Vec3* x);

} // namespace abut::fem
