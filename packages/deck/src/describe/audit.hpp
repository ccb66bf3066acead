// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/options.hpp"
#include "rule.hpp"

namespace abut::deck {

template <class V> void describe(V& v, audit::AuditOptions& o) {
  v.optional(
      "strict", o.strict,
      "what is found makes the step fail: it is tried again smaller, and the run stops where "
      "that does not help");
  v.optional("every", o.every, "look at every n-th converged step and at the last one; 0: at none",
             at_least(0.0, "1"));
  v.optional("tolerance", o.tolerance,
             "overlap beyond what contact knows of that counts as none, in sizes of the smaller "
             "face or element there",
             at_least(0.0, "1"));
}

} // namespace abut::deck
