// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overlaps.hpp"

#include <vector>

namespace abut::audit {

/// A sample that in one step went into a piece through one face and out of it through another that
/// looks the other way.
struct Passage {
  Local sample;
  Vec3 x;       ///< where it went in [length]
  Global piece; ///< that it went through
  Owner owner;  ///< of the element that it came out of
  double way;   ///< through the piece [length]
  double size;  ///< of the face there [length]
  Sides sides;  ///< of that face
};

/// With nodes on straight ways: faces that turn by more than 10 degrees in the step went another
/// one, and are not judged.
/// Collective.
std::vector<Passage> find_passages(const Scan& scan);

} // namespace abut::audit
