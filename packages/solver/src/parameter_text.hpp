// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

namespace abut::solver {

/// Lays the parameter list that `xml` holds (may be empty) over `list`. `name` says in the
/// InputError whose list is not readable.
void merge_parameter_text(const std::string& xml, const std::string& name,
                          Teuchos::ParameterList& list);

} // namespace abut::solver
