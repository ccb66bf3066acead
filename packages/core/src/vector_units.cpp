// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/vector_units.hpp"

#include <cstdlib>
#include <string>

namespace abut {

namespace {

VectorUnit widest() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  const char* asked = std::getenv("ABUT_VECTORS");
  const std::string most = asked ? asked : "avx512";
  if (most == "avx512" && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512cd"))
    return VectorUnit::avx512;
  if (most != "plain" && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return VectorUnit::avx2;
#endif
  return VectorUnit::plain;
}

} // namespace

VectorUnit vector_unit() {
  static const VectorUnit unit = widest();
  return unit;
}

} // namespace abut
