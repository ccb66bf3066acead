// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/translation/report.hpp"

namespace abut::febio {

using translation::Fate;
using translation::Report;

} // namespace abut::febio
