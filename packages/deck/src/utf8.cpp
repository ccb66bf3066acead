// SPDX-License-Identifier: BSD-3-Clause
#include "utf8.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/value.hpp"

#include <algorithm>
#include <cstdio>

namespace abut::deck {

namespace {

unsigned char byte(const std::string& text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// Bytes of the character that begins at `at`; 0: not UTF-8 (RFC 3629, without surrogates and
/// overlong forms).
std::size_t character_length(const std::string& text, std::size_t at) {
  const unsigned char first = byte(text, at);
  if (first < 0x80)
    return 1;
  std::size_t length = 0;
  if (first >= 0xC2 && first <= 0xDF)
    length = 2;
  else if (first >= 0xE0 && first <= 0xEF)
    length = 3;
  else if (first >= 0xF0 && first <= 0xF4)
    length = 4;
  if (length == 0 || at + length > text.size())
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(text, at + i) & 0xC0) != 0x80)
      return 0;
  const unsigned char second = byte(text, at + 1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

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
    const std::size_t length = character_length(text, at);
    at += length;
    if (length > 0)
      continue;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    char code[8];
    std::snprintf(code, sizeof code, "0x%02X", byte(text, at));
    throw InputError(Location{file, line, 1}.text() + ": byte " + code +
                     " is not UTF-8 (it may be Latin-1): save the deck as UTF-8");
  }
}

} // namespace abut::deck
