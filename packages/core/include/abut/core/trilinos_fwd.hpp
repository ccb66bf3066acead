// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Details_DefaultTypes.hpp>
#include <Tpetra_Map_fwd.hpp>
#include <Tpetra_Vector_fwd.hpp>

/// Names of the distributed objects without their heavy definitions; for public headers.
namespace abut {

using Teuchos::RCP;

using Node = Tpetra::Details::DefaultTypes::node_type;
using Map = Tpetra::Map<Local, Global, Node>;
using Matrix = Tpetra::CrsMatrix<double, Local, Global, Node>;
using Vector = Tpetra::Vector<double, Local, Global, Node>;

} // namespace abut
