// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/core/tensor.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/mass_arrays.hpp"
#include "abut/solid/nodal_motion.hpp"

namespace abut::solid {

/// A block of deformable elements and its density.
struct BlockDensity {
  int block = 0;
  double density = 0.0; ///< [mass/length^3]
};

struct Momentum {
  double kinetic_energy = 0.0;
  Vec3 linear = Vec3::zero();
  Vec3 angular = Vec3::zero(); ///< about the origin
};

/// Rate of momentum of deformable elements, with consistent mass: int density N_a a dV. It keeps
/// the motion of the nodes; t is the time.
class InertiaContribution : public Contribution {
public:
  /// lead: (3 N local nodes) what moves each node. Collective.
  InertiaContribution(const mesh::Mesh& mesh, const std::vector<BlockDensity>& blocks,
                      const TimeIntegration& rule, const std::vector<Lead>& lead);

  const char* name() const override { return "inertia"; }
  const Connectivity& connectivity() const override { return connectivity_; }
  Role role() const override { return Role::inertia; }
  bool symmetric() const override { return symmetric_; }

  void prepare(const NodalFields& fields) override;
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;
  void accept() override { motion_.accept(); }

  NodalMotion& motion() { return motion_; }
  const NodalMotion& motion() const { return motion_; }

  /// Of this rank's elements, in the state of the last prepare at fields.
  Momentum momentum(const NodalFields& fields) const;

private:
  Connectivity connectivity_;
  MassArrays mass_;
  NodalMotion motion_;
  bool symmetric_ =
      true; ///< unless nodes of turning bodies have another rule than their neighbours
};

} // namespace abut::solid
