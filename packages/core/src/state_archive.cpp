// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/state_archive.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <numeric>

namespace abut {

namespace {

/// Rows by ascending keys, each key once.
void sort_rows(StateArchive::Array& array) {
  const auto width = static_cast<std::size_t>(array.width);
  std::vector<std::size_t> order(array.keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return array.keys[a] < array.keys[b]; });
  StateArchive::Array sorted{array.name, {}, {}, array.width};
  for (const std::size_t row : order) {
    if (!sorted.keys.empty() && sorted.keys.back() == array.keys[row])
      continue;
    sorted.keys.push_back(array.keys[row]);
    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(row * width);
    sorted.values.insert(sorted.values.end(), first, first + array.width);
  }
  array = std::move(sorted);
}

[[noreturn]] void refuse(const std::string& name) {
  throw InputError("it does not hold '" + name + "' of this model");
}

} // namespace

void StateArchive::rows(const std::string& name, const std::vector<Global>& keys, int width,
                        double* values) {
  const auto w = static_cast<std::size_t>(width);
  if (!takes_)
    return give({name, keys, {values, values + keys.size() * w}, width});
  const Array array = fetch(name);
  comm_.together([&] {
    if (array.width != width)
      refuse(name);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto found = std::lower_bound(array.keys.begin(), array.keys.end(), keys[i]);
      if (found == array.keys.end() || *found != keys[i])
        refuse(name);
      const auto row = static_cast<std::size_t>(found - array.keys.begin());
      std::copy_n(&array.values[row * w], w, values + i * w);
    }
  });
}

std::vector<StateArchive::Array> StateArchive::gathered() const {
  std::vector<Array> all;
  for (const Array& mine : arrays_) {
    const bool shared = !comm_.any(!mine.keys.empty());
    Array whole{mine.name, comm_.gather(mine.keys), {}, mine.width};
    whole.values = shared ? mine.values : comm_.gather(mine.values);
    if (!comm_.is_root())
      continue;
    if (!shared)
      sort_rows(whole);
    all.push_back(std::move(whole));
  }
  return all;
}

bool StateArchive::holds(const std::string& name) const {
  const auto named = [&](const Array& a) { return a.name == name; };
  return !takes_ || comm_.any(std::any_of(arrays_.begin(), arrays_.end(), named));
}

StateArchive::Array StateArchive::fetch(const std::string& name) const {
  Array array;
  comm_.on_root([&] {
    const auto found = std::find_if(arrays_.begin(), arrays_.end(),
                                    [&](const Array& a) { return a.name == name; });
    if (found == arrays_.end())
      refuse(name);
    array = *found;
  });
  comm_.broadcast(&array.width, sizeof array.width);
  comm_.broadcast(array.keys);
  comm_.broadcast(array.values);
  return array;
}

void StateArchive::require_complete(const std::string& name, bool complete) const {
  comm_.together([&] {
    if (!complete)
      refuse(name);
  });
}

} // namespace abut
