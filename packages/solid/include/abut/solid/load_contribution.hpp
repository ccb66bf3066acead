// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/options.hpp"

#include <functional>
#include <vector>

namespace abut::solid {

/// One load of the deck, times its curve. Residual: minus the external force.
class LoadContribution : public Contribution {
public:
  /// The mesh must outlive this object. options.place must exist in the mesh (else Defect); for an
  /// empty curve see Amount.
  LoadContribution(const mesh::Mesh& mesh, const LoadOptions& options,
                   std::function<double(double)> curve);

  const char* name() const override { return options_.name.c_str(); }
  const Connectivity& connectivity() const override { return connectivity_; }
  bool symmetric() const override { return !options_.follows_surface(); }

  /// Evaluates the load at its integration points when the time changed. Throws InputError where an
  /// expression is not finite.
  void prepare(const NodalFields& fields) override;
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;

private:
  void add_cell(const Local* nodes, int count);
  void set_faces();
  void set_body_force();
  void set_nodal_force();
  template <class Visit> void visit_points(Local cell, const Visit& visit) const;
  void set_shares();
  void set_forces(double time);
  void set_at_points(double time);

  const mesh::Mesh& mesh_;
  LoadOptions options_;
  std::function<double(double)> curve_;
  Connectivity connectivity_;
  std::vector<Local> nodes_;                 ///< local node of each entry of the connectivity
  std::vector<fem::FaceType> faces_;         ///< traction, pressure: type of each cell
  fem::CellType type_ = fem::CellType::hex8; ///< body force: type of every cell
  double time_;                              ///< of what follows
  std::vector<double> share_;    ///< dead loads: int N_a of each entry (1 for nodal forces)
  std::vector<double> force_;    ///< dead loads: (entries, 3) external force
  std::vector<double> pressure_; ///< pressure: (cells, max_face_points)
  std::vector<Vec3> traction_;   ///< traction per current area: (cells, max_face_points)
};

} // namespace abut::solid
