// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::audit {

/// How converged steps are looked at by other means than those that made them.
struct AuditOptions {
  bool strict = false;     ///< what is found makes the step fail
  int every = 1;           ///< after every n-th converged step; 0: never
  double tolerance = 0.05; ///< overlap beyond what contact knows of that is none, in face sizes [1]
};

} // namespace abut::audit
