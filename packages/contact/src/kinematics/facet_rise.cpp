// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/facet_rise.hpp"

#include "abut/core/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace abut::contact {

namespace {

constexpr double corner_angle = 0.6; ///< a larger one between two faces is a corner [rad]
constexpr double flat_angle = 1e-6;  ///< a smaller one is rounding [rad]
constexpr int edges = 4;

/// An edge of a face on its way to the rank that joins the two faces of an edge.
struct FaceEdge {
  Global low, high; ///< mesh nodes
  int rank;         ///< that has the face
  Local face;
  int edge;
  Vec3 normal, center;
};

/// What the other face of an edge says to this one.
struct Bend {
  Local face;
  int edge;
  double angle; ///< > 0 where the surface bulges [rad]
};

Vec3 position(const mesh::Surface& s, Local face, int a) {
  const double* x = &s.x[3 * std::size_t(s.nodes[s.offset[face] + a])];
  return {{x[0], x[1], x[2]}};
}

std::vector<std::vector<FaceEdge>> face_edges(const Comm& comm, const mesh::Surface& s) {
  std::vector<std::vector<FaceEdge>> send(std::size_t(comm.size()));
  for (Local f = 0; f < s.num_faces(); ++f) {
    if (s.type[f] != fem::FaceType::quad4)
      continue;
    Vec3 x[edges], center = Vec3::zero();
    for (int a = 0; a < edges; ++a) {
      x[a] = position(s, f, a);
      center += 0.25 * x[a];
    }
    const Vec3 area = cross(x[2] - x[0], x[3] - x[1]);
    for (int e = 0; e < edges; ++e) {
      const Global a = s.node[s.nodes[s.offset[f] + e]],
                   b = s.node[s.nodes[s.offset[f] + (e + 1) % edges]];
      send[std::size_t((a + b) % comm.size())].push_back(
          {std::min(a, b), std::max(a, b), comm.rank(), f, e, (1.0 / norm(area)) * area, center});
    }
  }
  return send;
}

double bend(const FaceEdge& a, const FaceEdge& b) {
  const double angle = std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal));
  if (angle < flat_angle)
    return 0.0;
  return dot(b.normal - a.normal, b.center - a.center) > 0.0 ? angle : -angle;
}

/// The bends at the edges of this rank's faces that have one other face. Collective.
std::vector<Bend> bends(const Comm& comm, const mesh::Surface& s) {
  std::vector<FaceEdge> all;
  for (const auto& part : comm.exchange(face_edges(comm, s)))
    all.insert(all.end(), part.begin(), part.end());
  const auto key = [](const FaceEdge& e) { return std::tie(e.low, e.high); };
  std::sort(all.begin(), all.end(),
            [&](const FaceEdge& a, const FaceEdge& b) { return key(a) < key(b); });
  std::vector<std::vector<Bend>> send(std::size_t(comm.size()));
  for (auto first = all.begin(), last = first; first != all.end(); first = last) {
    last = std::find_if(first, all.end(), [&](const FaceEdge& e) { return key(e) != key(*first); });
    if (last - first != 2)
      continue;
    const double angle = bend(first[0], first[1]);
    for (auto e = first; std::fabs(angle) < corner_angle && e != last; ++e)
      send[std::size_t(e->rank)].push_back({e->face, e->edge, angle});
  }
  std::vector<Bend> result;
  for (const auto& part : comm.exchange(send))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

/// Of two opposite edges: what both say, or the one that says something.
double common(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b)
    return a.value_or(b.value_or(0.0));
  if (*a * *b <= 0.0)
    return 0.0;
  return std::fabs(*a) < std::fabs(*b) ? *a : *b;
}

} // namespace

std::vector<double> facet_rises(const Comm& comm, const mesh::Surface& s) {
  std::vector<std::optional<double>> angle(std::size_t(s.num_faces()) * edges);
  for (const Bend& b : bends(comm, s))
    angle[std::size_t(b.face * edges + b.edge)] = b.angle;
  std::vector<double> rises(2 * std::size_t(s.num_faces()), 0.0);
  for (Local f = 0; f < s.num_faces(); ++f) {
    if (s.type[f] != fem::FaceType::quad4)
      continue;
    const auto* of_face = &angle[std::size_t(f * edges)];
    const auto middle = [&](int e) {
      return 0.5 * (position(s, f, e) + position(s, f, (e + 1) % edges));
    };
    for (int k = 0; k < 2; ++k) { // along xi between edges 1 and 3, along eta between 0 and 2
      const int e = 1 - k;
      rises[std::size_t(2 * f + k)] =
          norm(middle(e) - middle(e + 2)) * common(of_face[e], of_face[e + 2]) / 8.0;
    }
  }
  return rises;
}

} // namespace abut::contact
