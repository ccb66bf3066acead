// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/options.hpp"

#include <functional>

namespace abut::solid {

/// Sum of the forces of a load at t on the bodies of the reference configuration [force].
/// Collective. Throws as LoadContribution does.
Vec3 resultant(const mesh::Mesh& mesh, const LoadOptions& load, std::function<double(double)> curve,
               double t);

} // namespace abut::solid
