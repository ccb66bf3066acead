// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/fem/cell.hpp"

namespace abut::audit {

/// Whether x lies in the cell with nodes y (in the order of Exodus II), its faces included: by the
/// inverse of the cell's map. False where Newton's iteration does not find it.
bool inside_cell(fem::CellType type, const Vec3* y, const Vec3& x);

} // namespace abut::audit
