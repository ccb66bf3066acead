// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/window.hpp"
#include "rule.hpp"

#include <string>

namespace abut::deck {

/// When something holds; `beginning` says what happens first.
template <class V> void describe_window(V& v, Window& o, const std::string& beginning) {
  v.optional("from", o.from,
             ("holds in steps that end after this value of the load parameter" + beginning).c_str(),
             at_least(0.0, "1"));
  v.number_or("until", o.until, "end", "and not after this one", positive("1"));
  v.check("until", !o.until || *o.until > o.from, "expected more than from");
}

} // namespace abut::deck
