// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_text.hpp"

#include "abut/core/error.hpp"

#include <Teuchos_XMLParameterListCoreHelpers.hpp>

namespace abut::solver {

void merge_parameter_text(const std::string& xml, const std::string& name,
                          Teuchos::ParameterList& list) {
  if (xml.empty())
    return;
  Teuchos::RCP<Teuchos::ParameterList> given;
  try {
    given = Teuchos::getParametersFromXmlString(xml);
  } catch (const std::exception& e) {
    throw InputError("The " + name + " parameter list is not readable: " + e.what());
  }
  list.setParameters(*given);
}

} // namespace abut::solver
