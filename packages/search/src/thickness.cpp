// SPDX-License-Identifier: BSD-3-Clause
#include "abut/search/thickness.hpp"

#include "abut/mesh/components.hpp"
#include "abut/search/queries.hpp"

#include <algorithm>
#include <limits>

namespace abut::search {

/// A line into a body, on its way to the ranks where it may leave it.
struct BodyThickness::Ray {
  Line line;
  Global body;
};

namespace {

constexpr double endless = 1e300;

Faces view_of(const mesh::Surface& s) {
  std::vector<Vec3> x;
  for (std::size_t n = 0; n < s.node.size(); ++n)
    x.push_back({{s.x[3 * n], s.x[3 * n + 1], s.x[3 * n + 2]}});
  return {make_view("abut::search::skin_type", s.type),
          make_view("abut::search::skin_offset", s.offset),
          make_view("abut::search::skin_node", s.nodes), make_view("abut::search::skin_x", x)};
}

/// Every rank's box around its own. Collective.
std::vector<Box<3>> share_box(const Comm& comm, const Box<3>& own) {
  std::vector<double> packed(own.low, own.low + 3);
  packed.insert(packed.end(), own.high, own.high + 3);
  packed = comm.all_gather(packed);
  std::vector<Box<3>> boxes(packed.size() / 6);
  for (std::size_t r = 0; r < boxes.size(); ++r) {
    std::copy_n(&packed[6 * r], 3, boxes[r].low);
    std::copy_n(&packed[6 * r + 3], 3, boxes[r].high);
  }
  return boxes;
}

Line into_body(const Faces& faces, Local face) {
  Vec3 y[fem::max_face_nodes];
  faces.coordinates(face, y);
  double center[2];
  fem::dispatch_face(faces.type(face), [&](auto s) { decltype(s)::center(center); });
  fem::FacePoint<double> at;
  fem::face_point(faces.type(face), y, center, at);
  const Vec3 area = cross(at.tangent[0], at.tangent[1]);
  return {at.x, (-1.0 / norm(area)) * area};
}

} // namespace

BodyThickness::BodyThickness(const mesh::Mesh& mesh)
    : mesh_(mesh), body_(mesh::connected_pieces(mesh, std::vector<char>(mesh.blocks.size(), 1))),
      skin_(mesh::outer_surface(mesh)), faces_(view_of(skin_)) {
  std::vector<Box<3>> boxes;
  Box<3> all = Box<3>::empty();
  for (Local f = 0; f < faces_.size(); ++f) {
    Vec3 y[fem::max_face_nodes];
    faces_.coordinates(f, y);
    boxes.push_back(face_box(faces_.type(f), y));
    all.add(boxes.back());
  }
  tree_.build(boxes);
  rank_boxes_ = share_box(mesh.comm, all);
}

double BodyThickness::leaves_after(const Ray& ray) const {
  double way = std::numeric_limits<double>::infinity();
  const LineQuery query{ray.line, endless};
  tree_.traverse([&](const Box<3>& box) { return query.meets(box, std::min(way, endless)); },
                 [&](Local face) {
                   if (body_[std::size_t(skin_.field_index[skin_.nodes[skin_.offset[face]]])] !=
                       ray.body)
                     return;
                   Vec3 y[fem::max_face_nodes];
                   faces_.coordinates(face, y);
                   const FaceMeeting hit = query.meet(faces_.type(face), y);
                   if (!hit.found || hit.distance <= 0.0 || hit.distance >= way)
                     return;
                   fem::FacePoint<double> at;
                   fem::face_point(faces_.type(face), y, hit.xi, at);
                   if (dot(cross(at.tangent[0], at.tangent[1]), ray.line.direction) > 0.0)
                     way = hit.distance;
                 });
  return way;
}

std::vector<double> BodyThickness::behind(const mesh::Surface& s) const {
  const Faces faces = view_of(s);
  std::vector<std::vector<Ray>> rays(rank_boxes_.size());
  std::vector<std::vector<Local>> of_face(rank_boxes_.size()); // that sends each ray
  for (Local f = 0; f < s.num_faces(); ++f) {
    const Line line = into_body(faces, f);
    const Global body = body_[std::size_t(s.field_index[s.nodes[s.offset[f]]])];
    for (std::size_t r = 0; r < rays.size(); ++r) {
      const Box<3>& box = rank_boxes_[r];
      if (box.low[0] > box.high[0] || !LineQuery{line, endless}.meets(box, endless))
        continue;
      rays[r].push_back({line, body});
      of_face[r].push_back(f);
    }
  }
  std::vector<std::vector<double>> ways(rays.size());
  const auto asked = mesh_.comm.exchange(rays);
  for (std::size_t r = 0; r < asked.size(); ++r)
    for (const Ray& ray : asked[r])
      ways[r].push_back(leaves_after(ray));
  const auto told = mesh_.comm.exchange(ways);
  std::vector<double> least(std::size_t(s.num_faces()), std::numeric_limits<double>::infinity());
  for (std::size_t r = 0; r < told.size(); ++r)
    for (std::size_t k = 0; k < told[r].size(); ++k)
      least[std::size_t(of_face[r][k])] = std::min(least[std::size_t(of_face[r][k])], told[r][k]);
  return least;
}

} // namespace abut::search
