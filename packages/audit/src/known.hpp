// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlaps.hpp"

#include "abut/audit/findings.hpp"

#include <vector>

namespace abut::audit {

/// What the points of one interface say of the overlap nearest to them.
struct Knowledge {
  int overlap; ///< index in the list that was asked about
  int interface;
  double distance; ///< of the point from the sample [length]
  double gap;      ///< that it has [length]
  int paired, pressed, held;
};

/// By overlap and interface, the nearest point first.
bool operator<(const Knowledge& a, const Knowledge& b);

/// For each overlap and interface that joins its bodies, the nearest point within a face, if there
/// is one. Collective.
std::vector<Knowledge> what_is_known(const Scan& scan, const std::vector<Overlap>& overlaps,
                                     const std::vector<Belief>& beliefs);

/// Why nobody knows of the overlap; Cause::none: somebody does. What is left of it beyond
/// `allowed` must be known. Sets interface, gap believed in and cause.
bool is_known(const Scan& scan, const Overlap& overlap, double allowed,
              const std::vector<Belief>& beliefs, const Knowledge* first, const Knowledge* last,
              Finding& finding);

} // namespace abut::audit
