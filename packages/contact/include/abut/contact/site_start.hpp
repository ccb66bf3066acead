// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

namespace abut::contact {

/// Where the gap of a site counts from, decided once, when the interface begins.
struct SiteStart {
  double overlap = 0.0; ///< of the meshes, or all that presses where it is to grow [length]
  double shift = 0.0;   ///< gap that counts as none: closed, or either way in a fit [length]
  double fit = 0.0;     ///< part of the interference that it has: 0 or 1, between where read from
                        ///< nodes
};

/// What the settings make of it at the present time.
struct StartTerms {
  double fade = 0.0;         ///< part of the overlap that does not count now
  double interference = 0.0; ///< of a fit, now [length]

  /// What comes on top of the gap of the site [length].
  KOKKOS_INLINE_FUNCTION double eased(const SiteStart& s) const {
    return fade * s.overlap - s.shift - interference * s.fit;
  }
};

} // namespace abut::contact
