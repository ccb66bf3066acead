// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/options.hpp"
#include "describe/window.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut::deck {

template <class V> void describe(V& v, scene::DisplacementOptions& o) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::array<std::optional<Amount>, 3> given;
  for (std::size_t i = 0; i < 3; ++i)
    if (o.components[i])
      given[i] = o.values[i];

  v.required("set", o.set, "node set, or side set (all its nodes)");
  for (std::size_t i = 0; i < 3; ++i)
    v.optional(axes[i], given[i], "displacement in this direction; free when not given",
               unit("length"));
  std::vector<std::string> fixed;
  v.words("fix", fixed, {"x", "y", "z"}, "directions held at zero: 'fix: [x]' means 'x: 0'");
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
  describe_window(v, o.window, "; else the nodes are free, unless another entry holds them");
  v.optional("relative", o.relative, "counts from where the nodes are when it begins");
  v.at_least_one({"x", "y", "z", "fix"});

  for (const std::string& axis : fixed) {
    std::optional<Amount>& component = given[static_cast<std::size_t>(axis[0] - 'x')];
    v.check("fix", !component, "direction '" + axis + "' is prescribed twice");
    component = 0.0;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    o.components[i] = given[i].has_value();
    o.values[i] = given[i].value_or(Amount());
  }
}

} // namespace abut::deck
