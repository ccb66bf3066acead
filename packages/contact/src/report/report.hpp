// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/summary.hpp"
#include "interface_data.hpp"
#include "kernels/pairs.hpp"

namespace abut::contact {

ContactSummary summarize(const InterfaceData& data); ///< Collective.
/// Averages weighted with the corner functions, which stay positive on quadratic faces.
NodalSums primary_sums(const InterfaceData& data);
/// The forces of the points on the other side. Collective.
NodalSums secondary_sums(const InterfaceData& data);
std::vector<PointRecord> records(const InterfaceData& data);
std::vector<ClosedPoint> closed_points(const InterfaceData& data, const PairArrays& pairs);

} // namespace abut::contact
