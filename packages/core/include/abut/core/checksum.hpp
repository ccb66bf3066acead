// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut {

/// FNV-1a of 64 bits: tells contents apart that differ by chance, not by design.
class Checksum {
public:
  void add(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i)
      value_ = (value_ ^ byte[i]) * 0x100000001b3ULL;
  }
  /// Lengths count, so that lists that are split otherwise differ.
  template <class T> void add(const std::vector<T>& list) {
    add_length(list.size());
    add(list.data(), list.size() * sizeof(T));
  }
  void add(const std::string& text) {
    add_length(text.size());
    add(text.data(), text.size());
  }
  std::uint64_t value() const { return value_; }

private:
  void add_length(std::uint64_t length) { add(&length, sizeof length); }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

} // namespace abut
