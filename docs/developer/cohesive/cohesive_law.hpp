// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/normal_law.hpp"

/// Glue that is linear in tension: it pulls with `stiffness` times the opening until it has opened
/// by `limit`, and then no more. In compression the interface's penalty holds. The law has no
/// memory: glue that closes again holds again.
struct CohesiveLaw {
  double stiffness = 0.0; ///< [pressure/length]
  double limit = 0.0;     ///< opening at which it lets go [length]

  abut::contact::NormalResponse operator()(double gap, double penalty) const {
    if (gap <= 0.0)
      return {-penalty * gap, penalty};
    if (gap <= limit)
      return {-stiffness * gap, stiffness};
    return {};
  }
};
