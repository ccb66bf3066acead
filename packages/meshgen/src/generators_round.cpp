// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "abut/meshgen/merge.hpp"
#include "structured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace abut::meshgen {

namespace {

constexpr double pi = 3.14159265358979323846;
/// How far the inner cube bulges towards a ball: 0 a cube, 1 a ball. 0.6 gives good angles both at
/// its edges and at the sphere.
constexpr double bulge = 0.6;

/// Place in the grid of an inner cube (i, j, k) continued by shells: k grows downwards from the
/// centre; a node in a shell has the indices of the cube's surface below it.
struct Place {
  int i, j, k, shell;
  bool operator<(const Place& o) const {
    return std::array<int, 4>{i, j, k, shell} < std::array<int, 4>{o.i, o.j, o.k, o.shell};
  }
};

/// The rays and shells that both bodies share, as seen from the centre.
struct Grid {
  double radius = 1.0, half = 0.5; ///< of the body, of the inner cube
  std::vector<double> tangent;     ///< (N+1) x/z of the rays on the cube's lower face
  std::vector<double> height;      ///< (M+1) 0..1 from the centre to the lower face
  std::vector<double> shell;       ///< (L+1) 0..1 from the inner cube to the surface

  int lateral() const { return static_cast<int>(tangent.size()) - 1; }
  int vertical() const { return static_cast<int>(height.size()) - 1; }
  int shells() const { return static_cast<int>(shell.size()) - 1; }

  /// Position of a point of the cube (c, largest component at most 1) moved out by a shell.
  Vec3 position(const Vec3& c, int layer) const {
    const double xx = c[0] * c[0], yy = c[1] * c[1], zz = c[2] * c[2];
    // Zero at the poles, 1 - 1/sqrt(3) and about 1 - 1/sqrt(2) at corners and edges of the cube.
    const double pull = 1.0 - 1.0 / std::sqrt(1.0 + (xx * yy + yy * zz + zz * xx) * (2.0 / 3.0));
    const Vec3 inner = half * (1.0 - bulge * pull) * c;
    if (layer == 0)
      return inner;
    const Vec3 outer = (radius / norm(c)) * c;
    return inner + shell[layer] * (outer - inner);
  }
};

Grid make_grid(const RoundOptions& o) {
  if (!(o.radius > 0.0))
    throw InputError("radius must be positive");
  if (o.facets < 1 || !(o.core > 0.0) || o.core > 0.5 * o.radius)
    throw InputError("a round body needs facets >= 1 and 0 < core <= radius / 2");
  const double depth = o.depth < 0.0 ? 0.125 * o.core : o.depth;
  if (!(depth <= o.radius))
    throw InputError("depth must be at most the radius");
  const double limit = o.max_size > 0.0 ? o.max_size : 0.2 * o.radius;
  const double h = o.core / o.facets;
  Grid g;
  g.radius = o.radius;
  for (double arc : graded_axis(0.25 * pi * o.radius, {o.core, h, o.growth, limit}))
    g.tangent.push_back(std::tan(arc / o.radius));
  g.tangent.back() = 1.0;

  const std::vector<double> down = graded_axis(o.radius, {depth, h, o.growth, limit});
  const int last = static_cast<int>(down.size()) - 1;
  int split = 1;
  while (split < last - 1 && down[split] < 0.45 * o.radius)
    ++split;
  if (split >= last)
    throw InputError("the round body is too coarse: more facets are needed");
  g.half = o.radius - down[split];
  for (int k = last; k >= split; --k)
    g.height.push_back((o.radius - down[k]) / g.half);
  for (int l = split; l >= 0; --l)
    g.shell.push_back((down[split] - down[l]) / down[split]);
  return g;
}

/// Hex8 cells over places; turns the cells that are left-handed.
class Builder {
public:
  using Position = std::function<Vec3(const Place&)>;
  Builder(std::string block, Position position) : position_(std::move(position)) {
    mesh_.blocks.resize(1);
    mesh_.blocks[0].id = 1;
    mesh_.blocks[0].name = std::move(block);
  }

