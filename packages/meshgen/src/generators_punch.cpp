// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "abut/meshgen/merge.hpp"
#include "structured.hpp"

#include <array>
#include <cmath>

namespace abut::meshgen {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Quadrilaterals of a quarter disc: a square of n x n cells at the centre, then shells.
struct PlaneMesh {
  std::vector<std::array<double, 2>> x;
  std::vector<std::array<Global, 4>> cells; ///< counter-clockwise
};

/// A point of the central square, (u, v) in 0..1; its outer corner is drawn in for better angles.
std::array<double, 2> in_square(double u, double v, double half) {
  const double pull = 1.0 - 0.1 * u * u * v * v; // about 120 degrees there
  return {half * pull * u, half * pull * v};
}

/// Square of half width `half`, n shells that turn it into a circle of radius radii[0], and circles
/// of the further radii. (2n+1) nodes on each shell, by growing angle.
PlaneMesh quarter_disc(int n, double half, const std::vector<double>& radii) {
  require_cells(double(n) * (3.0 * n + 2.0 * double(radii.size())));
  PlaneMesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.x.push_back(in_square(double(i) / n, double(j) / n, half));
  const auto square = [&](int i, int j) { return static_cast<Global>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mesh.cells.push_back(
          {square(i, j), square(i + 1, j), square(i + 1, j + 1), square(i, j + 1)});

  std::vector<Global> ring;
  for (int k = 0; k <= 2 * n; ++k)
    ring.push_back(k <= n ? square(n, k) : square(2 * n - k, n));
  const std::vector<Global> innermost = ring;
  const int shells = n + static_cast<int>(radii.size()) - 1;
  for (int l = 1; l <= shells; ++l) {
    std::vector<Global> next;
    const double radius = radii[std::max(l - n, 0)], blend = std::min(1.0, double(l) / n);
    for (int k = 0; k <= 2 * n; ++k) {
      const double angle = 0.25 * pi * k / n;
      // Exact zeros on the symmetry planes.
      const double on_circle[2] = {k == 2 * n ? 0.0 : radius * std::cos(angle),
                                   k == 0 ? 0.0 : radius * std::sin(angle)};
      std::array<double, 2> x = mesh.x[innermost[k]];
      for (int d = 0; d < 2; ++d)
        x[d] += blend * (on_circle[d] - x[d]);
      next.push_back(static_cast<Global>(mesh.x.size()));
      mesh.x.push_back(blend == 1.0 ? std::array<double, 2>{on_circle[0], on_circle[1]} : x);
    }
    for (int k = 0; k < 2 * n; ++k)
      mesh.cells.push_back({ring[k], next[k], next[k + 1], ring[k + 1]});
    ring = next;
  }
  return mesh;
}

mesh::MeshData extrude(const PlaneMesh& plane, const std::vector<double>& z,
                       const std::string& name) {
  require_cells(double(plane.cells.size()) * double(z.size()));
  mesh::MeshData mesh;
  for (double c : z)
    for (const auto& p : plane.x)
      mesh.x.insert(mesh.x.end(), {p[0], p[1], c});
  mesh::BlockData block;
  block.id = 1;
  block.name = name;
  const Global layer = static_cast<Global>(plane.x.size());
  for (Global k = 0; k + 1 < static_cast<Global>(z.size()); ++k)
    for (const auto& cell : plane.cells)
      for (Global level : {k, k + 1})
        for (Global n : cell)
          block.nodes.push_back(level * layer + n);
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

void require_valid(const PunchOptions& o) {
  if (!(o.radius > 0.0) || o.facets < 1 || !(o.size > 2.0 * o.radius))
    throw InputError("punch needs radius > 0, facets >= 1 and size > 2 radius");
  if (!(o.offset >= 0.0) || !(o.offset < 1.0))
    throw InputError("offset must be at least 0 and less than 1");
  if (o.shape == PunchShape::disc && (o.facets % 2 != 0 || o.punch_divisions % 2 != 0))
    throw InputError("a disc needs even facets and punch_divisions");
  if (o.element == fem::CellType::wedge6)
    throw InputError("a punch mesh is not made of wedge6 cells");
}

std::vector<double> negated(const std::vector<double>& down) {
  std::vector<double> z;
  for (auto d = down.rbegin(); d != down.rend(); ++d)
    z.push_back(0.0 - *d);
  return z;
}

/// Circles keep their radius; cells inside the first one have straight sides.
Projection onto_circles(double first) {
  return [=](const Vec3& centre, const Vec3* corners, int count) -> Vec3 {
    double radius = 0.0;
    for (int i = 0; i < count; ++i) {
      const double r = std::hypot(corners[i][0], corners[i][1]);
      if (r < first * (1.0 - 1e-9))
        return centre;
      radius += r / count;
    }
    const double now = std::hypot(centre[0], centre[1]);
    return {{centre[0] * radius / now, centre[1] * radius / now, centre[2]}};
  };
}

mesh::MeshData body(const PunchOptions& o) {
  const double h = o.radius / (o.facets - o.offset), edge = o.facets * h;
  const double limit = o.max_size > 0.0 ? o.max_size : 0.2 * o.size;
  const bool strip = o.shape == PunchShape::strip;
  const std::vector<double> z = negated(graded_axis(o.size, {0.5 * o.radius, h, o.growth, limit}));
  mesh::MeshData mesh;
  if (strip) {
    const std::vector<double> x =
        graded_axis(o.size, {(o.facets + (o.facets + 1) / 2) * h, h, o.growth, limit});
    mesh = structured_block(x, {0.0, o.thickness}, z, "body",
                            {"x0", "side", "y0", "y1", "bottom", "top"});
  } else {
    std::vector<double> radii;
    for (double r : graded_axis(o.size - edge, {o.facets / 2 * h, h, o.growth, limit}))
      radii.push_back(edge + r);
    mesh = extrude(quarter_disc(o.facets / 2, 0.5 * edge, radii), z, "body");
    const auto at = [&](Global n, int d) { return mesh.x[3 * n + d]; };
    add_side_set(mesh, "x0", [&](Global n) { return at(n, 0) == 0.0; });
    add_side_set(mesh, "y0", [&](Global n) { return at(n, 1) == 0.0; });
    add_side_set(mesh, "bottom", [&](Global n) { return at(n, 2) == z.front(); });
    add_side_set(mesh, "top", [&](Global n) { return at(n, 2) == 0.0; });
    add_side_set(mesh, "side",
                 [&](Global n) { return std::hypot(at(n, 0), at(n, 1)) > o.size * (1.0 - 1e-9); });
  }
  add_side_set(mesh, "contact", [&](Global n) {
    const double* p = &mesh.x[3 * n];
    return p[2] == 0.0 && std::hypot(p[0], strip ? 0.0 : p[1]) <= 2.0 * o.radius;
  });
  return strip ? convert(mesh, o.element) : convert(mesh, o.element, onto_circles(edge));
}

mesh::MeshData rigid_part(const PunchOptions& o) {
  const double height = 0.5 * o.radius;
  if (o.shape == PunchShape::strip)
    return structured_block(uniform_axis(0.0, o.radius, o.punch_divisions), {0.0, o.thickness},
                            {0.0, height}, "punch", {"", "", "", "", "punch_bottom", "punch_top"});
  const double corner = 0.5 * pi / o.punch_divisions; // angle between corners of the outline
  const double radius = o.radius * std::sqrt(corner / std::sin(corner));
  mesh::MeshData mesh =
      extrude(quarter_disc(o.punch_divisions / 2, 0.5 * radius, {radius}), {0.0, height}, "punch");
  add_side_set(mesh, "punch_bottom", [&](Global n) { return mesh.x[3 * n + 2] == 0.0; });
  add_side_set(mesh, "punch_top", [&](Global n) { return mesh.x[3 * n + 2] == height; });
  return mesh;
}

} // namespace

mesh::MeshData punch(const PunchOptions& o) {
  require_valid(o);
  mesh::MeshData mesh = body(o);
  append(mesh, rigid_part(o));
  mesh.title = "flat punch on a body";
  node_sets_from_side_sets(mesh);
  return mesh;
}

} // namespace abut::meshgen
