// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every difference between Trilinos versions (13.2 today, 14 to 16 as far as headers tell) and the
// scalar and ordinal choice live here. Heavy: include it in source files, not in kernels.

#include "abut/core/comm.hpp"
#include "abut/core/types.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <Trilinos_version.h>

namespace abut {

using Teuchos::RCP;
using Teuchos::rcp;

using Node = Tpetra::Map<>::node_type;
using Map = Tpetra::Map<Local, Global, Node>;
using Graph = Tpetra::CrsGraph<Local, Global, Node>;
using Matrix = Tpetra::CrsMatrix<double, Local, Global, Node>;
using Vector = Tpetra::Vector<double, Local, Global, Node>;
using MultiVector = Tpetra::MultiVector<double, Local, Global, Node>;
using Operator = Tpetra::Operator<double, Local, Global, Node>;
using Import = Tpetra::Import<Local, Global, Node>;

inline RCP<const Teuchos::Comm<int>> teuchos_comm(const Comm& comm) {
  return rcp(new Teuchos::MpiComm<int>(comm.mpi()));
}

/// Entries of a map on this rank (getNodeNumElements was renamed in 13.4).
inline std::size_t local_size(const Map& map) {
#if TRILINOS_MAJOR_MINOR_VERSION >= 130400
  return map.getLocalNumElements();
#else
  return map.getNodeNumElements();
#endif
}

} // namespace abut
