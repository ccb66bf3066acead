// SPDX-License-Identifier: BSD-3-Clause
#include "block_loops_impl.hpp"

template struct abut::solid::BlockLoops<abut::fem::CellType::tet4>;
