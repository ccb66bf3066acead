// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <vector>

namespace abut::mesh {

/// Part (rank) of each point by recursive coordinate bisection; the root holds the points
/// (n, dim) and gets the parts (n), all others pass and get nothing. Collective, deterministic.
std::vector<int> bisect(const std::vector<double>& points, int dim, const Comm& comm);

} // namespace abut::mesh
