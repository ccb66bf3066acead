// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/core/state_numbers.hpp"

#include <string>
#include <vector>

namespace abut {

/// The state of a run between two steps as named arrays of numbers, given by those who own it or
/// taken by them from where another run stood. Each owner lists what it has in one function for
/// both ways, exchange_state(StateArchive&), and nobody knows another's layout. Rows have keys that
/// name them alike on any number of ranks, so that any may take them.
class StateArchive {
public:
  struct Array {
    std::string name;
    std::vector<Global> keys;   ///< (rows); empty: one row that all ranks share
    std::vector<double> values; ///< (rows, width)
    int width = 0;
  };

  /// To be given to.
  explicit StateArchive(const Comm& comm) : comm_(comm) {}
  /// To be taken from. arrays: on the root, keys ascending.
  StateArchive(const Comm& comm, std::vector<Array> arrays)
      : comm_(comm), takes_(true), arrays_(std::move(arrays)) {}

  bool takes() const { return takes_; }
  /// Whether an array of that name is there; true while it is given to. Collective.
  bool holds(const std::string& name) const;

  /// Numbers that all ranks have alike; list(v) hands them to v, see StateNumbers. Taking is
  /// collective, here and below, and throws InputError on all ranks where they are not in the
  /// archive.
  template <class List> void numbers(const std::string& name, const List& list) {
    if (takes_) {
      StateNumbers v(take_shared(name));
      list(v);
      require_complete(name, v.complete());
      return;
    }
    StateNumbers v;
    list(v);
    give({name, {}, v.numbers(), static_cast<int>(v.numbers().size())});
  }

  /// values (rows, width) of this rank's rows. What several ranks have must be the same on each.
  void rows(const std::string& name, const std::vector<Global>& keys, int width, double* values);

  /// Items of a type without lists in it, see StateNumbers.
  template <class T>
  void items(const std::string& name, const std::vector<Global>& keys, T* first) {
    T blank{};
    StateNumbers measure;
    measure(blank);
    const std::size_t width = measure.numbers().size();
    StateNumbers put;
    for (std::size_t i = 0; !takes_ && i < keys.size(); ++i)
      put(first[i]);
    std::vector<double> values = put.numbers();
    values.resize(keys.size() * width);
    rows(name, keys, static_cast<int>(width), values.data());
    StateNumbers take(takes_ ? std::move(values) : std::vector<double>());
    for (std::size_t i = 0; takes_ && i < keys.size(); ++i)
      take(first[i]);
  }

  /// All that was given, on the root: keys ascending, each once. Collective.
  std::vector<Array> gathered() const;

private:
  void give(Array array) { arrays_.push_back(std::move(array)); }
  /// The array of that name on all ranks.
  Array fetch(const std::string& name) const;
  std::vector<double> take_shared(const std::string& name) const { return fetch(name).values; }
  void require_complete(const std::string& name, bool complete) const;

  Comm comm_;
  bool takes_ = false;
  std::vector<Array> arrays_;
};

} // namespace abut
