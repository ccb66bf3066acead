// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace abut {

/// Neither the input nor abut is wrong: the disk is full, memory has run out, a signal has come
/// (exit status 5).
class MachineError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// What a std::bad_alloc means to a user.
inline constexpr const char* out_of_memory =
    "the memory of this machine does not suffice; take a coarser mesh, more machines, or a Krylov "
    "solver ('linear_solver: {method: krylov}')";

} // namespace abut
