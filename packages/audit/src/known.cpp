// SPDX-License-Identifier: BSD-3-Clause
#include "known.hpp"

#include "ask.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace abut::audit {

namespace {

struct Question {
  int overlap;
  Global own, piece;
  double size; ///< of the sample's face [length]
  Vec3 x;
};

/// The points of all interfaces on this rank, each with the reach of its face.
class Points {
public:
  Points(const Scan& scan, const std::vector<Belief>& beliefs) : scan_(scan) {
    const std::vector<Global>& ids = scan.skin.surface.face_id; // ascending
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < beliefs.size(); ++i)
      for (const BelievedPoint& p : beliefs[i].points) {
        const auto found = std::lower_bound(ids.begin(), ids.end(), p.face);
        if (found == ids.end() || *found != p.face)
          continue; // on a face inside of a body, which is in nothing
        const auto face = static_cast<Local>(found - ids.begin());
        const double size = scan.skin.size[std::size_t(face)];
        Box box;
        box.add(p.x);
        boxes.push_back(box.around(size));
        entries_.push_back({&p, static_cast<int>(i), scan.pieces.of_face(scan.skin, face), size});
      }
    grid_ = BoxGrid(std::move(boxes));
  }

  void find(const Question& q, std::vector<Knowledge>& answers) const {
    const auto first = static_cast<std::ptrdiff_t>(answers.size());
    Box around;
    around.add(q.x);
    grid_.in(around.around(q.size), [&](Local item) {
      const Entry& e = entries_[std::size_t(item)];
      const double distance = norm(e.point->x - q.x);
      if ((e.piece != q.own && e.piece != q.piece) || distance > std::max(e.size, q.size) ||
          !scan_.sides.joins_bodies(e.interface, q.own, q.piece))
        return;
      const BelievedPoint& p = *e.point;
      const Knowledge k{q.overlap, e.interface,      distance, p.gap,
                        p.paired,  p.pressure > 0.0, p.held};
      const auto known = std::find_if(answers.begin() + first, answers.end(),
                                      [&](const auto& a) { return a.interface == k.interface; });
      if (known == answers.end())
        answers.push_back(k);
      else
        *known = std::min(*known, k);
    });
  }

private:
  struct Entry {
    const BelievedPoint* point;
    int interface;
    Global piece;
    double size;
  };
  const Scan& scan_;
  std::vector<Entry> entries_;
  BoxGrid grid_;
};

/// The later, the nearer an interface comes to knowing.
int rank_of(Cause cause) {
  switch (cause) {
  case Cause::no_contact:
    return 0;
  case Cause::other_faces:
    return 1;
  case Cause::rests:
    return 2;
  case Cause::no_point:
    return 3;
  case Cause::no_partner:
    return 4;
  case Cause::open:
    return 5;
  default:
    return 6;
  }
}

Cause cause_of(const Belief& belief, bool joins_faces, const Knowledge* k) {
  if (!joins_faces)
    return Cause::other_faces;
  if (!belief.acts)
    return Cause::rests;
  if (!k)
    return Cause::no_point;
  if (!k->paired)
    return Cause::no_partner;
  return k->pressed || k->gap < 0.0 ? Cause::less : Cause::open;
}

Sides sides_of_sample(const Scan& scan, const Sample& s) {
  Local nodes[4];
  int count = 0;
  for (; count < 4 && s.anchors[count] >= 0; ++count)
    nodes[count] = scan.skin.node(s.face, s.anchors[count]);
  return scan.sides.of_nodes(nodes, count);
}

} // namespace

bool operator<(const Knowledge& a, const Knowledge& b) {
  return std::make_tuple(a.overlap, a.interface, a.distance, a.gap) <
         std::make_tuple(b.overlap, b.interface, b.distance, b.gap);
}

std::vector<Knowledge> what_is_known(const Scan& scan, const std::vector<Overlap>& overlaps,
                                     const std::vector<Belief>& beliefs) {
  const Comm& comm = scan.mesh.comm;
  if (!comm.any(!overlaps.empty()))
    return {};
  // Points of an interface may lie on any rank that has a part of one of the two pieces.
  std::vector<std::vector<Question>> to(std::size_t(comm.size()));
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    const Overlap& o = overlaps[i];
    const Local face = scan.samples[std::size_t(o.sample)].face;
    const Question q{static_cast<int>(i), scan.pieces.of_face(scan.skin, face), o.piece,
                     scan.skin.size[std::size_t(face)], o.x};
    int last = -1;
    for (const PiecePart& part : scan.parts)
      if (part.rank != last && (part.piece == q.own || part.piece == q.piece)) {
        to[std::size_t(part.rank)].push_back(q);
        last = part.rank;
      }
  }
  const Points points(scan, beliefs);
  std::vector<Knowledge> known = ask<Knowledge>(
      comm, to, [&](const Question& q, std::vector<Knowledge>& a) { points.find(q, a); });
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end(),
                          [](const Knowledge& a, const Knowledge& b) {
                            return a.overlap == b.overlap && a.interface == b.interface;
                          }),
              known.end());
  return known;
}

bool is_known(const Scan& scan, const Overlap& overlap, double allowed,
              const std::vector<Belief>& beliefs, const Knowledge* first, const Knowledge* last,
              Finding& finding) {
  const Sample& sample = scan.samples[std::size_t(overlap.sample)];
  const Global own = scan.pieces.of_face(scan.skin, sample.face);
  const Sides sides = sides_of_sample(scan, sample);
  finding.cause = Cause::no_contact;
  for (int i = 0; i < scan.sides.size(); ++i) {
    if (!scan.sides.joins_bodies(i, own, overlap.piece))
      continue;
    const Knowledge* k =
        std::find_if(first, last, [&](const Knowledge& one) { return one.interface == i; });
    k = k == last ? nullptr : k;
    const double believed = k && k->paired ? k->gap : 0.0;
    if (k && (k->held || (k->paired && overlap.depth + std::min(believed, 0.0) <= allowed)))
      return true;
    const Cause cause =
        cause_of(beliefs[std::size_t(i)], scan.sides.joins_faces(i, sides, overlap.sides), k);
    if (rank_of(cause) > rank_of(finding.cause)) {
      finding.cause = cause;
      finding.interface = i;
      finding.believed = believed;
    }
  }
  return false;
}

} // namespace abut::audit
