// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/material.hpp"

/// One material of each kind, with constants of the same size.
namespace abut::solid {

inline OgdenSum some_sum() {
  OgdenSum sum;
  sum.terms = 2;
  sum.c[0] = 0.5;
  sum.m[0] = 6.82;
  sum.c[1] = 0.1;
  sum.m[1] = -1.5;
  return sum;
}

template <class M> M some_law() {
  if constexpr (std::is_same_v<M, HolmesMow>)
    return {0.4, 0.7, 0.35};
  else if constexpr (std::is_same_v<M, MooneyRivlin>)
    return {5.0, 0.3, 0.2};
  else if constexpr (std::is_same_v<M, Ogden>)
    return {5.0, some_sum()};
  else if constexpr (std::is_same_v<M, OgdenUnconstrained>)
    return {some_sum(), 0.7};
  else
    return {0.4, 0.7};
}

struct Constants {
  double shear, lambda;
};
/// What some_law is at small strain.
template <class M> Constants small_strain() {
  if constexpr (std::is_same_v<M, MooneyRivlin>)
    return {1.0, 5.0 - 2.0 / 3.0};
  else if constexpr (std::is_same_v<M, Ogden>)
    return {0.3, 5.0 - 0.2};
  else if constexpr (std::is_same_v<M, OgdenUnconstrained>)
    return {0.3, 0.7};
  else
    return {0.4, 0.7};
}

} // namespace abut::solid
