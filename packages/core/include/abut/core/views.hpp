// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <string>
#include <vector>

/// Where kernels run and where what they read and write lives: the one place that says so. The
/// scatters of scatter.hpp point into host memory, so it is the host's default space.
namespace abut {

using Execution = Kokkos::DefaultHostExecutionSpace;
using Memory = Execution::memory_space;

template <class T> using View = Kokkos::View<T*, Memory>;
using Range = Kokkos::RangePolicy<Execution>;

/// A view with the values of a list.
template <class T> View<T> make_view(const std::string& label, const std::vector<T>& values) {
  View<T> view(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), values.size());
  std::copy(values.begin(), values.end(), view.data());
  return view;
}

/// A view of n default values.
template <class T> View<T> make_view(const std::string& label, std::size_t n, const T& value = {}) {
  View<T> view(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), n);
  std::fill_n(view.data(), n, value);
  return view;
}

} // namespace abut
