// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <array>
#include <vector>

namespace abut::multigrid {

/// What a block row stands for.
enum class RowKind : char {
  node,        ///< displacements, and other fields behind them
  translation, ///< of a rigid body
  rotation,    ///< of a rigid body
};

/// What a block row stands for, and where.
struct RowPlace {
  RowKind kind = RowKind::node;
  std::array<double, 3>
      point{};       ///< reference position of the node or of the body's centre [length]
  double unit = 1.0; ///< displacement that is one unknown, of a rotation at this arm [length]
};

/// Vectors that the operator maps almost to zero: a coarse space must hold them.
struct NearNullSpace {
  int fields = 3;             ///< scalar unknowns of a block row (N)
  int modes = 6;              ///< (M)
  std::vector<double> values; ///< (owned rows, N, M)
};

/// Number of modes for N unknowns to a row: 1, 3, 6 and 7 for 1, 2, 3 and 4.
constexpr int mode_count(int fields) {
  return fields == 1 ? 1 : fields == 2 ? 3 : fields == 3 ? 6 : 7;
}

/// The rigid motions of a solid and, of a field beside its displacements, the constant.
/// fields: 1 to 4 to a row; 1: a constant, 2: motions in the plane of the first two coordinates.
/// rows: (owned rows). Arms are measured in the extent of all points, so that all modes have one
/// size. Collective.
NearNullSpace rigid_motions(const Comm& comm, int fields, const std::vector<RowPlace>& rows);

} // namespace abut::multigrid
