// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/element_fields.hpp"
#include "abut/solid/element_formulation.hpp"
#include "abut/solid/material.hpp"

#include <memory>

namespace abut::solid {

class BlockLoops;

/// Internal forces of this rank's elements of one block. The first three fields are the
/// displacement; others are left alone.
class SolidContribution : public Contribution {
public:
  /// The mesh must outlive this object. Throws InputError as element_formulation does.
  SolidContribution(const mesh::Mesh& mesh, int block, const Material& material,
                    ElementFormulation formulation = ElementFormulation::automatic);
  ~SolidContribution() override;

  const char* name() const override { return "solid"; }
  const Connectivity& connectivity() const override { return connectivity_; }
  Role role() const override { return Role::internal; }

  /// Both throw SolveError on the ranks with an inverted element, or an enhanced one that is folded
  /// at a corner, after the loop: it names the element's number in the input and det F. The caller
  /// spreads it.
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;

  /// Stresses and energies at fields, whose ghosts are up to date.
  ElementFields element_fields(const NodalFields& fields) const;
  RecoveredFields recovered_fields(const NodalFields& fields) const;

  int block() const { return block_; }
  const Material& material() const { return material_; }

private:
  const mesh::Mesh& mesh_;
  int block_;
  Material material_;
  Connectivity connectivity_;
  std::unique_ptr<BlockLoops> loops_;
  const char* fault_ = "inverted"; ///< what an element is whose smallest det F is not positive
};

} // namespace abut::solid
