// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interface_sides.hpp"
#include "pieces.hpp"
#include "samples.hpp"

#include "abut/audit/findings.hpp"

#include <vector>

namespace abut::audit {

/// A body and one of its elements, by the number map of the input.
struct Owner {
  int body = nothing;
  Global element = 0;
};

constexpr Global nothing_near = -1; ///< id of no face

/// A sample of this rank that lies in a piece which does not touch it.
struct Overlap {
  Local sample;
  Vec3 x;                   ///< where it is [length]
  Global piece;             ///< that it is in
  Owner owner;              ///< of the element there
  double depth;             ///< distance to the skin through which it came [length]
  Global face;              ///< nearest there
  double size, scale, rise; ///< of that face
  Sides sides;              ///< likewise
};

/// All samples and what they may be in, brought up to date for one look.
struct Scan {
  const mesh::Mesh& mesh;
  const Skin& skin;
  const Pieces& pieces;
  const InterfaceSides& sides;
  const std::vector<Sample>& samples;
  const Pose& pose;
  const std::vector<PiecePart>& parts;
  const std::vector<int>& body_of_block;

  Owner owner(int block, Local element) const {
    return {body_of_block[std::size_t(block)],
            mesh.blocks[std::size_t(block)].element_id[std::size_t(element)]};
  }
  Owner owner_of_face(Local face) const {
    return owner(skin.block[std::size_t(face)], skin.element[std::size_t(face)]);
  }
};

/// By sample, then piece, without depths; the same on any number of ranks. Collective.
std::vector<Overlap> find_overlaps(const Scan& scan);

} // namespace abut::audit
