// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/load_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solid/face_kernel.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abut::solid {
namespace {

constexpr int max_fields = 8;
constexpr int max_face_points = 9;

Vec3 position(const mesh::Mesh& mesh, Local node) {
  const double* x = mesh.x.data() + static_cast<std::size_t>(node) * 3;
  return {{x[0], x[1], x[2]}};
}

/// Current positions of a face's nodes.
template <int n> struct CurrentFace {
  Vec3 x[n];
  CurrentFace(const mesh::Mesh& mesh, const Local* nodes, const NodalFields& fields) {
    for (int a = 0; a < n; ++a) {
      const double* u = fields.u + static_cast<std::size_t>(nodes[a]) * fields.fields;
      x[a] = position(mesh, nodes[a]) + Vec3{{u[0], u[1], u[2]}};
    }
  }
};

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
    : mesh_(mesh), options_(options), curve_(std::move(curve)),
      time_(std::numeric_limits<double>::quiet_NaN()) {
  ABUT_REQUIRE(mesh.dim == 3, "loads are three-dimensional");
  switch (options_.kind) {
  case LoadKind::traction:
  case LoadKind::pressure:
    set_faces();
    break;
  case LoadKind::body_force:
    set_body_force();
    break;
  case LoadKind::force:
    set_nodal_force();
    break;
  }
  if (!options_.follows_surface())
    set_shares();
}

void LoadContribution::add_cell(const Local* nodes, int count) {
  for (int a = 0; a < count; ++a) {
    nodes_.push_back(nodes[a]);
    connectivity_.nodes.push_back(mesh_.node[nodes[a]]);
  }
  connectivity_.offsets.push_back(static_cast<Local>(nodes_.size()));
}

void LoadContribution::set_faces() {
  const auto found = mesh_.side_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh_.side_sets.end(), "no side set '" + options_.place + "'");
  for (const mesh::Side& s : found->second) {
    const mesh::Block& block = mesh_.blocks[s.block];
    const fem::CellSide& side = fem::side(block.type, s.side);
    const std::size_t first = static_cast<std::size_t>(s.element) * fem::info(block.type).nodes;
    const int n = fem::face_nodes(side.type);
    Local nodes[fem::max_face_nodes];
    for (int a = 0; a < n; ++a)
      nodes[a] = block.nodes[first + side.nodes[a]];
    add_cell(nodes, n);
    faces_.push_back(side.type);
  }
}

void LoadContribution::set_body_force() {
  const auto block = std::find_if(mesh_.blocks.begin(), mesh_.blocks.end(),
                                  [&](const mesh::Block& b) { return b.name == options_.place; });
  ABUT_REQUIRE(block != mesh_.blocks.end(), "no block '" + options_.place + "'");
  type_ = block->type;
  const int n = fem::info(type_).nodes;
  for (Local e = 0; e < block->size(); ++e)
    add_cell(block->nodes.data() + static_cast<std::size_t>(e) * n, n);
}

void LoadContribution::set_nodal_force() {
  const auto found = mesh_.node_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh_.node_sets.end(), "no node set '" + options_.place + "'");
  for (const Local node : found->second)
    if (node < mesh_.num_owned)
      add_cell(&node, 1);
}

/// visit(point, reference position, weight, N) for the points of a cell of the connectivity.
template <class Visit> void LoadContribution::visit_points(Local cell, const Visit& visit) const {
  const Local first = connectivity_.offsets[cell], count = connectivity_.size(cell);
  Vec3 x[fem::max_cell_nodes];
  for (Local a = 0; a < count; ++a)
    x[a] = position(mesh_, nodes_[first + a]);
  if (options_.kind == LoadKind::force) {
    const double one = 1.0;
    visit(0, x[0], 1.0, &one);
  } else if (options_.kind == LoadKind::body_force) {
    fem::dispatch_cell(type_, [&](auto shape) { visit_cell<decltype(shape)::type>(x, visit); });
  } else {
    fem::dispatch_face(faces_[cell],
                       [&](auto shape) { visit_face<decltype(shape)::type>(x, visit); });
  }
}

