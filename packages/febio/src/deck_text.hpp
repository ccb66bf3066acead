// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck_parts.hpp"

namespace abut::febio {

/// The whole deck. Sets that conditions need are added to the mesh.
std::string deck_text(const Model& model, const std::string& name, MeshTranslation& mesh,
                      Report& report);

} // namespace abut::febio
