// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <vector>

namespace abut::multigrid {

/// Strong couplings between the owned rows of a rank.
struct StrengthGraph {
  std::vector<Local> offset{0}; ///< (rows+1)
  std::vector<Local> neighbour;
};

struct Aggregates {
  Local count = 0;
  std::vector<Local> of_row; ///< (rows), -1: a row without strong couplings, left to the smoother
};

/// Groups rows with their strong neighbours (Vanek, Mandel, Brezina 1996, algorithm 5.1): whole
/// neighbourhoods first, then rows left over to the group they are coupled with most often, then
/// what remains.
Aggregates aggregate(const StrengthGraph& graph);

} // namespace abut::multigrid