void LoadContribution::set_shares() {
  share_.assign(nodes_.size(), 0.0);
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    double* share = share_.data() + connectivity_.offsets[c];
    visit_points(c, [&](int, const Vec3&, double weight, const double* N) {
      for (Local a = 0; a < connectivity_.size(c); ++a)
        share[a] += weight * N[a];
    });
  }
}

void LoadContribution::set_forces(double time) {
  force_.assign(3 * nodes_.size(), 0.0);
  bool expressions = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Amount& amount = options_.vector[i];
    expressions = expressions || amount.function;
    if (!amount.function)
      for (std::size_t a = 0; a < nodes_.size(); ++a)
        force_[3 * a + i] = share_[a] * amount.at(Vec3::zero(), time, curve_);
  }
  if (!expressions)
    return;
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    double* force = force_.data() + 3 * connectivity_.offsets[c];
    visit_points(c, [&](int, const Vec3& x, double weight, const double* N) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!options_.vector[i].function)
          continue;
        const double value = weight * options_.vector[i].at(x, time, curve_);
        for (Local a = 0; a < connectivity_.size(c); ++a)
          force[3 * static_cast<std::size_t>(a) + i] += value * N[a];
      }
    });
  }
}

void LoadContribution::set_at_points(double time) {
  const bool pressure = options_.kind == LoadKind::pressure;
  const auto size = static_cast<std::size_t>(connectivity_.cells()) * max_face_points;
  pressure_.resize(pressure ? size : 0);
  traction_.resize(pressure ? 0 : size);
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    const std::size_t first = static_cast<std::size_t>(c) * max_face_points;
    visit_points(c, [&](int p, const Vec3& x, double, const double*) {
      const std::size_t point = first + static_cast<std::size_t>(p);
      if (pressure)
        pressure_[point] = options_.pressure.at(x, time, curve_);
      for (int i = 0; !pressure && i < 3; ++i)
        traction_[point][i] = options_.vector[static_cast<std::size_t>(i)].at(x, time, curve_);
    });
  }
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
  ABUT_REQUIRE(fields.fields >= 3 && fields.fields <= max_fields, "fields per node");
  double out[fem::max_cell_nodes * max_fields] = {};
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    const Local first = connectivity_.offsets[c], count = connectivity_.size(c);
    if (options_.follows_surface()) {
      const std::size_t point = static_cast<std::size_t>(c) * max_face_points;
      fem::dispatch_face(faces_[c], [&](auto shape) {
        constexpr int n = decltype(shape)::nodes;
        const auto& reference = reference_face<decltype(shape)::type>();
        const CurrentFace<n> face(mesh_, nodes_.data() + first, fields);
        Vec3 r[n];
        if (options_.kind == LoadKind::pressure)
          pressure_residual(reference, pressure_.data() + point, face.x, r);
        else
          traction_residual(reference, traction_.data() + point, face.x, r);
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            out[a * fields.fields + i] = r[a][i];
      });
    } else {
      for (Local a = 0; a < count; ++a)
        for (int i = 0; i < 3; ++i)
          out[a * fields.fields + i] = -force_[3 * static_cast<std::size_t>(first + a) + i];
    }
    scatter.add(c, out);
  }
}

void LoadContribution::tangent(const NodalFields& fields, const TangentScatter& scatter) {
  if (!options_.follows_surface())
    return;
  TangentScatter displacement = scatter; // adds the displacement part of each node block only
  displacement.fields = 3;
  for (Local c = 0; c < connectivity_.cells(); ++c)
    fem::dispatch_face(faces_[c], [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      const auto& reference = reference_face<decltype(shape)::type>();
      const CurrentFace<n> face(mesh_, nodes_.data() + connectivity_.offsets[c], fields);
      const std::size_t point = static_cast<std::size_t>(c) * max_face_points;
      double k[9 * n * n];
      if (options_.kind == LoadKind::pressure)
        pressure_tangent(reference, pressure_.data() + point, face.x, k);
      else
        traction_tangent(reference, traction_.data() + point, face.x, k);
      displacement.add(c, k);
    });
}

} // namespace abut::solid
