// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"
#include "abut/core/window.hpp"

#include <functional>

namespace abut::unknowns {

/// A scalar row that is prescribed.
struct RowConstraint {
  Local row = 0; ///< owned scalar row
  std::function<double(double)> value;
  Window window{};
  bool relative = false;
  bool holds = true;     ///< at the present time
  bool has_held = false; ///< at the last accepted state
  double start = 0.0;    ///< what a relative value counts from

  double at(double t) const { return start + value(t); }
};

} // namespace abut::unknowns
