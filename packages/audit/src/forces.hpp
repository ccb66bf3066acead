// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interface_sides.hpp"
#include "skin.hpp"

#include "abut/audit/findings.hpp"

namespace abut::audit {

/// What is wrong with the tractions of an interface, and how far it is, 0 included, in the
/// measures. of_node: pieces (N). Collective.
void judge_tractions(const mesh::Mesh& mesh, int interface, const Belief& belief,
                     Measures& measures, std::vector<Finding>& found);

/// Whether the forces on both sides are one another's opposites, also in their moment, and those on
/// the primary what the interface says. primary: (N) whether only that side has the node; empty:
/// the sides share nodes. Collective.
void judge_balance(const mesh::Mesh& mesh, const Pose& pose, int interface, const Belief& belief,
                   const std::vector<char>& primary, Measures& measures,
                   std::vector<Finding>& found);

} // namespace abut::audit
