// SPDX-License-Identifier: BSD-3-Clause
#include "passages.hpp"

#include "ask.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace abut::audit {

namespace {

constexpr double least_turn = 0.985; ///< cosine of the largest turn of an edge that is judged

struct Mover {
  Local sample;
  Global own;
  int frame;
  Vec3 from, to;
};

struct Crossing {
  Local sample;
  Global piece, face;
  double at; ///< part of the step
  int inward;
  Vec3 normal, way; ///< of the face then, and its displacement in the step
  double size;
  Sides sides;
  Owner owner;
};

bool operator<(const Crossing& a, const Crossing& b) {
  return std::make_tuple(a.sample, a.piece, a.at, a.face) <
         std::make_tuple(b.sample, b.piece, b.at, b.face);
}

/// Three points on straight ways.
struct Triangle {
  Vec3 from[3], to[3];

  Vec3 corner(int a, double s) const { return from[a] + s * (to[a] - from[a]); }
  Vec3 normal(double s) const {
    const Vec3 a = corner(0, s);
    return cross(corner(1, s) - a, corner(2, s) - a);
  }
  /// Volume that the triangle spans with a point at x: > 0 before it.
  double before(const Vec3& x, double s) const { return dot(x - corner(0, s), normal(s)); }
  bool holds(const Vec3& x, double s) const {
    constexpr double rim = 1e-9;
    const Vec3 n = normal(s);
    const double all = dot(n, n);
    for (int a = 0; a < 3; ++a) {
      const Vec3 from_here = corner(a, s);
      if (dot(cross(corner((a + 1) % 3, s) - from_here, x - from_here), n) < -rim * all)
        return false;
    }
    return true;
  }
};

/// When the mover goes through the triangle, by halving; < 0: it does not.
double crossing_time(const Triangle& t, const Mover& m) {
  const auto x = [&](double s) { return m.from + s * (m.to - m.from); };
  double low = 0.0, high = 1.0;
  const bool starts_before = t.before(x(0.0), 0.0) > 0.0;
  if (starts_before == (t.before(x(1.0), 1.0) > 0.0))
    return -1.0;
  for (int k = 0; k < 40; ++k) {
    const double s = 0.5 * (low + high);
    ((t.before(x(s), s) > 0.0) == starts_before ? low : high) = s;
  }
  const double s = 0.5 * (low + high);
  return t.holds(x(s), s) ? s : -1.0;
}

Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

bool turns(const Triangle& t) {
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    if (dot(unit(t.from[b] - t.from[a]), unit(t.to[b] - t.to[a])) < least_turn)
      return true;
  }
  return false;
}

/// The first three corners of a face.
Triangle corner_of(const Scan& scan, Local face) {
  Triangle t;
  for (int a = 0; a < 3; ++a) {
    const auto n = std::size_t(scan.skin.node(face, a));
    t.from[a] = scan.pose.before[n];
    t.to[a] = scan.pose.x[n];
  }
  return t;
}

/// The faces of this rank on their ways.
class MovingFaces {
public:
  explicit MovingFaces(const Scan& scan) : scan_(scan) {
    std::vector<Box> boxes;
    for (Local f = 0; f < scan.skin.faces(); ++f) {
      Box& box = boxes.emplace_back();
      for (int a = 0; a < scan.skin.corners(f); ++a) {
        const auto n = std::size_t(scan.skin.node(f, a));
        box.add(scan.pose.x[n]);
        box.add(scan.pose.before[n]);
      }
    }
    grid_ = BoxGrid(std::move(boxes));
  }

  void find(const Mover& m, std::vector<Crossing>& crossings) const {
    Box way;
    way.add(m.from);
    way.add(m.to);
    grid_.in(way, [&](Local f) {
      const Global piece = scan_.pieces.of_face(scan_.skin, f);
      if (piece != m.own && Pieces::may_meet(m.own, m.frame, piece, scan_.pieces.frame(piece)))
        meet(m, f, piece, crossings);
    });
  }

private:
  void meet(const Mover& m, Local f, Global piece, std::vector<Crossing>& crossings) const {
    const Skin& skin = scan_.skin;
    for (int k = 1; k + 1 < skin.corners(f); ++k) {
      Triangle t;
      Local nodes[4];
      const int corner[3] = {0, k, k + 1};
      for (int a = 0; a < 3; ++a) {
        const auto n = std::size_t(skin.node(f, corner[a]));
        t.from[a] = scan_.pose.before[n];
        t.to[a] = scan_.pose.x[n];
      }
      if (turns(t))
        continue;
      const double s = crossing_time(t, m);
      if (s < 0.0)
        continue;
      for (int a = 0; a < skin.corners(f); ++a)
        nodes[a] = skin.node(f, a);
      const bool inward = t.before(m.from, 0.0) > 0.0;
      crossings.push_back({m.sample, piece, skin.surface.face_id[std::size_t(f)], s, inward,
                           unit(t.normal(s)), t.to[0] - t.from[0], skin.size[std::size_t(f)],
                           scan_.sides.of_nodes(nodes, skin.corners(f)), scan_.owner_of_face(f)});
      return; // the other half has it too where it goes through the line between them
    }
  }

