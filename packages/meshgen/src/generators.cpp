// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/generators.hpp"

#include "abut/core/error.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "abut/meshgen/merge.hpp"
#include "structured.hpp"

#include <algorithm>
#include <cmath>

namespace abut::meshgen {

namespace {

constexpr double pi = 3.14159265358979323846;

struct Axes {
  std::vector<double> x, y, z;
};

Axes uniform_axes(const Size& size, const Divisions& divisions, const Size& origin) {
  return {uniform_axis(origin[0], origin[0] + size[0], divisions[0]),
          uniform_axis(origin[1], origin[1] + size[1], divisions[1]),
          uniform_axis(origin[2], origin[2] + size[2], divisions[2])};
}

void turn_about(double* x, double cx, double cy, double degrees) {
  const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
  const double dx = x[0] - cx, dy = x[1] - cy;
  x[0] = cx + c * dx - s * dy;
  x[1] = cy + s * dx + c * dy;
}

/// Turns the nodes inside the outline; the angle fades to zero on the outline and at the top.
void swirl(mesh::MeshData& mesh, const Size& size, const Size& origin, double degrees) {
  if (degrees == 0.0)
    return;
  if (std::abs(degrees) > 30.0)
    throw InputError("rotation must lie between -30 and 30 degrees");
  const double cx = origin[0] + 0.5 * size[0], cy = origin[1] + 0.5 * size[1];
  for (std::size_t i = 0; i < mesh.x.size(); i += 3) {
    double* x = &mesh.x[i];
    const double u = (x[0] - cx) / (0.5 * size[0]), v = (x[1] - cy) / (0.5 * size[1]);
    const double w = (x[2] - origin[2]) / size[2];
    turn_about(x, cx, cy, degrees * (1.0 - u * u) * (1.0 - v * v) * (1.0 - w));
  }
}

/// A new node keeps the mean distance of its corners from the z axis.
Vec3 onto_circle(const Vec3& centre, const Vec3* corners, int count) {
  double radius = 0.0;
  for (int i = 0; i < count; ++i)
    radius += std::hypot(corners[i][0], corners[i][1]) / count;
  const double now = std::hypot(centre[0], centre[1]);
  return {{centre[0] * radius / now, centre[1] * radius / now, centre[2]}};
}

mesh::MeshData ring(double inner, double outer, int n_theta, int n_r, const RingsOptions& o,
                    const std::string& name) {
  SideNames sides{name + "_inner", name + "_outer", "y0", "x0", "z0", "z1"};
  mesh::MeshData mesh =
      structured_block(uniform_axis(inner, outer, n_r), uniform_axis(0.0, 90.0, n_theta),
                       uniform_axis(0.0, o.thickness, o.thickness_divisions), name, sides);
  for (std::size_t i = 0; i < mesh.x.size(); i += 3) {
    const double r = mesh.x[i], angle = mesh.x[i + 1] * pi / 180.0;
    // Exact zeros on the symmetry planes.
    mesh.x[i] = mesh.x[i + 1] == 90.0 ? 0.0 : r * std::cos(angle);
    mesh.x[i + 1] = mesh.x[i + 1] == 90.0 ? r : r * std::sin(angle);
  }
  return convert(mesh, o.element, onto_circle);
}

/// Lowers the flanks of the top of the first block, and all below it in proportion.
void lower_flanks(mesh::MeshData& mesh, const BlockPairOptions& o) {
  const double middle = 0.5 * o.lower_size[0], height = o.lower_size[2];
  std::vector<char> done(mesh.x.size() / 3, 0);
  for (const Global node : mesh.blocks[0].nodes) {
    const auto n = static_cast<std::size_t>(node);
    double* x = &mesh.x[3 * n];
    const double beyond = std::max(0.0, std::abs(x[0] - middle) - o.flat);
    if (!done[n])
      x[2] -= o.drop * beyond * beyond * (x[2] + height) / height;
    done[n] = 1;
  }
}

} // namespace

mesh::MeshData box(const BoxOptions& o) {
  const Axes axes = uniform_axes(o.size, o.divisions, o.origin);
  const std::string& p = o.prefix;
  mesh::MeshData mesh = structured_block(
      axes.x, axes.y, axes.z, o.name, {p + "x0", p + "x1", p + "y0", p + "y1", p + "z0", p + "z1"});
  distort(mesh, axes.x, axes.y, axes.z, o.distortion, 1);
  mesh = convert(mesh, o.element);
  mesh.title = "box";
  node_sets_from_side_sets(mesh);
  return mesh;
}

mesh::MeshData block_pair(const BlockPairOptions& o) {
  const auto sides = [](const std::string& b, const std::string& z0, const std::string& z1) {
    return SideNames{b + "_x0", b + "_x1", b + "_y0", b + "_y1", b + z0, b + z1};
  };
  const Axes lower_axes = uniform_axes(o.lower_size, o.lower_divisions, {0, 0, -o.lower_size[2]});
  mesh::MeshData mesh = structured_block(lower_axes.x, lower_axes.y, lower_axes.z, "lower",
                                         sides("lower", "_bottom", "_top"));
  distort(mesh, lower_axes.x, lower_axes.y, lower_axes.z, o.distortion, 1);

  const Size corner{0.5 * (o.lower_size[0] - o.upper_size[0]) + o.shift,
                    0.5 * (o.lower_size[1] - o.upper_size[1]), o.gap};
  const Axes axes = uniform_axes(o.upper_size, o.upper_divisions, corner);
  mesh::MeshData upper =
      structured_block(axes.x, axes.y, axes.z, "upper", sides("upper", "_bottom", "_top"));
  distort(upper, axes.x, axes.y, axes.z, o.distortion, 2);
  swirl(upper, o.upper_size, corner, o.rotation);
  if (o.turn != 0.0)
    for (std::size_t i = 0; i < upper.x.size(); i += 3)
      turn_about(&upper.x[i], 0.5 * o.lower_size[0], 0.5 * o.lower_size[1], o.turn);

  append(mesh, upper);
  mesh = convert(mesh, o.element);
  lower_flanks(mesh, o);
  mesh.title = "pair of blocks";
  node_sets_from_side_sets(mesh);
  return mesh;
}

mesh::MeshData rings(const RingsOptions& o) {
  if (!(o.inner_radius > 0.0))
    throw InputError("inner_radius must be positive");
  mesh::MeshData mesh =
      ring(o.inner_radius, o.interface_radius, o.inner_theta, o.inner_r, o, "inner");
  append(mesh,
         ring(o.interface_radius + o.gap, o.outer_radius, o.outer_theta, o.outer_r, o, "outer"));
  mesh.title = "two quarter rings";
  node_sets_from_side_sets(mesh);
  return mesh;
}

mesh::MeshData hertz_block(const HertzBlockOptions& o) {
  if (o.facets < 1 || !(o.core > 0.0) || o.core > o.size)
    throw InputError("hertz_block needs facets >= 1 and 0 < core <= size");
  const double depth = o.depth < 0.0 ? 0.125 * o.core : o.depth;
  if (!(depth <= o.size))
    throw InputError("depth must be at most the size");
  const double limit = o.max_size > 0.0 ? o.max_size : 0.2 * o.size;
  const double h = o.core / o.facets;
  const std::vector<double> x = graded_axis(o.size, {o.core, h, o.growth, limit});
  const std::vector<double> down = graded_axis(o.size, {depth, h, o.growth, limit});
  std::vector<double> z;
  for (auto d = down.rbegin(); d != down.rend(); ++d)
    z.push_back(-*d + 0.0);
  mesh::MeshData mesh =
      structured_block(x, x, z, "block", {"x0", "x1", "y0", "y1", "bottom", "top"});
  const Global origin = static_cast<Global>(x.size() * x.size() * (z.size() - 1));
  const double reach = 2.0 * o.core * (1.0 + 1e-9);
  add_side_set(mesh, "contact", [&](Global n) {
    const double* p = &mesh.x[3 * n];
    return p[2] == 0.0 && std::hypot(p[0], p[1]) <= reach;
  });
  mesh = convert(mesh, o.element);
  mesh.title = "block for an indenter at its corner";
  node_sets_from_side_sets(mesh);
  mesh.node_sets["origin"] = {origin};
  return mesh;
}

} // namespace abut::meshgen
