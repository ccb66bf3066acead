// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::app {

/// Settings of the libraries below that serve one process to a rank, where the user's environment
/// does not say otherwise: one thread to a rank, no search for networks between ranks of one
/// machine, memory that is kept. To be called before MPI starts.
void prepare_process();

} // namespace abut::app