  /// corner: the eight places in the order of hex8, either hand.
  void add(const std::array<Place, 8>& corner) {
    std::array<Global, 8> n;
    for (int a = 0; a < 8; ++a)
      n[a] = node(corner[a]);
    const auto x = [&](int a) -> Vec3 {
      return {{mesh_.x[3 * n[a]], mesh_.x[3 * n[a] + 1], mesh_.x[3 * n[a] + 2]}};
    };
    if (dot(cross(x(1) - x(0), x(3) - x(0)), x(4) - x(0)) < 0.0)
      n = {n[4], n[5], n[6], n[7], n[0], n[1], n[2], n[3]};
    auto& nodes = mesh_.blocks[0].nodes;
    nodes.insert(nodes.end(), n.begin(), n.end());
  }

  mesh::MeshData& mesh() { return mesh_; }
  const Place& place(Global node) const { return places_[static_cast<std::size_t>(node)]; }

private:
  Global node(const Place& p) {
    const auto [entry, is_new] = number_.emplace(p, static_cast<Global>(places_.size()));
    if (is_new) {
      places_.push_back(p);
      const Vec3 x = position_(p);
      mesh_.x.insert(mesh_.x.end(), {x[0], x[1], x[2]});
    }
    return entry->second;
  }

  mesh::MeshData mesh_;
  Position position_;
  std::map<Place, Global> number_;
  std::vector<Place> places_;
};

/// Corners of a hex8 as offsets (0 or 1) in its three directions.
const int hex_offset[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// Adds a cell of each point of a (na x nb x nc) grid.
template <class F> void add_cells(Builder& builder, int na, int nb, int nc, const F& place_of) {
  require_cells(double(na) * double(nb) * double(nc), 2e6);
  for (int c = 0; c < nc; ++c)
    for (int b = 0; b < nb; ++b)
      for (int a = 0; a < na; ++a) {
        std::array<Place, 8> corner;
        for (int n = 0; n < 8; ++n)
          corner[n] = place_of(a + hex_offset[n][0], b + hex_offset[n][1], c + hex_offset[n][2]);
        builder.add(corner);
      }
}

void add_common_side_sets(Builder& builder, const RoundOptions& o, int shells, bool sphere) {
  mesh::MeshData& mesh = builder.mesh();
  const auto curved = [&](Global n) { return builder.place(n).shell == shells; };
  const double reach = 2.0 * o.core * (1.0 + 1e-9);
  add_side_set(mesh, "curved", curved);
  add_side_set(mesh, "contact", [&](Global n) {
    return curved(n) && std::hypot(mesh.x[3 * n], sphere ? mesh.x[3 * n + 1] : 0.0) <= reach &&
           mesh.x[3 * n + 2] < o.gap + o.radius;
  });
  add_side_set(mesh, "top", [&](Global n) { return builder.place(n).k == 0; });
  add_side_set(mesh, "x0", [&](Global n) { return builder.place(n).i == 0; });
}

void add_plate(mesh::MeshData& mesh, const RoundOptions& o, double y0, double y1, int y_divisions) {
  const double reach = o.plate_size > 0.0 ? o.plate_size : 2.5 * o.core;
  const double thickness = o.plate_thickness > 0.0 ? o.plate_thickness : o.core;
  const mesh::MeshData plate = structured_block(
      uniform_axis(-0.5 * o.core, reach, o.plate_divisions), uniform_axis(y0, y1, y_divisions),
      uniform_axis(-thickness, 0.0, 1), "plate", {"", "", "", "", "plate_bottom", "plate_top"});
  append(mesh, plate);
}

/// New nodes between nodes of the surface go on the surface; `along` masks the axis of a cylinder.
Projection onto_surface(double radius, double height, const Vec3& along) {
  return [=](const Vec3& centre, const Vec3* corners, int count) {
    const auto from_axis = [&](const Vec3& x) -> Vec3 {
      return {{x[0] * along[0], x[1] * along[1], (x[2] - height) * along[2]}};
    };
    for (int i = 0; i < count; ++i)
      if (std::abs(norm(from_axis(corners[i])) - radius) > 1e-9 * radius)
        return centre;
    const Vec3 ray = from_axis(centre);
    return centre + (radius / norm(ray) - 1.0) * ray;
  };
}

} // namespace

mesh::MeshData quarter_sphere(const RoundOptions& o) {
  const Grid g = make_grid(o);
  const int n = g.lateral(), m = g.vertical(), shells = g.shells();
  const double height = o.gap + o.radius;
  Builder builder("sphere", [&](const Place& p) -> Vec3 {
    const Vec3 x = g.position({{g.tangent[p.i], g.tangent[p.j], g.height[p.k]}}, p.shell);
    return {{x[0], x[1],
             p.i == 0 && p.j == 0 && p.shell == shells && p.k == m ? o.gap : height - x[2]}};
  });
  add_cells(builder, n, n, shells, [&](int a, int b, int c) { return Place{a, b, m, shells - c}; });
  add_cells(builder, n, n, m, [](int a, int b, int c) { return Place{a, b, c, 0}; });
  add_cells(builder, n, m, shells, [&](int a, int b, int c) { return Place{n, a, b, c}; });
  add_cells(builder, n, m, shells, [&](int a, int b, int c) { return Place{a, n, b, c}; });
  add_common_side_sets(builder, o, shells, true);
  add_side_set(builder.mesh(), "y0", [&](Global node) { return builder.place(node).j == 0; });

  if (o.element == fem::CellType::wedge6)
    throw InputError("a sphere cannot be made of wedge6 cells: it is not a stack of layers; use "
                     "hex8, hex20, hex27, tet4 or tet10");
  mesh::MeshData mesh =
      convert(builder.mesh(), o.element, onto_surface(o.radius, height, {{1.0, 1.0, 1.0}}));
  if (o.plate)
    add_plate(mesh, o, -0.5 * o.core, o.plate_size > 0.0 ? o.plate_size : 2.5 * o.core,
              o.plate_divisions);
  mesh.title = "quarter sphere";
  node_sets_from_side_sets(mesh);
  mesh.node_sets["pole"] = {0};
  return mesh;
}

mesh::MeshData quarter_cylinder(const CylinderOptions& o) {
  const Grid g = make_grid(o);
  const int n = g.lateral(), m = g.vertical(), shells = g.shells();
  const double height = o.gap + o.radius;
  const std::vector<double> y = uniform_axis(0.0, o.thickness, o.thickness_divisions);
  const int layers = o.thickness_divisions;
  Builder builder("cylinder", [&](const Place& p) -> Vec3 {
    const Vec3 x = g.position({{g.tangent[p.i], 0.0, g.height[p.k]}}, p.shell);
    const bool lowest = p.i == 0 && p.shell == shells && p.k == m;
    return {{x[0], y[p.j], lowest ? o.gap : height - x[2]}};
  });
  // The third direction of each cell is the cylinder's axis, so that wedges can be cut.
  add_cells(builder, n, shells, layers, [&](int a, int b, int c) {
    return Place{a, c, m, shells - b};
  });
  add_cells(builder, n, m, layers, [](int a, int b, int c) { return Place{a, c, b, 0}; });
  add_cells(builder, m, shells, layers, [&](int a, int b, int c) { return Place{n, c, a, b}; });
  add_common_side_sets(builder, o, shells, false);
  add_side_set(builder.mesh(), "y0", [&](Global node) { return builder.place(node).j == 0; });
  add_side_set(builder.mesh(), "y1", [&](Global node) { return builder.place(node).j == layers; });

  mesh::MeshData mesh =
      convert(builder.mesh(), o.element, onto_surface(o.radius, height, {{1.0, 0.0, 1.0}}));
  if (o.plate)
    add_plate(mesh, o, 0.0, o.thickness, o.thickness_divisions);
  mesh.title = "quarter cylinder";
  node_sets_from_side_sets(mesh);
  mesh.node_sets["pole"].clear();
  for (Global node = 0; node < static_cast<Global>(builder.mesh().num_nodes()); ++node) {
    const Place& p = builder.place(node);
    if (p.i == 0 && p.k == m && p.shell == shells)
      mesh.node_sets["pole"].push_back(node);
  }
  return mesh;
}

} // namespace abut::meshgen
