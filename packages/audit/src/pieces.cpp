// SPDX-License-Identifier: BSD-3-Clause
#include "pieces.hpp"

#include "ask.hpp"

#include "abut/mesh/components.hpp"

#include <algorithm>

namespace abut::audit {

namespace {

/// A frame that no other node has yet, while pieces are looked at.
constexpr int unknown = -2;

struct PieceFrame {
  Global piece;
  int frame;
};

int joined(int a, int b) {
  return a == unknown || a == b ? b : b == unknown ? a : deforms;
}

} // namespace

Pieces::Pieces(const mesh::Mesh& mesh, const Skin& skin, const std::vector<int>& frame_of_node)
    : mesh_(mesh),
      of_node_(mesh::connected_pieces(mesh, std::vector<char>(mesh.blocks.size(), 1))) {
  std::map<Global, int> frames;
  for (std::size_t n = 0; n < of_node_.size(); ++n) {
    if (of_node_[n] < 0)
      continue;
    int& frame = frames.try_emplace(of_node_[n], unknown).first->second;
    frame = joined(frame, frame_of_node[n]);
  }
  std::vector<PieceFrame> mine;
  for (const auto& [piece, frame] : frames)
    mine.push_back({piece, frame});
  for (const PieceFrame& p : share(mesh.comm, mine)) {
    int& frame = frame_.try_emplace(p.piece, unknown).first->second;
    frame = joined(frame, p.frame);
  }
  for (const mesh::Block& block : mesh.blocks)
    quadratic_ = quadratic_ || fem::info(block.type).nodes != fem::info(block.type).corners;
  for (Local f = 0; f < skin.faces(); ++f) {
    double& shortest = shortest_.try_emplace(of_face(skin, f), 1e300).first->second;
    for (int a = 0; a < skin.corners(f); ++a) {
      const auto* from = &mesh.x[3 * std::size_t(skin.node(f, a))];
      const auto* to = &mesh.x[3 * std::size_t(skin.node(f, (a + 1) % skin.corners(f)))];
      const Vec3 edge{{to[0] - from[0], to[1] - from[1], to[2] - from[2]}};
      shortest = std::min(shortest, norm(edge));
    }
  }
}

std::vector<PiecePart> Pieces::parts(const Skin& skin, const Pose& pose) const {
  std::map<Global, PiecePart> here;
  const auto part = [&](Global piece) -> PiecePart& {
    return here
        .try_emplace(piece,
                     PiecePart{piece, mesh_.comm.rank(), frame(piece), {}, {}, {}, {}, 1e300})
        .first->second;
  };
  PiecePart* last = nullptr;
  for (std::size_t n = 0; n < of_node_.size(); ++n) {
    if (of_node_[n] < 0)
      continue;
    if (!last || last->piece != of_node_[n])
      last = &part(of_node_[n]);
    last->all.add(pose.x[n]);
  }
  for (Local f = 0; f < skin.faces(); ++f) {
    const Global piece = of_face(skin, f);
    if (!last || last->piece != piece)
      last = &part(piece);
    for (int a = 0; a < fem::face_nodes(skin.type(f)); ++a) {
      const auto n = std::size_t(skin.node(f, a));
      last->skin.add(pose.x[n]);
      last->swept.add(pose.before[n]);
      last->way.add(pose.x[n] - pose.before[n]);
    }
  }
  std::vector<PiecePart> mine;
  for (auto& [piece, p] : here) {
    p.swept.add(p.skin);
    if (const auto found = shortest_.find(piece); found != shortest_.end())
      p.shortest = found->second;
    for (Box* box : {&p.all, &p.skin, &p.swept})
      if (quadratic_ && !box->is_empty())
        box->widen(bulge);
    mine.push_back(p);
  }
  return share(mesh_.comm, mine);
}

} // namespace abut::audit
