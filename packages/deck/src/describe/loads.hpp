// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/options.hpp"
#include "rule.hpp"

namespace abut::deck {

template <class V> void describe(V& v, solid::LoadOptions& o) {
  using solid::LoadKind;
  const auto kind = [&](const char* key, LoadKind kind, auto fields) {
    v.alternative(key, o.kind == kind, [&, kind] {
      o.kind = kind;
      fields();
    });
  };
  kind("traction", LoadKind::traction, [&] {
    v.required("traction", o.vector, "dead force per reference area", unit("pressure"));
    v.required("side_set", o.place, "where a traction or a pressure acts");
    v.optional("current_area", o.current_area, "the traction is per current area instead");
  });
  kind("pressure", LoadKind::pressure, [&] {
    v.required("pressure", o.pressure, "per current area, follows the surface; > 0 pushes inwards",
               unit("pressure"));
    v.required("side_set", o.place, "where a traction or a pressure acts");
  });
  kind("body_force", LoadKind::body_force, [&] {
    v.required("body_force", o.vector, "dead force per reference volume", unit("force/length^3"));
    v.required("block", o.place, "where a body force acts");
  });
  kind("force", LoadKind::force, [&] {
    v.required("force", o.vector, "dead force on each node of the set", unit("force"));
    v.required("node_set", o.place, "where a force acts");
  });
  v.optional("curve", o.curve, "factor over the load parameter; without one, t itself");
}

} // namespace abut::deck
