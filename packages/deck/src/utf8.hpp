// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::deck {

/// Throws InputError with the line of the first byte that is not UTF-8. Text that begins with the
/// mark of UTF-16 or UTF-32 passes: the YAML reader takes it.
void require_utf8(const std::string& text, const std::string& file);

} // namespace abut::deck
