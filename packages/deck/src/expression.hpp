// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/options.hpp"

#include <string>

namespace abut::deck {

/// Compiles a formula in x, y, z (reference position), t (load parameter), pi and the functions of
/// muParser. Throws InputError "WHERE: ..." for what is no such formula; the result throws it where
/// the value is not finite.
Amount::Function compile_expression(const std::string& text, const std::string& where);

} // namespace abut::deck
