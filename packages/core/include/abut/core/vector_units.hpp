// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

/// Kernels with the vector units that the processor has: programs are compiled for the oldest one
/// of an architecture, with registers of two numbers and no fused multiply-add.
namespace abut {

/// Registers of so many numbers in double precision.
enum class VectorUnit { plain = 2, avx2 = 4, avx512 = 8 };

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define ABUT_TARGET(units) __attribute__((target(units), flatten))
#else
#define ABUT_TARGET(units)
#endif

/// Of this processor; the variable ABUT_VECTORS (plain, avx2) asks for less.
VectorUnit vector_unit();

/// A functor compiled once more, with all that it calls, for wider registers. Nothing of it can
/// replace a function of the same name elsewhere, as a file compiled with other flags might.
/// Reduced: what a parallel_reduce hands it besides the index.
template <VectorUnit unit, class Kernel, class... Reduced> struct Wide;

template <class Kernel, class... Reduced> struct Wide<VectorUnit::avx2, Kernel, Reduced...> {
  Kernel kernel;

  ABUT_TARGET("avx2,fma") void operator()(Local i, Reduced&... reduced) const {
    kernel(i, reduced...);
  }
};

template <class Kernel, class... Reduced> struct Wide<VectorUnit::avx512, Kernel, Reduced...> {
  Kernel kernel;

  ABUT_TARGET("arch=x86-64-v4,prefer-vector-width=512")
  void operator()(Local i, Reduced&... reduced) const { kernel(i, reduced...); }
};

#undef ABUT_TARGET

/// Calls `run` with the kernel as the processor runs it fastest. For loops bound by arithmetic: all
/// is compiled three times.
template <class... Reduced, class Kernel, class Run>
void with_vector_units(const Kernel& kernel, Run run) {
  switch (vector_unit()) {
  case VectorUnit::avx512:
    return run(Wide<VectorUnit::avx512, Kernel, Reduced...>{kernel});
  case VectorUnit::avx2:
    return run(Wide<VectorUnit::avx2, Kernel, Reduced...>{kernel});
  case VectorUnit::plain:
    return run(kernel);
  }
}

} // namespace abut
