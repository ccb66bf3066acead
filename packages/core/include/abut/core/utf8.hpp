// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace abut {

/// Bytes of the character that begins at `at`; 0: not UTF-8 (RFC 3629, without surrogates and
/// overlong forms).
std::size_t utf8_length(const std::string& text, std::size_t at);

} // namespace abut
