// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/load_contribution.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solid/face_kernel.hpp"

#include <algorithm>
#include <utility>

namespace abut::solid {
namespace {

constexpr int max_fields = 8;

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

} // namespace

LoadContribution::LoadContribution(const mesh::Mesh& mesh, const LoadOptions& options,
                                   std::function<double(double)> curve)
    : mesh_(mesh), options_(options), curve_(std::move(curve)) {
  ABUT_REQUIRE(mesh.dim == 3, "loads are three-dimensional");
  switch (options_.kind) {
  case LoadKind::traction:
    set_faces(true);
    break;
  case LoadKind::pressure:
    set_faces(false);
    break;
  case LoadKind::body_force:
    set_body_force();
    break;
  case LoadKind::force:
    set_nodal_force();
    break;
  }
}

void LoadContribution::add_cell(const Local* nodes, int count) {
  for (int a = 0; a < count; ++a) {
    nodes_.push_back(nodes[a]);
    connectivity_.nodes.push_back(mesh_.node[nodes[a]]);
  }
  connectivity_.offsets.push_back(static_cast<Local>(nodes_.size()));
}

void LoadContribution::set_faces(bool dead) {
  const auto found = mesh_.side_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh_.side_sets.end(), "no side set '" + options_.place + "'");
  for (const mesh::Side& s : found->second) {
    const mesh::Block& block = mesh_.blocks[s.block];
    const fem::CellSide& side = fem::side(block.type, s.side);
    const std::size_t first = static_cast<std::size_t>(s.element) * fem::info(block.type).nodes;
    const int n = fem::face_nodes(side.type);
    Local nodes[fem::max_face_nodes];
    Vec3 x[fem::max_face_nodes];
    for (int a = 0; a < n; ++a) {
      nodes[a] = block.nodes[first + side.nodes[a]];
      x[a] = position(mesh_, nodes[a]);
    }
    add_cell(nodes, n);
    faces_.push_back(side.type);
    if (!dead)
      continue;
    double area[fem::max_face_nodes];
    fem::dispatch_face(side.type, [&](auto shape) {
      nodal_areas(reference_face<decltype(shape)::type>(), x, area);
    });
    share_.insert(share_.end(), area, area + n);
  }
}

void LoadContribution::set_body_force() {
  const auto block = std::find_if(mesh_.blocks.begin(), mesh_.blocks.end(),
                                  [&](const mesh::Block& b) { return b.name == options_.place; });
  ABUT_REQUIRE(block != mesh_.blocks.end(), "no block '" + options_.place + "'");
  fem::dispatch_cell(block->type, [&](auto shape) {
    constexpr fem::CellType type = decltype(shape)::type;
    constexpr int n = ReferenceCell<type>::nodes;
    const ReferenceCell<type>& cell = reference_cell<type>();
    for (Local e = 0; e < block->size(); ++e) {
      const Local* nodes = block->nodes.data() + static_cast<std::size_t>(e) * n;
      double x[3][n], volume[n] = {};
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          x[i][a] = position(mesh_, nodes[a])[i];
      for (int p = 0; p < ReferenceCell<type>::points; ++p) {
        const double weight = cell.weight[p] * det(nodal_gradient(x, cell.dN[p]));
        for (int a = 0; a < n; ++a)
          volume[a] += weight * cell.N[p][a];
      }
      add_cell(nodes, n);
      share_.insert(share_.end(), volume, volume + n);
    }
  });
}

void LoadContribution::set_nodal_force() {
  const auto found = mesh_.node_sets.find(options_.place);
  ABUT_REQUIRE(found != mesh_.node_sets.end(), "no node set '" + options_.place + "'");
  for (const Local node : found->second)
    if (node < mesh_.num_owned) {
      add_cell(&node, 1);
      share_.push_back(1.0);
    }
}

void LoadContribution::residual(const NodalFields& fields, const ResidualScatter& scatter) {
  ABUT_REQUIRE(fields.fields >= 3 && fields.fields <= max_fields, "fields per node");
  const double scale = factor(fields.time);
  double out[fem::max_cell_nodes * max_fields] = {};
  for (Local c = 0; c < connectivity_.cells(); ++c) {
    const Local first = connectivity_.offsets[c], count = connectivity_.size(c);
    if (options_.kind == LoadKind::pressure) {
      fem::dispatch_face(faces_[c], [&](auto shape) {
        constexpr int n = decltype(shape)::nodes;
        const CurrentFace<n> face(mesh_, nodes_.data() + first, fields);
        Vec3 r[n];
        pressure_residual(reference_face<decltype(shape)::type>(), scale * options_.pressure,
                          face.x, r);
        for (int a = 0; a < n; ++a)
          for (int i = 0; i < 3; ++i)
            out[a * fields.fields + i] = r[a][i];
      });
    } else {
      for (Local a = 0; a < count; ++a)
        for (int i = 0; i < 3; ++i)
          out[a * fields.fields + i] = -scale * share_[first + a] * options_.vector[i];
    }
    scatter.add(c, out);
  }
}

void LoadContribution::tangent(const NodalFields& fields, const TangentScatter& scatter) {
  if (options_.kind != LoadKind::pressure)
    return;
  const double scale = factor(fields.time);
  TangentScatter displacement = scatter; // adds the displacement part of each node block only
  displacement.fields = 3;
  for (Local c = 0; c < connectivity_.cells(); ++c)
    fem::dispatch_face(faces_[c], [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      const CurrentFace<n> face(mesh_, nodes_.data() + connectivity_.offsets[c], fields);
      double k[9 * n * n];
      pressure_tangent(reference_face<decltype(shape)::type>(), scale * options_.pressure, face.x,
                       k);
      displacement.add(c, k);
    });
}

} // namespace abut::solid
