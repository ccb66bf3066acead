// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/scene/scene.hpp"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace abut::scene {

/// A connected deformable piece or a rigid body with unknowns: what may move as a whole.
struct Piece {
  Vec3 center = Vec3::zero();
  double size = 0.0; ///< half the largest extent along an axis [length]
  int body = 0;      ///< of the options
};

/// What may move as a whole, what moves each node, and which pieces share nodes or joints. The same
/// on all ranks, but for the nodes.
class Pieces {
public:
  static constexpr std::size_t none = std::size_t(-1);

  /// Collective.
  Pieces(const Options& options, const Scene& scene);

  std::size_t size() const { return pieces_.size(); }
  const Piece& operator[](std::size_t piece) const { return pieces_[piece]; }
  bool is_rigid(std::size_t piece) const { return piece >= first_body_; }
  /// Of a rigid body of the scene; none where it has no unknowns.
  std::size_t of_body(int body) const {
    return body < 0 ? none : piece_of_body_[std::size_t(body)];
  }
  /// The deformable piece of a local node, or none.
  std::size_t deformable(Local node) const;
  /// The piece that moves a node: a rigid body before a deformable one; none when it is prescribed.
  std::size_t mover(Local node) const;

  /// Groups of pieces that share nodes or joints; each once. Collective.
  std::vector<std::vector<std::size_t>> clusters() const;

private:
  void find_deformable();
  void find_bodies(const Options& options);

  const Scene& scene_;
  std::vector<Global> label_; ///< of deformable pieces, per local node; -1: none
  std::vector<Piece> pieces_; ///< deformable ones, then rigid bodies
  std::size_t first_body_ = 0;
  std::map<Global, std::size_t> piece_of_label_;
  std::vector<std::size_t> piece_of_body_;
};

} // namespace abut::scene
