// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Sacado.hpp>

namespace Sacado::Fad::Exp {
/// Value of an AD number; kernels find it by argument-dependent lookup.
template <class S> double value_of(const GeneralFad<S>& x) {
  return x.val();
}
} // namespace Sacado::Fad::Exp