  const Scan& scan_;
  BoxGrid grid_;
};

struct Whole {
  int frame;
  Box swept, way;
  double shortest = 1e300;
};

std::map<Global, Whole> whole_pieces(const std::vector<PiecePart>& parts) {
  std::map<Global, Whole> all;
  for (const PiecePart& p : parts) {
    Whole& w = all.try_emplace(p.piece, Whole{p.frame, {}, {}, 1e300}).first->second;
    w.swept.add(p.swept);
    w.way.add(p.way);
    w.shortest = std::min(w.shortest, p.shortest);
  }
  return all;
}

/// Whether a point that goes this way may leave the piece behind within the step.
bool may_pass(const Box& segment, const Vec3& way, const Whole& w) {
  if (!w.swept.meets(segment) || w.way.is_empty())
    return false;
  return w.way.farthest(way) >= w.shortest;
}

/// Whether any piece may leave another one behind in the step.
bool any_may_pass(const std::map<Global, Whole>& whole) {
  for (const auto& [piece, w] : whole)
    for (const auto& [other, o] : whole)
      if (other != piece && Pieces::may_meet(piece, w.frame, other, o.frame) &&
          w.swept.meets(o.swept) && !w.way.is_empty() && !o.way.is_empty() &&
          std::max(w.way.farthest(o.way.low), w.way.farthest(o.way.high)) +
                  norm(o.way.high - o.way.low) >=
              w.shortest)
        return true;
  return false;
}

/// To the ranks where it may go through a face.
std::vector<std::vector<Mover>> make_movers(const Scan& scan) {
  std::vector<std::vector<Mover>> to(std::size_t(scan.mesh.comm.size()));
  const auto whole = whole_pieces(scan.parts);
  if (!any_may_pass(whole))
    return to;
  for (Local i = 0; i < Local(scan.samples.size()); ++i) {
    const Sample& s = scan.samples[std::size_t(i)];
    Mover m{i, scan.pieces.of_face(scan.skin, s.face), 0, position(scan.skin, s, scan.pose.before),
            position(scan.skin, s, scan.pose.x)};
    m.frame = scan.pieces.frame(m.own);
    Box segment;
    segment.add(m.from);
    segment.add(m.to);
    int last = -1;
    for (const PiecePart& part : scan.parts)
      if (part.rank != last && part.piece != m.own && part.swept.meets(segment) &&
          Pieces::may_meet(m.own, m.frame, part.piece, part.frame) &&
          may_pass(segment, m.to - m.from, whole.at(part.piece))) {
        to[std::size_t(part.rank)].push_back(m);
        last = part.rank;
      }
  }
  return to;
}

} // namespace

std::vector<Passage> find_passages(const Scan& scan) {
  const auto movers = make_movers(scan);
  bool some = false;
  for (const auto& list : movers)
    some = some || !list.empty();
  if (!scan.mesh.comm.any(some))
    return {};
  const MovingFaces faces(scan);
  std::vector<Crossing> found =
      ask<Crossing>(scan.mesh.comm, movers, [&](const Mover& m, std::vector<Crossing>& answers) {
        faces.find(m, answers);
      });
  std::sort(found.begin(), found.end());
  std::vector<Passage> passages;
  for (std::size_t k = 0; k + 1 < found.size(); ++k) {
    const Crossing &in = found[k], &out = found[k + 1];
    if (in.sample != out.sample || in.piece != out.piece || !in.inward || out.inward ||
        dot(in.normal, out.normal) >= 0.0)
      continue;
    const Sample& s = scan.samples[std::size_t(in.sample)];
    if (turns(corner_of(scan, s.face)))
      continue;
    const Vec3 from = position(scan.skin, s, scan.pose.before);
    const Vec3 step = position(scan.skin, s, scan.pose.x) - from;
    passages.push_back({in.sample, from + in.at * step, in.piece, out.owner,
                        (out.at - in.at) * norm(step - 0.5 * (in.way + out.way)), in.size,
                        in.sides});
  }
  return passages;
}

} // namespace abut::audit
