// SPDX-License-Identifier: BSD-3-Clause
#include "abut/translation/utf8.hpp"

#include "abut/core/utf8.hpp"

namespace abut::translation {

namespace {

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0)
      return false;
    at += length;
  }
  return true;
}

std::string from_latin1(const std::string& s) {
  std::string out;
  for (const char byte : s) {
    const unsigned char c = static_cast<unsigned char>(byte);
    if (c < 0x80) {
      out += byte;
    } else {
      out += static_cast<char>(0xc0 | (c >> 6));
      out += static_cast<char>(0x80 | (c & 0x3f));
    }
  }
  return out;
}

} // namespace

std::string utf8(const std::string& text) {
  return is_utf8(text) ? text : from_latin1(text);
}

} // namespace abut::translation
