// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace abut {

void throw_defect(const char* condition, const char* file, int line, const std::string& message) {
  const char* name = std::strrchr(file, '/');
  throw Defect(message + " [" + condition + " is false at " + (name ? name + 1 : file) + ":" +
               std::to_string(line) + "]");
}

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

} // namespace

std::string nearest_word_hint(const std::string& word, const std::string* valid,
                              std::size_t count) {
  if (count == 0)
    return "none is defined";
  std::string list;
  std::size_t best = 0, best_distance = std::string::npos;
  for (std::size_t i = 0; i < count; ++i) {
    list += (i ? ", " : "") + valid[i];
    const std::size_t d = edit_distance(word, valid[i]);
    if (d < best_distance)
      best = i, best_distance = d;
  }
  const bool is_near = best_distance <= 2 + word.size() / 3;
  const std::string guess = "did you mean '" + valid[best] + "'?";
  constexpr std::size_t long_list = 20; // nobody reads on to the guess
  if (is_near && count > long_list)
    return guess + " valid: " + list;
  return "valid: " + list + (is_near ? "; " + guess : "");
}

} // namespace abut
