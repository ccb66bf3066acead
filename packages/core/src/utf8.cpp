// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/utf8.hpp"

namespace abut {

namespace {

unsigned char byte(const std::string& text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

} // namespace

std::size_t utf8_length(const std::string& text, std::size_t at) {
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

} // namespace abut
