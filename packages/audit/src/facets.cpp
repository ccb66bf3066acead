// SPDX-License-Identifier: BSD-3-Clause
#include "facets.hpp"

#include "abut/fem/face_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace abut::audit {

namespace {

constexpr int most_edges = 4;
constexpr double edge_of_body = 0.5; ///< cosine of 60 degrees
constexpr double crease = 0.866;     ///< of 30 degrees

using Ends = std::pair<Global, Global>;

/// An edge that one face of a rank has, on its way to the rank that knows others.
struct Notice {
  Global low, high; ///< its end nodes
  int rank;
  Local slot;
};

struct Neighbour {
  Global low, high;
  Local slot; ///< whose edge it is
  int rank;   ///< that has the same one
};

template <class T> Ends ends(const T& t) {
  return {t.low, t.high};
}

/// Edges that exactly two ranks have a face at.
std::vector<Neighbour> match(const Comm& comm, const std::vector<Notice>& alone) {
  const auto ranks = static_cast<std::size_t>(comm.size());
  std::vector<std::vector<Notice>> to(ranks);
  for (const Notice& n : alone)
    to[std::size_t(n.low) % ranks].push_back(n);
  std::vector<Notice> here;
  for (const auto& part : comm.exchange(to))
    here.insert(here.end(), part.begin(), part.end());
  std::sort(here.begin(), here.end(),
            [](const Notice& a, const Notice& b) { return ends(a) < ends(b); });
  std::vector<std::vector<Neighbour>> answers(ranks);
  for (std::size_t i = 0, last = 0; i < here.size(); i = last) {
    for (last = i; last < here.size() && ends(here[last]) == ends(here[i]);)
      ++last;
    if (last - i != 2)
      continue;
    const Notice &a = here[i], &b = here[i + 1];
    answers[std::size_t(a.rank)].push_back({a.low, a.high, a.slot, b.rank});
    answers[std::size_t(b.rank)].push_back({b.low, b.high, b.slot, a.rank});
  }
  std::vector<Neighbour> mine;
  for (const auto& part : comm.exchange(answers))
    mine.insert(mine.end(), part.begin(), part.end());
  std::sort(mine.begin(), mine.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::make_tuple(a.rank, ends(a)) < std::make_tuple(b.rank, ends(b));
  });
  return mine;
}

/// Unit normals of a face in the middles of its edges.
void edge_normals(fem::FaceType type, const Vec3* y, Vec3* normals) {
  const int corners = fem::face_corners(type);
  const bool flat = fem::face_nodes(type) == corners;
  std::array<Vec3, 4> corner{};
  if (flat)
    corner = corner_normals(type, y);
  for (int a = 0; a < corners; ++a) {
    const int b = (a + 1) % corners;
    Vec3 n = corner[std::size_t(a)] + corner[std::size_t(b)];
    if (!flat) {
      double from[2], to[2];
      fem::FacePoint<double> at;
      fem::dispatch_face(type, [&](auto shape) {
        decltype(shape)::node(a, from);
        decltype(shape)::node(b, to);
      });
      const double middle[2] = {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
      fem::face_point(type, y, middle, at);
      n = cross(at.tangent[0], at.tangent[1]);
    }
    const double length = norm(n);
    normals[a] = length > 0.0 ? (1.0 / length) * n : n;
  }
}

/// Of the arcs over the edges: those of opposite ones bend the same way, those beside each other
/// add up.
double whole_rise(int corners, const double* rise) {
  if (corners == 3)
    return rise[0] + rise[1] + rise[2];
  return std::max(rise[0], rise[2]) + std::max(rise[1], rise[3]);
}

} // namespace

Facets::Facets(const mesh::Mesh& mesh, const Skin& skin)
    : mesh_(mesh), beside_(std::size_t(skin.faces()) * most_edges, -1),
      rows_(skin.faces() * most_edges) {
  std::map<Ends, Local> open;
  for (Local f = 0; f < skin.faces(); ++f)
    for (int a = 0; a < skin.corners(f); ++a) {
      const Global i = mesh.node[std::size_t(skin.node(f, a))];
      const Global j = mesh.node[std::size_t(skin.node(f, (a + 1) % skin.corners(f)))];
      const Local slot = f * most_edges + a;
      const auto [other, is_new] = open.try_emplace(std::minmax(i, j), slot);
      if (is_new)
        continue;
      beside_[std::size_t(slot)] = other->second;
      beside_[std::size_t(other->second)] = slot;
      open.erase(other);
    }
  if (mesh.comm.size() == 1)
    return;
  std::vector<Notice> alone;
  for (const auto& [edge, slot] : open)
    alone.push_back({edge.first, edge.second, mesh.comm.rank(), slot});
  std::vector<NeighbourMessages::Neighbour> lists;
  for (const Neighbour& n : match(mesh.comm, alone)) {
    if (lists.empty() || lists.back().rank != n.rank)
      lists.push_back({n.rank, {}, {}});
    lists.back().send.push_back(n.slot);
    lists.back().receive.push_back(rows_);
    beside_[std::size_t(n.slot)] = rows_++;
  }
  messages_.emplace(mesh.comm, std::move(lists));
}

/// In the middles of edges (faces,4), and of those that come from other ranks behind. Collective.
std::vector<Vec3> Facets::normals(const Skin& skin, const std::vector<Vec3>& x) const {
  std::vector<Vec3> normal(std::size_t(rows_), Vec3::zero());
  for (Local f = 0; f < skin.faces(); ++f) {
    Vec3 y[fem::max_face_nodes];
    face_nodes_at(skin, f, x, y);
    edge_normals(skin.type(f), y, &normal[std::size_t(f) * most_edges]);
  }
  if (messages_) {
    const auto in = messages_->exchange(normal.data(), 1);
    for (std::size_t k = 0; k < in.size(); ++k)
      for (std::size_t i = 0; i < in[k].size(); ++i)
        normal[std::size_t(messages_->neighbours()[k].receive[i])] = in[k][i];
  }
  return normal;
}

std::vector<char> Facets::creases(const Skin& skin, const std::vector<Vec3>& x) const {
  const std::vector<Vec3> normal = normals(skin, x);
  std::vector<char> creased(beside_.size(), 1);
  for (std::size_t slot = 0; slot < beside_.size(); ++slot)
    if (beside_[slot] >= 0)
      creased[slot] = dot(normal[slot], normal[std::size_t(beside_[slot])]) < crease;
  return creased;
}

std::vector<double> Facets::rises(const Skin& skin, const std::vector<Vec3>& x) const {
  const std::vector<Vec3> normal = normals(skin, x);
  std::vector<double> rises;
  for (Local f = 0; f < skin.faces(); ++f) {
    double rise[most_edges] = {};
    const double area = skin.size[std::size_t(f)] * skin.size[std::size_t(f)];
    for (int a = 0; a < skin.corners(f); ++a) {
      const auto slot = std::size_t(f) * most_edges + std::size_t(a);
      if (beside_[slot] < 0)
        continue;
      const double c = dot(normal[slot], normal[std::size_t(beside_[slot])]);
      const Vec3 edge =
          x[std::size_t(skin.node(f, (a + 1) % skin.corners(f)))] - x[std::size_t(skin.node(f, a))];
      const double height = (skin.corners(f) == 3 ? 2.0 : 1.0) * area / norm(edge);
      if (c > edge_of_body && norm(edge) > 0.0)
        rise[a] = 0.5 * height * std::tan(0.25 * std::acos(std::min(c, 1.0)));
    }
    rises.push_back(whole_rise(skin.corners(f), rise));
  }
  return rises;
}

} // namespace abut::audit
