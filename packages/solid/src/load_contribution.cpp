// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/load_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/solid_point.hpp"
#include "cell_list.hpp"
#include "kernels/loads.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abut::solid {
namespace {

template <int n> Vec3 interpolate(const double (&N)[n], const Vec3* x) {
  Vec3 sum = Vec3::zero();
  for (int a = 0; a < n; ++a)
    sum += N[a] * x[a];
  return sum;
}

/// visit(point, position, weight with area, N) for the points of a face with nodes x.
template <fem::FaceType F, class Visit> void visit_face(const Vec3* x, const Visit& visit) {
  const ReferenceFace<F>& face = reference_face<F>();
  for (int p = 0; p < ReferenceFace<F>::points; ++p) {
    Vec3 t1, t2;
    face_tangents(face, p, x, t1, t2);
    visit(p, interpolate(face.N[p], x), face.weight[p] * norm(cross(t1, t2)), face.N[p]);
  }
}

/// visit(point, position, weight with volume, N) for the points of a cell with nodes x.
template <fem::CellType C, class Visit> void visit_cell(const Vec3* x, const Visit& visit) {
  const ReferenceCell<C>& cell = reference_cell<C>();
  double by_component[3][ReferenceCell<C>::nodes];
  for (int a = 0; a < ReferenceCell<C>::nodes; ++a)
    for (int i = 0; i < 3; ++i)
      by_component[i][a] = x[a][i];
  for (int p = 0; p < ReferenceCell<C>::points; ++p)
    visit(p, interpolate(cell.N[p], x),
          cell.weight[p] * det(nodal_gradient(by_component, cell.dN[p])), cell.N[p]);
}

} // namespace

LoadContribution::LoadContribution(const mesh::Mesh& mesh, const LoadOptions& options,
                                   std::function<double(double)> curve)
    : options_(options), curve_(std::move(curve)), time_(std::numeric_limits<double>::quiet_NaN()) {
  ABUT_REQUIRE(mesh.dim == 3, "loads are three-dimensional");
  CellList cells(mesh);
  switch (options_.kind) {
  case LoadKind::traction:
  case LoadKind::pressure:
    add_faces(mesh, cells);
    break;
  case LoadKind::body_force:
    add_block(mesh, cells);
    break;
  case LoadKind::force:
    add_nodes(mesh, cells);
    break;
  }
  connectivity_ = cells.connectivity();
  cells_ = cells.arrays();
  if (options_.follows_surface())
    make_point_values();
  else
    set_shares();
}

void LoadContribution::add_faces(const mesh::Mesh& mesh, CellList& cells) {
  const auto found = mesh.side_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh.side_sets.end(), "no side set '" + options_.place + "'");
  std::vector<fem::FaceType> types;
  for (const mesh::Side& s : found->second) {
    const mesh::Block& block = mesh.blocks[s.block];
    const fem::CellSide& side = fem::side(block.type, s.side);
    const std::size_t first = static_cast<std::size_t>(s.element) * fem::info(block.type).nodes;
    const int n = fem::face_nodes(side.type);
    Local nodes[fem::max_face_nodes];
    for (int a = 0; a < n; ++a)
      nodes[a] = block.nodes[first + side.nodes[a]];
    cells.add(nodes, n);
    types.push_back(side.type);
  }
  faces_ = make_view("abut::solid::face_type", types);
}

void LoadContribution::add_block(const mesh::Mesh& mesh, CellList& cells) {
  const auto block = std::find_if(mesh.blocks.begin(), mesh.blocks.end(),
                                  [&](const mesh::Block& b) { return b.name == options_.place; });
  ABUT_REQUIRE(block != mesh.blocks.end(), "no block '" + options_.place + "'");
  type_ = block->type;
  cells.add(*block);
}

void LoadContribution::add_nodes(const mesh::Mesh& mesh, CellList& cells) const {
  const auto found = mesh.node_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh.node_sets.end(), "no node set '" + options_.place + "'");
  for (const Local node : found->second)
    if (node < mesh.num_owned)
      cells.add(&node, 1);
}

