// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/assembled_system.hpp"

namespace abut::solver {

AssembledSystem::AssembledSystem(assembly::EquationSystem& equations)
    : equations_(equations), coordinates_(equations.row_coordinates()) {}

} // namespace abut::solver
