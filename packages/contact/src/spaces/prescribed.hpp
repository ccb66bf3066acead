// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/corner_space.hpp"

namespace abut::contact {

/// Corner nodes whose displacement along the reference normal is prescribed, (surface nodes) 0 or
/// 1. directions: (surface nodes) bits 1, 2, 4 where that along x, y, z is. Collective.
std::vector<char> held_nodes(const mesh::Surface& surface, const CornerSpace& space,
                             const std::vector<char>& directions);

} // namespace abut::contact
