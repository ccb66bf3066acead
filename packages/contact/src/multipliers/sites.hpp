// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interface_data.hpp"

namespace abut::contact {

/// The places where the law of an interface holds, points or nodes, one like the other.
class Sites {
public:
  explicit Sites(const InterfaceData& data) : data_(data) {}

  Local size() const { return data_.nodal ? data_.corners.nodes() : data_.points.size(); }
  Site operator[](Local i) const { return data_.nodal ? node(i) : point(i); }
  /// A number of its own for each site of all ranks.
  Global key(Local i) const;
  /// Whether it cannot move along the normal, and whether its faces are covered only in part.
  bool held(Local i) const;
  bool partly_covered(Local i) const;

private:
  Site point(Local i) const;
  Site node(Local i) const;

  const InterfaceData& data_;
};

/// Part of a tied point's multiplier that only takes off the distance at the start.
Vec3 tied_rest(const InterfaceData& data, Local point, const PrimaryPoint<double>& at);

} // namespace abut::contact
