// SPDX-License-Identifier: BSD-3-Clause
#include "cursor.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace abut::gmsh {

namespace {

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

} // namespace

std::string Cursor::plain(const std::string& word) {
  constexpr std::size_t longest = 30;
  std::string s = word.substr(0, longest);
  std::replace_if(
      s.begin(), s.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return s + (word.size() > longest ? "..." : "");
}

void Cursor::fail(const std::string& message, std::size_t at) const {
  throw InputError(model_.where(at) + ": " + (section_.empty() ? "" : "$" + section_ + ": ") +
                   message);
}

void Cursor::skip_space() {
  for (; position_ < text_.size() && is_space(text_[position_]); ++position_)
    line_ += text_[position_] == '\n';
}

bool Cursor::at_end() {
  skip_space();
  return position_ == text_.size();
}

std::string Cursor::word() {
  if (at_end())
    fail("the file ends here");
  const std::size_t first = position_;
  while (position_ < text_.size() && !is_space(text_[position_]))
    ++position_;
  return text_.substr(first, position_ - first);
}

std::string Cursor::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  const std::string rest = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  ++line_;
  return rest;
}

void Cursor::skip_to(const std::string& end) {
  const std::size_t found = text_.find("\n" + end, position_ > 0 ? position_ - 1 : 0);
  if (found == std::string::npos)
    fail("there is no " + end);
  const std::size_t behind = found + 1 + end.size();
  line_ += static_cast<std::size_t>(
      std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_),
                 text_.begin() + static_cast<std::ptrdiff_t>(behind), '\n'));
  position_ = behind;
}

void Cursor::take(void* value, std::size_t bytes) {
  if (text_.size() - position_ < bytes)
    fail("the file ends here");
  char raw[8];
  std::copy_n(text_.data() + position_, bytes, raw);
  if (swapped_)
    std::reverse(raw, raw + bytes);
  std::memcpy(value, raw, bytes);
  position_ += bytes;
}

Global Cursor::whole(const char* what) {
  const std::size_t at_word = at();
  const std::string text = word();
  Global value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size())
    fail(std::string("expected ") + what + ", got " + shown(text), at_word);
  return value;
}

int Cursor::integer(const char* what) {
  std::int32_t bytes = 0;
  if (binary_) {
    take(&bytes, sizeof bytes);
    return bytes;
  }
  const Global value = whole(what);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    fail(std::string("expected ") + what + ", got " + std::to_string(value));
  return static_cast<int>(value);
}

Global Cursor::size(const char* what) {
  std::int64_t bytes = 0;
  if (!binary_)
    return whole(what);
  take(&bytes, sizeof bytes);
  return bytes;
}

double Cursor::real(const char* what) {
  double value = 0.0;
  if (binary_) {
    const std::size_t at_value = at();
    take(&value, sizeof value);
    if (!std::isfinite(value))
      fail(std::string("expected ") + what + ", got a number that is not finite", at_value);
    return value;
  }
  const std::size_t at_word = at();
  const std::string text = word();
  const char *first = text.data() + (text[0] == '+' ? 1 : 0), *last = text.data() + text.size();
  const auto end = std::from_chars(first, last, value);
  if (end.ec != std::errc() || end.ptr != last || !std::isfinite(value))
    fail(std::string("expected ") + what + ", got " + shown(text), at_word);
  return value;
}

Global Cursor::count(const char* what, std::size_t bytes_each, bool is_int) {
  const std::size_t at_count = at();
  const Global count = is_int ? integer(what) : size(what);
  // Written as words each item takes two bytes at least, its first digit and a space.
  const std::size_t least = binary_ ? bytes_each : 2;
  if (count < 0 || static_cast<std::size_t>(count) > (text_.size() - position_) / least + 1)
    fail(std::string("expected ") + what + ", got " + std::to_string(count) +
             (count < 0 ? "" : ", for which the file is too short"),
         at_count);
  return count;
}

} // namespace abut::gmsh
