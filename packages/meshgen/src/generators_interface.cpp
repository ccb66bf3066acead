// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "abut/meshgen/merge.hpp"
#include "structured.hpp"

#include <cmath>
#include <functional>

namespace abut::meshgen {

namespace {

constexpr double pi = 3.14159265358979323846;
using Height = std::function<double(double x, double y)>;

Height height_of(const InterfaceOptions& o) {
  const double r = o.radius, w = o.width, amplitude = o.amplitude;
  switch (o.shape) {
  case InterfaceShape::plane: {
    if (!(std::abs(o.angle) < 80.0))
      throw InputError("angle must lie between -80 and 80 degrees");
    const double slope = std::tan(o.angle * pi / 180.0);
    return [=](double x, double) { return slope * (x - 0.5 * w); };
  }
  case InterfaceShape::cylinder:
    if (!(r > w))
      throw InputError("radius must be greater than width");
    return [=](double x, double) { return std::sqrt(r * r - x * x) - r; };
  case InterfaceShape::sphere:
    if (!(r > std::hypot(w, o.depth)))
      throw InputError("radius must be greater than the diagonal of width and depth");
    return [=](double x, double y) { return std::sqrt(r * r - x * x - y * y) - r; };
  case InterfaceShape::sine:
    return [=](double x, double) { return amplitude * std::sin(2.0 * pi * x / w); };
  }
  ABUT_REQUIRE(false, "unknown shape");
}

/// One block between its flat face at z = outer and the surface; `upper`: the surface is below.
mesh::MeshData block(const InterfaceOptions& o, const Height& height, bool upper) {
  const Divisions& n = upper ? o.upper_divisions : o.lower_divisions;
  const double outer = upper ? o.upper_height : -o.lower_height;
  const std::string name = upper ? "upper" : "lower", p = name + "_";
  mesh::MeshData mesh =
      structured_block(uniform_axis(0.0, o.width, n[0]), uniform_axis(0.0, o.depth, n[1]),
                       uniform_axis(0.0, 1.0, n[2]), name,
                       {p + "x0", p + "x1", p + "y0", p + "y1", p + "bottom", p + "top"});
  const std::string interface = upper ? "upper_bottom" : "lower_top";
  for (const auto& [set, sides] : std::map(mesh.side_sets))
    if (set != interface)
      mesh.side_sets[p + "outer"].insert(mesh.side_sets[p + "outer"].end(), sides.begin(),
                                         sides.end());

  const double at = upper ? 0.0 : 1.0; // third coordinate of the interface before the mapping
  const auto map = [&](double* x) {
    const double f = height(x[0], x[1]), part = upper ? 1.0 - x[2] : x[2]; // 1 on the interface
    if (upper ? f >= outer : f <= outer)
      throw InputError(p + "height is too small: the interface leaves the box");
    x[2] = x[2] == at ? f : outer + part * (f - outer);
  };
  for (std::size_t i = 0; i < mesh.x.size(); i += 3)
    map(&mesh.x[i]);
  return convert(mesh, o.element, [&](const Vec3& centre, const Vec3* corners, int count) -> Vec3 {
    for (int i = 0; i < count; ++i)
      if (corners[i][2] != height(corners[i][0], corners[i][1]))
        return centre;
    return {{centre[0], centre[1], height(centre[0], centre[1])}};
  });
}

} // namespace

mesh::MeshData interface_pair(const InterfaceOptions& o) {
  const Height height = height_of(o);
  mesh::MeshData mesh = block(o, height, false);
  append(mesh, block(o, height, true));
  mesh.title = "two blocks with a common interface";
  node_sets_from_side_sets(mesh);
  return mesh;
}

} // namespace abut::meshgen
