// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"
#include "interface_data.hpp"

#include <string>

namespace abut::contact {

/// What points, nodes of the law and faces remember between two steps goes to the archive or comes
/// from there, under names that begin with `path`. Rows are named by faces, whose numbers are the
/// same on any number of ranks. Taking is collective.
void exchange_history(StateArchive& archive, const std::string& path, InterfaceData& data);

} // namespace abut::contact
