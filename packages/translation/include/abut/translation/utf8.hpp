// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace abut::translation {

/// The text itself where it is UTF-8, else taken for Latin-1 and turned into UTF-8.
std::string utf8(const std::string& text);

} // namespace abut::translation
