// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh_data.hpp"

#include <array>
#include <string>

/// Meshes of simple bodies. Every side set has a node set of the same name; lengths are in the
/// user's unit, angles in degrees. All throw InputError for sizes or counts that make no mesh.
namespace abut::meshgen {

using Size = std::array<double, 3>;
using Divisions = std::array<int, 3>;

struct BoxOptions {
  Size size{1.0, 1.0, 1.0};
  Divisions divisions{1, 1, 1};
  Size origin{0.0, 0.0, 0.0}; ///< corner of smallest coordinates
  fem::CellType element = fem::CellType::hex8;
  std::string name = "box"; ///< of the block
  std::string prefix;       ///< before the names of the sets
  double distortion = 0.0;  ///< random moves of nodes inside, as a fraction of the cell size
};

/// Sets: x0, x1, y0, y1, z0, z1.
mesh::MeshData box(const BoxOptions& options);

struct BlockPairOptions {
  Size lower_size{1.0, 1.0, 1.0};
  Divisions lower_divisions{2, 2, 2};
  Size upper_size{1.0, 1.0, 1.0};
  Divisions upper_divisions{3, 3, 3};
  double gap = 0.0;      ///< between the two; negative: they overlap
  double rotation = 0.0; ///< turns the upper mesh inside its outline about the normal; 0 at its top
  double turn = 0.0;     ///< turns the whole upper block about the normal
  double shift = 0.0;    ///< moves the upper block along x
  double flat = 0.0;     ///< half width along x of the plane part of lower_top, from its middle
  double drop = 0.0;     ///< beyond it lower_top lies drop (|x - middle| - flat)^2 lower [1/length]
  double distortion = 0.0; ///< random moves of nodes inside, as a fraction of the cell size
  fem::CellType element = fem::CellType::hex8;
};

/// Two boxes with nodes of their own: block `lower` on [0,a] x [0,b] x [-c,0], block `upper`
/// centred above it from z = gap. Sets: lower_top, upper_bottom, and for each block
/// BLOCK_x0, BLOCK_x1, BLOCK_y0, BLOCK_y1, lower_bottom, upper_top.
mesh::MeshData block_pair(const BlockPairOptions& options);

struct RoundOptions {
  double radius = 1.0;
  double core = 0.2;       ///< extent of the uniform fine region from the contact point
  int facets = 16;         ///< faces along the core
  double growth = 1.3;     ///< largest ratio of neighbouring cells outside the core
  double depth = -1.0;     ///< extent of the uniform layers below the surface; negative: core / 8
  double max_size = 0.0;   ///< largest cell; 0: radius / 5
  double gap = 0.0;        ///< height of the lowest point above z = 0
  bool plate = true;       ///< adds a block `plate` below z = 0
  double plate_size = 0.0; ///< extent in x (and y) from the contact point; 0: 2.5 core
  int plate_divisions = 1;
  double plate_thickness = 0.0;                ///< 0: core
  fem::CellType element = fem::CellType::hex8; ///< of the round body; the plate is always hex8
};

/// Block `sphere`: the eighth x >= 0, y >= 0, z <= gap + radius of a ball that rests on the plane
/// z = gap, with nodes on the true sphere; an inner cube and three outer blocks, refined at the
/// pole. Sets: contact (curved faces within 2 core of the pole), curved, top, x0, y0; the node set
/// `pole`; with a plate plate_top, plate_bottom. The plate reaches 0.5 core beyond the symmetry
/// planes so that no point at x = 0 or y = 0 projects on its edge. No wedge6.
mesh::MeshData quarter_sphere(const RoundOptions& options);

struct CylinderOptions : RoundOptions {
  double thickness = 0.1; ///< along y
  int thickness_divisions = 1;
};

/// Block `cylinder`: the quarter x >= 0, z <= gap + radius of a cylinder along y that rests on the
/// plane z = gap, a slab 0 <= y <= thickness. Sets as for quarter_sphere, and y1.
mesh::MeshData quarter_cylinder(const CylinderOptions& options);

struct RingsOptions {
  double inner_radius = 1.0;     ///< of the inner ring
  double interface_radius = 1.5; ///< outer face of the inner ring
  double outer_radius = 2.0;     ///< of the outer ring
  double gap = 0.0; ///< inner face of the outer ring minus interface_radius; negative: interference
  double thickness = 0.1;                ///< along z
  int inner_theta = 8, outer_theta = 12; ///< divisions over 90 degrees
  int inner_r = 4, outer_r = 4;
  int thickness_divisions = 1;
  fem::CellType element = fem::CellType::hex8;
};

/// Two quarter rings x >= 0, y >= 0 with nodes on true circles: blocks `inner`, `outer`. Sets:
/// inner_inner, inner_outer, outer_inner, outer_outer (ring, face), and of both x0, y0, z0, z1.
mesh::MeshData rings(const RingsOptions& options);

struct HertzBlockOptions {
  double size = 1.0;     ///< edge length
  double core = 0.2;     ///< extent of the uniform fine region from the origin
  int facets = 16;       ///< faces along the core
  double growth = 1.3;   ///< largest ratio of neighbouring cells outside the core
  double depth = -1.0;   ///< extent of the uniform layers below the surface; negative: core / 8
  double max_size = 0.0; ///< largest cell; 0: size / 5
  fem::CellType element = fem::CellType::hex8;
};

/// Block `block` on [0,size] x [0,size] x [-size,0], refined at the origin. Sets: top, contact (top
/// faces within 2 core of the origin), bottom, x0, x1, y0, y1; the node set `origin`.
mesh::MeshData hertz_block(const HertzBlockOptions& options);

} // namespace abut::meshgen
