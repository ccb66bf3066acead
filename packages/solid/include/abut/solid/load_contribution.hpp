// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh.hpp"
#include "abut/solid/cell_arrays.hpp"
#include "abut/solid/face_kernel.hpp"
#include "abut/solid/options.hpp"

#include <functional>

namespace abut::solid {

class CellList;

/// One load of the deck, times its curve. Residual: minus the external force.
class LoadContribution : public Contribution {
public:
  /// options.place must exist in the mesh (else Defect); for an empty curve see Amount.
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
  void add_faces(const mesh::Mesh& mesh, CellList& cells);
  void add_block(const mesh::Mesh& mesh, CellList& cells);
  void add_nodes(const mesh::Mesh& mesh, CellList& cells) const;
  template <class Visit> void visit_points(Local cell, const Visit& visit) const;
  void make_point_values();
  void set_shares();
  void set_forces(double time);
  void set_at_points(double time);

  LoadOptions options_;
  std::function<double(double)> curve_;
  Connectivity connectivity_;
  CellArrays cells_;
  View<const fem::FaceType> faces_;          ///< traction, pressure: type of each cell
  View<const ReferenceFaces> tables_;        ///< follower loads: one
  fem::CellType type_ = fem::CellType::hex8; ///< body force: type of every cell
  double time_;                              ///< of what follows
  View<double> share_;    ///< dead loads: int N_a of each entry (1 for nodal forces)
  View<Vec3> force_;      ///< dead loads: (entries) external force
  View<double> pressure_; ///< pressure: (cells, max_face_points)
  View<Vec3> traction_;   ///< traction per current area: (cells, max_face_points)
};

} // namespace abut::solid
