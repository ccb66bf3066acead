// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace abut::solid {

enum class MaterialModel {
  neo_hookean,    ///< W = G/2 (I1-3) - G ln J + lambda/2 (ln J)^2, finite strain
  linear_elastic, ///< small strain: sigma = C : sym grad u on the reference configuration
};

struct MaterialOptions {
  std::string name;
  MaterialModel model = MaterialModel::neo_hookean;
  double young = 0.0;   ///< [pressure]
  double poisson = 0.0; ///< -1 < nu < 1/2
};

/// Motion of a rigid obstacle: displacement, then rotation vector about a point, each times a
/// curve.
struct RigidMotion {
  std::array<double, 3> displacement{}; ///< [length]
  std::array<double, 3> rotation{};     ///< rotation vector [rad]
  std::array<double, 3> center{};       ///< of rotation, reference configuration [length]
  std::string curve;                    ///< empty: the load parameter itself
};

struct BodyOptions {
  std::string name;
  std::vector<std::string> blocks;
  std::string material; ///< empty for a rigid body
  bool rigid = false;
  RigidMotion motion; ///< of a rigid body: prescribed, it has no unknowns
};

/// Displacement of the nodes of a set. components[i]: whether direction i is prescribed.
struct DisplacementOptions {
  std::string name;
  std::string set; ///< node set, or side set (all its nodes)
  std::array<bool, 3> components{};
  std::array<double, 3> values{}; ///< [length]
  std::string curve;
};

enum class LoadKind {
  traction,   ///< dead force per reference area of a side set, vector
  pressure,   ///< follower pressure per current area of a side set, positive pushes inwards
  body_force, ///< dead force per reference volume of a block, vector
  force,      ///< dead force on each node of a node set, vector
};

struct LoadOptions {
  std::string name;
  LoadKind kind = LoadKind::traction;
  std::string place; ///< side set, block or node set
  std::array<double, 3> vector{};
  double pressure = 0.0;
  std::string curve;
};

} // namespace abut::solid
