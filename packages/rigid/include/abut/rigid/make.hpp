// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/curve.hpp"
#include "abut/rigid/body.hpp"
#include "abut/rigid/joint.hpp"
#include "abut/rigid/options.hpp"
#include "abut/unknowns/dof_map.hpp"

#include <string>
#include <vector>

namespace abut::rigid {

/// The body that options describe. Mass that a density makes, and the motion at the start, are left
/// to who knows the elements and the steps.
Body make_body(const std::string& name, const MotionOptions& options,
               const std::vector<Curve>& curves);

/// The joints that options describe, between bodies of these names; any other name is the ground.
std::vector<Joint> make_joints(const std::vector<JointOptions>& options,
                               const std::vector<Body>& bodies, const std::vector<Curve>& curves);

/// What joints couple.
std::vector<unknowns::RigidLink> links_of(const std::vector<Joint>& joints);

} // namespace abut::rigid
