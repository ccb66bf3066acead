// SPDX-License-Identifier: BSD-3-Clause
#include "overlaps.hpp"

#include "ask.hpp"

#include "abut/audit/inside_cell.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace abut::audit {

namespace {

/// A sample on its way to elements that it may be in.
struct Probe {
  Local sample;
  int corners;      ///< of its face
  Global piece;     ///< its own
  int frame;        ///< of that
  Global corner[4]; ///< numbers of the nodes there
  Vec3 x;
};

struct Hit {
  Local sample;
  Global piece, element; ///< index in the input
  Owner owner;
};

bool operator<(const Hit& a, const Hit& b) {
  return std::make_tuple(a.sample, a.piece, a.element) <
         std::make_tuple(b.sample, b.piece, b.element);
}

/// The elements of this rank that lie in the region of what is asked for.
class Elements {
public:
  Elements(const Scan& scan, const Box& region) : scan_(scan) {
    std::vector<Box> boxes;
    for (std::size_t b = 0; b < scan.mesh.blocks.size(); ++b) {
      const mesh::Block& block = scan.mesh.blocks[b];
      const auto nodes = std::size_t(fem::info(block.type).nodes);
      const bool curved = fem::info(block.type).nodes != fem::info(block.type).corners;
      for (Local e = 0; e < block.size(); ++e) {
        Box box;
        for (std::size_t a = 0; a < nodes; ++a)
          box.add(scan.pose.x[std::size_t(block.nodes[std::size_t(e) * nodes + a])]);
        if (curved)
          box.widen(bulge);
        if (!box.meets(region))
          continue;
        boxes.push_back(box);
        place_.push_back({static_cast<int>(b), e});
      }
    }
    grid_ = BoxGrid(std::move(boxes));
  }

  /// Of each piece the first element, by the order of the input.
  void find(const Probe& probe, std::vector<Hit>& hits) const {
    const std::size_t first = hits.size();
    const auto has = [&](Global piece) {
      for (std::size_t k = first; k < hits.size(); ++k)
        if (hits[k].piece == piece)
          return true;
      return false;
    };
    grid_.at(probe.x, [&](Local item) {
      const auto [b, e] = place_[std::size_t(item)];
      const mesh::Block& block = scan_.mesh.blocks[std::size_t(b)];
      const auto nodes = std::size_t(fem::info(block.type).nodes);
      const Local* cell = &block.nodes[std::size_t(e) * nodes];
      const Global piece = scan_.pieces.of_node(cell[0]);
      if (!Pieces::may_meet(probe.piece, probe.frame, piece, scan_.pieces.frame(piece)) ||
          has(piece) ||
          (piece == probe.piece && touches(probe, cell, fem::info(block.type).corners)))
        return;
      Vec3 y[fem::max_cell_nodes];
      for (std::size_t a = 0; a < nodes; ++a)
        y[a] = scan_.pose.x[std::size_t(cell[a])];
      if (inside_cell(block.type, y, probe.x))
        hits.push_back({probe.sample, piece, block.element[std::size_t(e)], scan_.owner(b, e)});
    });
  }

private:
  bool touches(const Probe& probe, const Local* cell, int corners) const {
    for (int a = 0; a < corners; ++a)
      for (int k = 0; k < probe.corners; ++k)
        if (scan_.mesh.node[std::size_t(cell[a])] == probe.corner[k])
          return true;
    return false;
  }

  const Scan& scan_;
  std::vector<std::pair<int, Local>> place_; ///< block, element
  BoxGrid grid_;
};

Probe make_probe(const Scan& scan, Local i) {
  const Sample& s = scan.samples[std::size_t(i)];
  Probe p{i,  scan.skin.corners(s.face),          scan.pieces.of_face(scan.skin, s.face), 0,
          {}, position(scan.skin, s, scan.pose.x)};
  p.frame = scan.pieces.frame(p.piece);
  for (int a = 0; a < p.corners; ++a)
    p.corner[a] = scan.mesh.node[std::size_t(scan.skin.node(s.face, a))];
  return p;
}

/// Each sample to the ranks whose elements of a piece that it may meet are around it.
std::vector<std::vector<Probe>> make_probes(const Scan& scan) {
  std::vector<std::vector<Probe>> to(std::size_t(scan.mesh.comm.size()));
  for (Local i = 0; i < Local(scan.samples.size()); ++i) {
    const Probe p = make_probe(scan, i);
    int last = -1;
    for (const PiecePart& part : scan.parts) // by rank
      if (part.rank != last && part.all.holds(p.x) &&
          Pieces::may_meet(p.piece, p.frame, part.piece, part.frame)) {
        to[std::size_t(part.rank)].push_back(p);
        last = part.rank;
      }
  }
  return to;
}

std::vector<Hit> find_hits(const Scan& scan) {
  const auto probes = make_probes(scan);
  Box region;
  for (const PiecePart& part : scan.parts)
    for (const PiecePart& other : scan.parts)
      if (part.rank == scan.mesh.comm.rank() && part.all.meets(other.skin) &&
          Pieces::may_meet(part.piece, part.frame, other.piece, other.frame)) {
        Box common = part.all;
        for (int i = 0; i < 3; ++i) {
          common.low[i] = std::max(common.low[i], other.skin.low[i]);
          common.high[i] = std::min(common.high[i], other.skin.high[i]);
        }
        region.add(common);
      }
  const Elements elements(scan, region);
  std::vector<Hit> hits =
      ask<Hit>(scan.mesh.comm, probes,
               [&](const Probe& p, std::vector<Hit>& answers) { elements.find(p, answers); });
  std::sort(hits.begin(), hits.end());
  hits.erase(std::unique(hits.begin(), hits.end(),
                         [](const Hit& a, const Hit& b) {
                           return a.sample == b.sample && a.piece == b.piece;
                         }),
             hits.end());
  return hits;
}

} // namespace

std::vector<Overlap> find_overlaps(const Scan& scan) {
  std::vector<Overlap> overlaps;
  for (const Hit& h : find_hits(scan)) {
    const Sample& s = scan.samples[std::size_t(h.sample)];
    overlaps.push_back({h.sample,
                        position(scan.skin, s, scan.pose.x),
                        h.piece,
                        h.owner,
                        0.0,
                        nothing_near,
                        0.0,
                        0.0,
                        0.0,
                        {}});
  }
  return overlaps;
}

} // namespace abut::audit
