// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/primary_surface.hpp"

#include "abut/fem/face_map.hpp"
#include "abut/fem/quadrature.hpp"

#include <cmath>
#include <map>

namespace abut::contact {

std::vector<double> face_sizes(const mesh::Surface& s) {
  std::vector<double> sizes;
  for (Local f = 0; f < s.num_faces(); ++f) {
    Vec3 x[fem::max_face_nodes];
    for (Local a = s.offset[f]; a < s.offset[f + 1]; ++a)
      for (int i = 0; i < 3; ++i)
        x[a - s.offset[f]][i] = s.x[std::size_t(s.nodes[a]) * 3 + i];
    const fem::Rule<2> rule = fem::face_rule(s.type[f], 2);
    double area = 0.0;
    for (int p = 0; p < rule.size(); ++p) {
      fem::FacePoint<double> point;
      fem::face_point(s.type[f], x, rule.xi[p].data(), point);
      area += rule.weight[p] * norm(cross(point.tangent[0], point.tangent[1]));
    }
    sizes.push_back(std::sqrt(area));
  }
  return sizes;
}

PrimarySurface::PrimarySurface(mesh::Surface surface, const Vec3& origin, std::optional<int> points,
                               bool nodal)
    : surface_(std::move(surface)) {
  for (std::size_t k = 0; k < surface_.x.size(); ++k)
    surface_.x[k] -= origin[static_cast<int>(k % 3)];
  view_.type = make_view("abut::contact::type", surface_.type);
  view_.first_node = make_view("abut::contact::first_node", surface_.offset);
  view_.size = make_view("abut::contact::size", face_sizes(surface_));
  view_.modulus = make_view("abut::contact::modulus", surface_.modulus);
  view_.inverse_depth = make_view("abut::contact::inverse_depth", surface_.inverse_depth);
  std::vector<double> thickness;
  for (Local f = 0; f < surface_.num_faces(); ++f)
    thickness.push_back(surface_.thickness_behind(f));
  view_.thickness = make_view("abut::contact::thickness", thickness);
  view_.node = make_view("abut::contact::node", surface_.nodes);
  std::vector<Global> global;
  std::vector<Vec3> x;
  for (const Local n : surface_.nodes) {
    const double* at = &surface_.x[3 * std::size_t(n)];
    global.push_back(surface_.node[n]);
    x.push_back({{at[0], at[1], at[2]}});
  }
  view_.global_node = make_view("abut::contact::global_node", global);
  view_.x = make_view("abut::contact::x", x);
  view_.x_previous = make_view("abut::contact::x_previous", x);
  view_.x_reference = make_view("abut::contact::x_reference", x);
  reset_stretch();
  make_points(points, nodal);
}

void PrimarySurface::make_points(std::optional<int> points, bool nodal) {
  std::map<fem::FaceType, Local> table_of;
  std::vector<double> N, dN, xi, weight, area;
  std::vector<Local> first_point{0}, first_table, face;
  std::map<fem::FaceType, fem::Rule<2>> rules;
  for (Local f = 0; f < surface_.num_faces(); ++f) {
    const fem::FaceType type = surface_.type[f];
    if (const auto [it, is_new] = table_of.try_emplace(type, Local(xi.size() / 2)); is_new) {
      const fem::Rule<2> rule =
          nodal ? fem::nodal_rule(type)
                : fem::face_rule(type, points ? *points : fem::default_points(type));
      for (const auto& at : rule.xi) {
        double values[fem::max_face_nodes] = {}, slopes[fem::max_face_nodes][2] = {};
        fem::dispatch_face(type, [&](auto s) {
          decltype(s)::values(at.data(), values);
          decltype(s)::derivatives(at.data(), slopes);
        });
        N.insert(N.end(), values, values + fem::max_face_nodes);
        dN.insert(dN.end(), slopes[0], slopes[0] + 2 * fem::max_face_nodes);
        xi.insert(xi.end(), at.begin(), at.end());
      }
      rules[type] = rule;
    }
    const fem::Rule<2>& rule = rules[type];
    first_table.push_back(table_of[type]);
    weight.insert(weight.end(), rule.weight.begin(), rule.weight.end());
    face.insert(face.end(), std::size_t(rule.size()), f);
    first_point.push_back(first_point.back() + rule.size());
  }
  view_.first_point = make_view("abut::contact::first_point", first_point);
  view_.first_table = make_view("abut::contact::first_table", first_table);
  view_.face = make_view("abut::contact::face", face);
  view_.weight = make_view("abut::contact::weight", weight);
  view_.table_N = make_view("abut::contact::table_N", N);
  view_.table_dN = make_view("abut::contact::table_dN", dN);
  view_.table_xi = make_view("abut::contact::table_xi", xi);
  for (Local p = 0; p < view_.points(); ++p)
    area.push_back(view_.current_area(p)); // they stand where the reference has them
  view_.area = make_view("abut::contact::area", area);
}

void PrimarySurface::move(const double* u, int fields) {
  for (std::size_t a = 0; a < surface_.nodes.size(); ++a) {
    const auto n = std::size_t(surface_.nodes[a]);
    for (std::size_t i = 0; i < 3; ++i)
      view_.x(a)[int(i)] =
          surface_.x[3 * n + i] + u[std::size_t(surface_.field_index[n]) * std::size_t(fields) + i];
  }
}

void PrimarySurface::accept() {
  Kokkos::deep_copy(view_.x_previous, view_.x);
}

void PrimarySurface::update_stretch() {
  for (Local f = 0; f < view_.faces(); ++f) {
    double now = 0.0, then = 0.0;
    for (Local p = view_.first_point(f); p < view_.first_point(f + 1); ++p) {
      now += view_.current_area(p);
      then += view_.area(p);
    }
    view_.stretch(f) = then > 0.0 ? now / then : 1.0;
  }
}

void PrimarySurface::reset_stretch() {
  view_.stretch = make_view("abut::contact::stretch", surface_.type.size(), 1.0);
}

} // namespace abut::contact
