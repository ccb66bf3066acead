// SPDX-License-Identifier: BSD-3-Clause
#include "utf8.hpp"

#include "abut/core/error.hpp"
#include "abut/core/utf8.hpp"
#include "abut/deck/value.hpp"

#include <algorithm>
#include <cstdio>

namespace abut::deck {

namespace {

bool has_wide_characters(const std::string& text) {
  const std::string start = text.substr(0, 4);
  return start.compare(0, 2, "\xFF\xFE") == 0 || start.compare(0, 2, "\xFE\xFF") == 0 ||
         start.find('\0') != std::string::npos;
}

} // namespace

void require_utf8(const std::string& text, const std::string& file) {
  if (has_wide_characters(text))
    return;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    at += length;
    if (length > 0)
      continue;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    char code[8];
    std::snprintf(code, sizeof code, "0x%02X", static_cast<unsigned char>(text[at]));
    throw InputError(Location{file, line, 1}.text() + ": byte " + code +
                     " is not UTF-8 (it may be Latin-1): save the deck as UTF-8");
  }
}

} // namespace abut::deck
