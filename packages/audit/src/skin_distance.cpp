// SPDX-License-Identifier: BSD-3-Clause
#include "skin_distance.hpp"

#include "ask.hpp"

#include <algorithm>
#include <tuple>

namespace abut::audit {

namespace {

constexpr double same_way = 0.5; ///< cosine beyond which a face looks as the sample does

struct Question {
  int overlap;
  int corners; ///< of the sample's face
  Global own, piece;
  Global corner[4]; ///< numbers of the nodes there
  Vec3 x, direction;
};

struct Answer {
  int overlap;
  int faces_it; ///< whether the face looks another way than the sample
  double depth;
  Global face;
  double size, scale, rise;
  Sides sides;
};

bool operator<(const Answer& a, const Answer& b) {
  return std::make_tuple(a.overlap, -a.faces_it, a.depth, a.face) <
         std::make_tuple(b.overlap, -b.faces_it, b.depth, b.face);
}

/// A face as flat triangles between its nodes and its middle.
template <class Visit> void each_triangle(fem::FaceType type, const Vec3* y, const Visit& visit) {
  const int corners = fem::face_corners(type);
  const bool flat = fem::face_nodes(type) == corners;
  if (flat && corners == 3)
    return visit(y[0], y[1], y[2]);
  if (type == fem::FaceType::tri6) {
    for (int a = 0; a < 3; ++a)
      visit(y[a], y[3 + a], y[3 + (a + 2) % 3]);
    return visit(y[3], y[4], y[5]);
  }
  Vec3 middle = 0.25 * (y[0] + y[1] + y[2] + y[3]);
  if (type == fem::FaceType::quad8)
    middle = 0.5 * (y[4] + y[5] + y[6] + y[7]) - middle;
  if (type == fem::FaceType::quad9)
    middle = y[8];
  for (int a = 0; a < 4; ++a) {
    const Vec3& next = y[(a + 1) % 4];
    visit(y[a], flat ? next : y[4 + a], middle);
    if (!flat)
      visit(y[4 + a], next, middle);
  }
}

Vec3 mean_normal(fem::FaceType type, const Vec3* y) {
  Vec3 n = Vec3::zero();
  const auto corner = corner_normals(type, y);
  for (int a = 0; a < fem::face_corners(type); ++a)
    n += corner[std::size_t(a)];
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : n;
}

/// The faces of this rank.
class Faces {
public:
  explicit Faces(const Scan& scan) : scan_(scan) {
    std::vector<Box> boxes;
    for (Local f = 0; f < scan.skin.faces(); ++f) {
      Box& box = boxes.emplace_back();
      Vec3 y[fem::max_face_nodes];
      face_nodes_at(scan.skin, f, scan.pose.x, y);
      for (int a = 0; a < fem::face_nodes(scan.skin.type(f)); ++a)
        box.add(y[a]);
      if (fem::face_nodes(scan.skin.type(f)) != scan.skin.corners(f))
        box.widen(bulge);
    }
    grid_ = BoxGrid(std::move(boxes));
  }

  /// In ever larger regions, until one holds the nearest face for certain.
  void find(const Question& q, std::vector<Answer>& answers) const {
    if (grid_.is_empty())
      return;
    const double all = grid_.bounds().farthest(q.x);
    for (double reach = std::max(0.25 * grid_.cell(), 1e-12 * all);; reach *= 2.0) {
      Answer best[2] = {{q.overlap, 0, 1e300, nothing_near, 0, 0, 0, {}},
                        {q.overlap, 1, 1e300, nothing_near, 0, 0, 0, {}}};
      Box around;
      around.add(q.x);
      grid_.in(around.around(reach), [&](Local f) { try_face(q, f, best); });
      if (best[1].depth > reach && reach < all)
        continue;
      for (const Answer& a : best)
        if (a.face != nothing_near)
          answers.push_back(a);
      return;
    }
  }

private:
  void try_face(const Question& q, Local f, Answer* best) const {
    const Skin& skin = scan_.skin;
    if (scan_.pieces.of_face(skin, f) != q.piece || touches(q, f))
      return;
    Vec3 y[fem::max_face_nodes];
    face_nodes_at(skin, f, scan_.pose.x, y);
    if (grid_.box(f).nearest(q.x) > best[1].depth)
      return;
    const int faces_it = dot(mean_normal(skin.type(f), y), q.direction) < same_way;
    const Answer here{q.overlap,
                      faces_it,
                      distance_to_face(skin.type(f), y, q.x),
                      skin.surface.face_id[std::size_t(f)],
                      skin.size[std::size_t(f)],
                      skin.scale[std::size_t(f)],
                      scan_.pose.rise[std::size_t(f)],
                      sides_of(f)};
    best[faces_it] = std::min(best[faces_it], here);
  }

