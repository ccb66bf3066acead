// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace abut {

/// The user's input is wrong. The message names file, line, key, what was expected (exit status 2).
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A solve attempt failed (no convergence, inverted element, singular operator). Recoverable: the
/// step is rolled back and tried again with a smaller increment.
class SolveError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A defect of abut itself (exit status 3).
class Defect : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

[[noreturn]] void throw_defect(const char* condition, const char* file, int line,
                               const std::string& message);

/// Where a user gave a key, e.g. "FILE:LINE: contact.pair.primary" for contact.pair.primary:
/// messages about what is wrong with it begin so.
using Where = std::function<std::string(const std::string& path)>;

/// Message when `word` is not one of `valid`: lists them and names the nearest one.
std::string nearest_word_hint(const std::string& word, const std::string* valid, std::size_t count);

} // namespace abut

/// Checks what must hold whatever the input; throws Defect.
#define ABUT_REQUIRE(condition, message)                                                           \
  do {                                                                                             \
    if (!(condition))                                                                              \
      ::abut::throw_defect(#condition, __FILE__, __LINE__, (message));                             \
  } while (false)
