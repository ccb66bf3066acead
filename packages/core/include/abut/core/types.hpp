// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut {

using Local = int;        ///< index on this rank
using Global = long long; ///< index over all ranks

} // namespace abut
