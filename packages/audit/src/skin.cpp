// SPDX-License-Identifier: BSD-3-Clause
#include "skin.hpp"

#include "abut/fem/face_map.hpp"
#include "abut/fem/measure.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace abut::audit {

namespace {

constexpr Global sides_per_element = 8; // as in the ids of faces

Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

/// The cell of the corners alone.
fem::CellType straight(int corners) {
  return corners == 4   ? fem::CellType::tet4
         : corners == 6 ? fem::CellType::wedge6
                        : fem::CellType::hex8;
}

/// Volume over area: the height of a brick, and with a factor of a tetrahedron.
double depth_behind(const mesh::Mesh& mesh, const Skin& skin, Local face,
                    const std::vector<Vec3>& x, double area) {
  const mesh::Block& block = mesh.blocks[std::size_t(skin.block[std::size_t(face)])];
  const fem::CellInfo& cell = fem::info(block.type);
  Vec3 y[fem::max_cell_nodes];
  for (int a = 0; a < cell.corners; ++a)
    y[a] = x[std::size_t(
        block.nodes[std::size_t(skin.element[std::size_t(face)]) * std::size_t(cell.nodes) +
                    std::size_t(a)])];
  return (cell.corners == 4 ? 3.0 : 1.0) * fem::measure_cell(straight(cell.corners), y).volume /
         area;
}

void add_geometry(const mesh::Mesh& mesh, Skin& skin) {
  std::vector<Vec3> x(mesh.node.size());
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = {{mesh.x[3 * n], mesh.x[3 * n + 1], mesh.x[3 * n + 2]}};
  for (Local f = 0; f < skin.faces(); ++f) {
    Vec3 y[fem::max_face_nodes];
    face_nodes_at(skin, f, x, y);
    const double area = fem::face_area(skin.type(f), y);
    skin.size.push_back(std::sqrt(area));
    skin.scale.push_back(std::min(skin.size.back(), depth_behind(mesh, skin, f, x, area)));
  }
}

} // namespace

Skin make_skin(const mesh::Mesh& mesh) {
  Skin skin;
  skin.surface = mesh::outer_surface(mesh);
  std::unordered_map<Global, std::pair<int, Local>> place;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (Local e = 0; e < mesh.blocks[b].size(); ++e)
      place[mesh.blocks[b].element[std::size_t(e)]] = {static_cast<int>(b), e};
  for (const Global id : skin.surface.face_id) {
    const auto [block, element] = place.at(id / sides_per_element);
    skin.block.push_back(block);
    skin.element.push_back(element);
  }
  add_geometry(mesh, skin);
  return skin;
}

void face_nodes_at(const Skin& skin, Local face, const std::vector<Vec3>& x, Vec3* y) {
  const int nodes = fem::face_nodes(skin.type(face));
  for (int a = 0; a < nodes; ++a)
    y[a] = x[std::size_t(skin.node(face, a))];
}

std::array<Vec3, 4> corner_normals(fem::FaceType type, const Vec3* y) {
  std::array<Vec3, 4> normals{};
  const int corners = fem::face_corners(type);
  for (int a = 0; a < corners; ++a) {
    if (fem::face_nodes(type) == corners) {
      const Vec3 next = y[(a + 1) % corners] - y[a];
      normals[std::size_t(a)] = unit(cross(next, y[(a + corners - 1) % corners] - y[a]));
      continue;
    }
    double xi[2];
    fem::FacePoint<double> at;
    fem::dispatch_face(type, [&](auto shape) { decltype(shape)::node(a, xi); });
    fem::face_point(type, y, xi, at);
    normals[std::size_t(a)] = unit(cross(at.tangent[0], at.tangent[1]));
  }
  return normals;
}

std::vector<Vec3> nodal_normals(const Skin& skin, const NodeExchange& exchange,
                                const std::vector<Vec3>& x) {
  std::vector<Vec3> normal(x.size(), Vec3::zero());
  for (Local f = 0; f < skin.faces(); ++f) {
    Vec3 y[fem::max_face_nodes];
    face_nodes_at(skin, f, x, y);
    const std::array<Vec3, 4> corner = corner_normals(skin.type(f), y);
    for (int a = 0; a < skin.corners(f); ++a)
      normal[std::size_t(skin.node(f, a))] += corner[std::size_t(a)];
  }
  double* values = normal.empty() ? nullptr : normal[0].v;
  exchange.add_to_owners(values, 3);
  exchange.to_ghosts(values, 3);
  for (Vec3& n : normal)
    n = unit(n);
  return normal;
}

} // namespace abut::audit
