// SPDX-License-Identifier: BSD-3-Clause
#include "samples.hpp"

#include "abut/fem/face_map.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace abut::audit {

namespace {

constexpr int dense = 8; ///< intervals along an edge of a body
/// Most intervals on a face: what enters a long one has edges, or cuts those of the body.
constexpr int sparse = 4;

class Maker {
public:
  Maker(const Skin& skin, const std::vector<Vec3>& x, std::vector<char> creased)
      : skin_(skin), x_(x), creased_(std::move(creased)) {}

  std::vector<Sample> make() {
    for (Local f = 0; f < skin_.faces(); ++f) {
      const int corners = skin_.corners(f);
      for (int a = 0; a < corners; ++a) {
        add_corner(f, a);
        add_edge(f, a, (a + 1) % corners);
      }
      add_middle(f);
    }
    return std::move(samples_);
  }

private:
  void corner_xi(Local f, int a, double* xi) const {
    fem::dispatch_face(skin_.type(f), [&](auto shape) { decltype(shape)::node(a, xi); });
  }
  double length(Local f, int a, int b) const {
    return norm(x_[std::size_t(skin_.node(f, a))] - x_[std::size_t(skin_.node(f, b))]);
  }
  double shortest(Local f) const {
    double least = 1e300;
    for (int a = 0; a < skin_.corners(f); ++a)
      least = std::min(least, length(f, a, (a + 1) % skin_.corners(f)));
    return least;
  }
  static int intervals(double length, double shortest) {
    const double wanted = shortest > 0.0 ? std::ceil(2.0 * length / shortest - 1e-6) : 2.0;
    return static_cast<int>(std::clamp(wanted, 2.0, double(sparse)));
  }

  void add_corner(Local f, int a) {
    if (!corners_.insert(skin_.node(f, a)).second)
      return;
    Sample s{f, {0, 0}, {a, -1, -1, -1}};
    corner_xi(f, a, s.xi);
    samples_.push_back(s);
  }

  void add_edge(Local f, int a, int b) {
    const Local na = skin_.node(f, a), nb = skin_.node(f, b);
    if (!edges_.insert(std::minmax(na, nb)).second)
      return;
    if (!creased_[std::size_t(4 * f + a)])
      return;
    double from[2], to[2];
    corner_xi(f, a, from);
    corner_xi(f, b, to);
    for (int k = 1; k < dense; ++k) {
      const double t = double(k) / dense;
      samples_.push_back(
          {f, {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}, {a, b, -1, -1}});
    }
  }

  void add_middle(Local f) {
    const int all = skin_.corners(f);
    if (all == 3) {
      samples_.push_back({f, {1.0 / 3.0, 1.0 / 3.0}, {0, 1, 2, -1}});
      return;
    }
    const double least = shortest(f);
    const int n = intervals(std::max(length(f, 0, 1), length(f, 2, 3)), least);
    const int m = intervals(std::max(length(f, 1, 2), length(f, 3, 0)), least);
    for (int i = 1; i < n; ++i)
      for (int j = 1; j < m; ++j)
        samples_.push_back({f, {2.0 * i / n - 1.0, 2.0 * j / m - 1.0}, {0, 1, 2, 3}});
  }

  const Skin& skin_;
  const std::vector<Vec3>& x_;
  std::vector<char> creased_; ///< (faces,4)
  std::vector<Sample> samples_;
  std::set<Local> corners_;
  std::set<std::pair<Local, Local>> edges_;
};

} // namespace

std::vector<Sample> make_samples(const Skin& skin, const Facets& facets,
                                 const std::vector<Vec3>& x) {
  return Maker(skin, x, facets.creases(skin, x)).make();
}

Vec3 position(const Skin& skin, const Sample& s, const std::vector<Vec3>& x) {
  if (s.anchors[1] < 0)
    return x[std::size_t(skin.node(s.face, s.anchors[0]))];
  return fem::dispatch_face(skin.type(s.face), [&](auto shape) {
    using Shape = decltype(shape);
    double N[Shape::nodes];
    Shape::values(s.xi, N);
    Vec3 p = Vec3::zero();
    for (int a = 0; a < Shape::nodes; ++a)
      p += N[a] * x[std::size_t(skin.node(s.face, a))];
    return p;
  });
}

Vec3 direction(const Skin& skin, const Sample& s, const Pose& pose) {
  Vec3 n = Vec3::zero();
  if (s.anchors[2] < 0) {
    for (int k = 0; k < 2 && s.anchors[k] >= 0; ++k)
      n += pose.normal[std::size_t(skin.node(s.face, s.anchors[k]))];
  } else {
    Vec3 y[fem::max_face_nodes];
    fem::FacePoint<double> at;
    face_nodes_at(skin, s.face, pose.x, y);
    fem::face_point(skin.type(s.face), y, s.xi, at);
    n = cross(at.tangent[0], at.tangent[1]);
  }
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : n;
}

} // namespace abut::audit