  Sides sides_of(Local f) const {
    Local nodes[4];
    for (int a = 0; a < scan_.skin.corners(f); ++a)
      nodes[a] = scan_.skin.node(f, a);
    return scan_.sides.of_nodes(nodes, scan_.skin.corners(f));
  }

  bool touches(const Question& q, Local f) const {
    for (int a = 0; q.own == q.piece && a < scan_.skin.corners(f); ++a)
      for (int k = 0; k < q.corners; ++k)
        if (scan_.mesh.node[std::size_t(scan_.skin.node(f, a))] == q.corner[k])
          return true;
    return false;
  }

  const Scan& scan_;
  BoxGrid grid_;
};

Question make_question(const Scan& scan, int i, const Overlap& o) {
  const Sample& s = scan.samples[std::size_t(o.sample)];
  Question q{
      i,   scan.skin.corners(s.face),         scan.pieces.of_face(scan.skin, s.face), o.piece, {},
      o.x, direction(scan.skin, s, scan.pose)};
  for (int a = 0; a < q.corners; ++a)
    q.corner[a] = scan.mesh.node[std::size_t(scan.skin.node(s.face, a))];
  return q;
}

/// Each to the ranks that have faces of the piece, for which one looks its way only they know.
std::vector<std::vector<Question>> make_questions(const Scan& scan,
                                                  const std::vector<Overlap>& overlaps) {
  std::vector<std::vector<Question>> to(std::size_t(scan.mesh.comm.size()));
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const Question q = make_question(scan, static_cast<int>(i), overlaps[i]);
    for (const PiecePart& part : scan.parts)
      if (part.piece == q.piece && !part.skin.is_empty())
        to[std::size_t(part.rank)].push_back(q);
  }
  return to;
}

} // namespace

double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double area2 = dot(n, n);
  const Vec3 corner[3] = {a, b, c};
  bool inside = area2 > 0.0;
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = corner[k], edge = corner[(k + 1) % 3] - from, d = x - from;
    inside = inside && dot(cross(edge, d), n) >= 0.0;
    const double length2 = dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(dot(d, edge) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, norm(d - t * edge));
  }
  return inside ? std::fabs(dot(x - a, n)) / std::sqrt(area2) : least;
}

double distance_to_face(fem::FaceType type, const Vec3* y, const Vec3& x) {
  double least = 1e300;
  each_triangle(type, y, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    least = std::min(least, distance_to_triangle(x, a, b, c));
  });
  return least;
}

void measure_depths(const Scan& scan, std::vector<Overlap>& overlaps) {
  const Comm& comm = scan.mesh.comm;
  if (!comm.any(!overlaps.empty()))
    return;
  const Faces faces(scan);
  std::vector<Answer> answers =
      ask<Answer>(comm, make_questions(scan, overlaps),
                  [&](const Question& q, std::vector<Answer>& a) { faces.find(q, a); });
  std::sort(answers.begin(), answers.end());
  for (auto a = answers.rbegin(); a != answers.rend(); ++a) { // the first of each comes last
    Overlap& o = overlaps[std::size_t(a->overlap)];
    o.depth = a->depth;
    o.face = a->face;
    o.size = a->size;
    o.scale = a->scale;
    o.rise = a->rise;
    o.sides = a->sides;
  }
}

} // namespace abut::audit
