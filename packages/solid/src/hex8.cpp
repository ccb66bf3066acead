// SPDX-License-Identifier: BSD-3-Clause
#include "block_loops_impl.hpp"

namespace abut::solid {

template std::unique_ptr<BlockLoops> make_block_loops<fem::CellType::hex8>(const CellArrays&,
                                                                           const Material&);
template std::unique_ptr<BlockLoops> make_dilated_loops<fem::CellType::hex8>(const CellArrays&,
                                                                             const Material&);

} // namespace abut::solid
