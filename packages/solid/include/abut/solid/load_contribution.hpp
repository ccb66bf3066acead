// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/options.hpp"

#include <functional>
#include <vector>

namespace abut::solid {

/// One load of the deck, times curve(time). Residual: minus the external force.
class LoadContribution : public Contribution {
public:
  /// The mesh must outlive this object. options.place must exist in the mesh (else Defect); an
  /// empty curve means the load parameter itself.
  LoadContribution(const mesh::Mesh& mesh, const LoadOptions& options,
                   std::function<double(double)> curve);

  const char* name() const override { return options_.name.c_str(); }
  const Connectivity& connectivity() const override { return connectivity_; }
  bool symmetric() const override { return options_.kind != LoadKind::pressure; }

  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;

private:
  double factor(double time) const { return curve_ ? curve_(time) : time; }
  void add_cell(const Local* nodes, int count);
  void set_faces(bool dead);
  void set_body_force();
  void set_nodal_force();

  const mesh::Mesh& mesh_;
  LoadOptions options_;
  std::function<double(double)> curve_;
  Connectivity connectivity_;
  std::vector<Local> nodes_;         ///< local node of each entry of the connectivity
  std::vector<double> share_;        ///< dead loads: int N_a of each entry (1 for nodal forces)
  std::vector<fem::FaceType> faces_; ///< pressure: type of each cell
};

} // namespace abut::solid
