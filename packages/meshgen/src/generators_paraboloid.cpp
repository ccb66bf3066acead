// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/convert.hpp"
#include "abut/meshgen/graded_axis.hpp"
#include "abut/meshgen/merge.hpp"
#include "structured.hpp"

#include <cmath>

namespace abut::meshgen {

namespace {

/// Axes of a quarter block that is fine at the origin: sideways, and away from the surface.
struct Axes {
  std::vector<double> side, away;
};

Axes graded_axes(const ParaboloidOptions& o, int facets) {
  const double limit = o.max_size > 0.0 ? o.max_size : 0.2 * o.size;
  const double depth = o.depth < 0.0 ? 0.5 * o.core : o.depth;
  const double h = o.core / facets;
  return {graded_axis(o.size, {o.core, h, o.growth, limit}),
          graded_axis(o.size, {depth, h, o.growth, limit})};
}

/// Height of the lower face.
double height(const ParaboloidOptions& o, const double* x) {
  return (x[0] * x[0] + x[1] * x[1]) / (2.0 * o.radius);
}

mesh::MeshData body(const ParaboloidOptions& o) {
  const Axes axes = graded_axes(o, o.facets);
  mesh::MeshData mesh = structured_block(axes.side, axes.side, axes.away, "paraboloid",
                                         {"x0", "x1", "y0", "y1", "", "top"});
  const double reach = 2.0 * o.core * (1.0 + 1e-9);
  add_side_set(mesh, "contact", [&](Global n) {
    const double* x = &mesh.x[3 * n];
    return x[2] == 0.0 && std::hypot(x[0], x[1]) <= reach;
  });
  mesh = convert(mesh, o.element);
  for (std::size_t i = 0; i < mesh.x.size(); i += 3)
    mesh.x[i + 2] += o.gap + height(o, &mesh.x[i]);
  return mesh;
}

mesh::MeshData plate(const ParaboloidOptions& o) {
  if (o.plate_facets == 0) {
    const std::vector<double> side = uniform_axis(-o.core, 2.5 * o.core, 1);
    return structured_block(side, side, uniform_axis(-o.core, 0.0, 1), "plate",
                            {"", "", "", "", "plate_bottom", "plate_top"});
  }
  const Axes axes = graded_axes(o, o.plate_facets);
  std::vector<double> z;
  for (auto d = axes.away.rbegin(); d != axes.away.rend(); ++d)
    z.push_back(0.0 - *d);
  return convert(structured_block(axes.side, axes.side, z, "plate",
                                  {"x0", "x1", "y0", "y1", "plate_bottom", "plate_top"}),
                 o.element);
}

} // namespace

mesh::MeshData paraboloid(const ParaboloidOptions& o) {
  if (!(o.radius > 0.0))
    throw InputError("radius must be positive");
  if (o.facets < 1 || o.plate_facets < 0 || !(o.core > 0.0) || o.core > o.size)
    throw InputError("a paraboloid needs facets >= 1, plate_facets >= 0 and 0 < core <= size");
  mesh::MeshData mesh = body(o);
  append(mesh, plate(o));
  mesh.title = "paraboloid on a plate";
  node_sets_from_side_sets(mesh);
  mesh.node_sets["pole"] = {0};
  return mesh;
}

} // namespace abut::meshgen