/// visit(point, reference position, weight, N) for the points of a cell of the connectivity.
template <class Visit> void LoadContribution::visit_points(Local cell, const Visit& visit) const {
  const Vec3* x = &cells_.x(cells_.first(cell));
  if (options_.kind == LoadKind::force) {
    const double one = 1.0;
    visit(0, x[0], 1.0, &one);
  } else if (options_.kind == LoadKind::body_force) {
    fem::dispatch_cell(type_, [&](auto shape) { visit_cell<decltype(shape)::type>(x, visit); });
  } else {
    fem::dispatch_face(faces_(cell),
                       [&](auto shape) { visit_face<decltype(shape)::type>(x, visit); });
  }
}

void LoadContribution::make_point_values() {
  const auto size = static_cast<std::size_t>(cells_.size()) * max_face_points;
  tables_ = make_view<ReferenceFaces>("abut::solid::reference_faces", 1);
  if (options_.kind == LoadKind::pressure)
    pressure_ = make_view<double>("abut::solid::pressure", size);
  else
    traction_ = make_view<Vec3>("abut::solid::traction", size);
}

void LoadContribution::set_shares() {
  share_ = make_view<double>("abut::solid::share", cells_.x.extent(0));
  force_ = make_view<Vec3>("abut::solid::force", cells_.x.extent(0));
  for (Local c = 0; c < cells_.size(); ++c)
    visit_points(c, [&](int, const Vec3&, double weight, const double* N) {
      for (int a = 0; a < cells_.nodes(c); ++a)
        share_(cells_.first(c) + a) += weight * N[a];
    });
}

void LoadContribution::set_forces(double time) {
  bool expressions = false;
  for (int i = 0; i < 3; ++i) {
    const Amount& amount = options_.vector[std::size_t(i)];
    expressions = expressions || amount.function;
    const double density = amount.function ? 0.0 : amount.at(Vec3::zero(), time, curve_);
    for (std::size_t a = 0; a < force_.extent(0); ++a)
      force_(a)[i] = share_(a) * density;
  }
  if (!expressions)
    return;
  for (Local c = 0; c < cells_.size(); ++c)
    visit_points(c, [&](int, const Vec3& x, double weight, const double* N) {
      for (int i = 0; i < 3; ++i) {
        const Amount& amount = options_.vector[std::size_t(i)];
        if (!amount.function)
          continue;
        const double value = weight * amount.at(x, time, curve_);
        for (int a = 0; a < cells_.nodes(c); ++a)
          force_(cells_.first(c) + a)[i] += value * N[a];
      }
    });
}

void LoadContribution::set_at_points(double time) {
  const bool pressure = options_.kind == LoadKind::pressure;
  for (Local c = 0; c < cells_.size(); ++c)
    visit_points(c, [&](int p, const Vec3& x, double, const double*) {
      const Local point = c * max_face_points + p;
      if (pressure)
        pressure_(point) = options_.pressure.at(x, time, curve_);
      for (int i = 0; !pressure && i < 3; ++i)
        traction_(point)[i] = options_.vector[static_cast<std::size_t>(i)].at(x, time, curve_);
    });
}

void LoadContribution::prepare(const NodalFields& fields) {
  if (fields.time == time_)
    return;
  if (options_.follows_surface())
    set_at_points(fields.time);
  else
    set_forces(fields.time);
  time_ = fields.time;
}

void LoadContribution::residual(const NodalFields& fields, const ResidualScatter& scatter) {
  ABUT_REQUIRE(fields.fields >= 3, "fields per node");
  const Range cells(0, cells_.size());
  if (!options_.follows_surface())
    Kokkos::parallel_for("abut::solid::dead_force", cells, DeadForce{cells_, force_, scatter});
  else if (options_.kind == LoadKind::pressure)
    Kokkos::parallel_for(
        "abut::solid::pressure", cells,
        FaceResidual<double>{{cells_, faces_, tables_, pressure_}, fields, scatter});
  else
    Kokkos::parallel_for("abut::solid::traction", cells,
                         FaceResidual<Vec3>{{cells_, faces_, tables_, traction_}, fields, scatter});
}

void LoadContribution::tangent(const NodalFields& fields, const TangentScatter& scatter) {
  if (!options_.follows_surface())
    return;
  const Range cells(0, cells_.size());
  if (options_.kind == LoadKind::pressure)
    Kokkos::parallel_for(
        "abut::solid::pressure_tangent", cells,
        FaceTangent<double>{{cells_, faces_, tables_, pressure_}, fields, scatter});
  else
    Kokkos::parallel_for("abut::solid::traction_tangent", cells,
                         FaceTangent<Vec3>{{cells_, faces_, tables_, traction_}, fields, scatter});
}

} // namespace abut::solid
