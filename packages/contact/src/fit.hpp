// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/options.hpp"
#include "abut/core/comm.hpp"
#include "abut/mesh/surface.hpp"

#include <string>

namespace abut::contact {

/// What a user should hear of flat faces on round surfaces: that their sagitta is not small beside
/// the fit of the two, an overlap or an offset, or that none of them can be taken as round; empty:
/// nothing. The sides as resolve() names them, where they are in the mesh. Collective.
std::string warn_of_facets(const Comm& comm, const mesh::Surface& primary,
                           const mesh::Surface& secondary, const ContactOptions& options);

} // namespace abut::contact
