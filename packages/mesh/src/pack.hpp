// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace abut::mesh {

/// Writes values one after another into bytes that travel to another rank.
class Pack {
public:
  template <class T> void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const char* p = reinterpret_cast<const char*>(&value);
    bytes_.insert(bytes_.end(), p, p + sizeof(T));
  }
  template <class T> void add(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(static_cast<Global>(values.size()));
    const char* p = reinterpret_cast<const char*>(values.data());
    bytes_.insert(bytes_.end(), p, p + values.size() * sizeof(T));
  }
  void add(const std::string& text) { add(std::vector<char>(text.begin(), text.end())); }

  std::vector<char> take() { return std::move(bytes_); }

private:
  std::vector<char> bytes_;
};

/// Reads in the same order what Pack wrote.
class Unpack {
public:
  explicit Unpack(const std::vector<char>& bytes) : next_(bytes.data()) {}

  template <class T> void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, next_, sizeof(T));
    next_ += sizeof(T);
  }
  template <class T> void get(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    Global count = 0;
    get(count);
    values.resize(static_cast<std::size_t>(count));
    if (count > 0)
      std::memcpy(values.data(), next_, values.size() * sizeof(T));
    next_ += values.size() * sizeof(T);
  }
  void get(std::string& text) {
    std::vector<char> characters;
    get(characters);
    text.assign(characters.begin(), characters.end());
  }
  template <class T> T get() {
    T value{};
    get(value);
    return value;
  }

private:
  const char* next_;
};

} // namespace abut::mesh
