// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/merge.hpp"

#include <map>
#include <string>

namespace abut::meshgen {

namespace {

/// What quarter_sphere and quarter_cylinder are to make of one of the two bodies.
template <class Round> Round one_body(const RoundPairOptions& o, double radius, int facets) {
  Round r;
  r.radius = radius;
  r.core = o.core;
  r.facets = facets;
  r.growth = o.growth;
  r.depth = o.depth;
  r.max_size = o.max_size;
  r.element = o.element;
  r.plate = false;
  return r;
}

void rename_set(mesh::MeshData& mesh, const std::string& from, const std::string& to) {
  auto set = mesh.side_sets.extract(from);
  set.key() = to;
  mesh.side_sets.insert(std::move(set));
}

void name_parts(mesh::MeshData& mesh, const std::string& body, const std::string& flat) {
  mesh.blocks[0].name = body;
  mesh.node_sets.clear();
  rename_set(mesh, "contact", body + "_contact");
  rename_set(mesh, "curved", body + "_curved");
  rename_set(mesh, "top", flat);
}

/// Turned about a horizontal line by 180 degrees, so that no element changes its hand; the two sets
/// that change places keep what their names say.
template <class Turn>
void turn_over(mesh::MeshData& mesh, const std::string& one, const std::string& other, Turn turn) {
  for (std::size_t i = 0; i < mesh.x.size(); i += 3)
    turn(&mesh.x[i]);
  std::swap(mesh.side_sets[one], mesh.side_sets[other]);
}

mesh::MeshData joined(mesh::MeshData upper, mesh::MeshData lower, const std::string& title) {
  name_parts(upper, "upper", "upper_top");
  name_parts(lower, "lower", "lower_bottom");
  append(upper, lower);
  upper.title = title;
  node_sets_from_side_sets(upper);
  return upper;
}

} // namespace

mesh::MeshData sphere_pair(const RoundPairOptions& o) {
  mesh::MeshData lower = quarter_sphere(one_body<RoundOptions>(o, o.lower_radius, o.lower_facets));
  turn_over(lower, "x0", "y0", [](double* x) {
    std::swap(x[0], x[1]);
    x[2] = 0.0 - x[2];
  });
  return joined(quarter_sphere(one_body<RoundOptions>(o, o.upper_radius, o.upper_facets)),
                std::move(lower), "two quarter balls");
}

mesh::MeshData cylinder_pair(const CylinderPairOptions& o) {
  const auto body = [&](double radius, int facets) {
    auto r = one_body<CylinderOptions>(o, radius, facets);
    r.thickness = o.thickness;
    r.thickness_divisions = o.thickness_divisions;
    return quarter_cylinder(r);
  };
  mesh::MeshData lower = body(o.lower_radius, o.lower_facets);
  turn_over(lower, "y0", "y1", [&](double* x) {
    x[1] = o.thickness - x[1];
    x[2] = 0.0 - x[2];
  });
  return joined(body(o.upper_radius, o.upper_facets), std::move(lower), "two quarter cylinders");
}

} // namespace abut::meshgen
