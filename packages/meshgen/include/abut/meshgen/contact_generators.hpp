// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/fem/cell.hpp"
#include "abut/mesh/mesh_data.hpp"
#include "abut/meshgen/generators.hpp"

/// Meshes of two bodies in contact whose exact solution is known. As in generators.hpp: every side
/// set has a node set of the same name; all throw InputError for sizes or counts that make no mesh.
namespace abut::meshgen {

enum class InterfaceShape {
  plane,    ///< z = tan(angle) (x - width/2)
  cylinder, ///< z = sqrt(R^2 - x^2) - R: along y, the lower body is convex
  sphere,   ///< z = sqrt(R^2 - x^2 - y^2) - R: the lower body is convex
  sine      ///< z = amplitude sin(2 pi x / width)
};

struct InterfaceOptions {
  InterfaceShape shape = InterfaceShape::plane;
  double angle = 30.0;                           ///< of the plane to the horizontal [degree]
  double radius = 1.0;                           ///< R of cylinder and sphere
  double amplitude = 0.1;                        ///< of the sine
  double width = 1.0, depth = 1.0;               ///< along x and y
  double lower_height = 1.0, upper_height = 1.0; ///< below and above z = 0
  Divisions lower_divisions{4, 4, 4}, upper_divisions{6, 6, 6};
  fem::CellType element = fem::CellType::hex8;
};

/// The box [0,width] x [0,depth] x [-lower_height, upper_height], cut by a surface z(x,y) into
/// blocks `lower` and `upper` with nodes of their own, all of them on the true surface. Sets:
/// lower_top and upper_bottom (the interface), lower_bottom, upper_top, and for each block
/// BLOCK_x0, BLOCK_x1, BLOCK_y0, BLOCK_y1 and BLOCK_outer (all but the interface).
mesh::MeshData interface_pair(const InterfaceOptions& options);

struct RoundPairOptions {
  double upper_radius = 1.0, lower_radius = 1.0;
  double core = 0.2;     ///< extent of the uniform fine region from the contact point
  int upper_facets = 12; ///< faces along the core
  int lower_facets = 8;  ///< faces along the core
  double growth = 1.3;   ///< largest ratio of neighbouring cells outside the core
  double depth = -1.0;   ///< extent of the uniform layers below the surface; negative: core / 8
  double max_size = 0.0; ///< largest cell; 0: radius / 5
  fem::CellType element = fem::CellType::hex8;
};

/// Quarters x >= 0, y >= 0 of two half balls that touch at the origin: block `upper` (z >= 0),
/// block `lower` (z <= 0), as quarter_sphere makes them. Sets: for each block BLOCK_contact and
/// BLOCK_curved, upper_top, lower_bottom, and of both x0, y0.
mesh::MeshData sphere_pair(const RoundPairOptions& options);

struct CylinderPairOptions : RoundPairOptions {
  double thickness = 0.1; ///< along y
  int thickness_divisions = 1;
};

/// Halves x >= 0 of two half cylinders along y that touch along x = z = 0. Sets as for sphere_pair,
/// and y1.
mesh::MeshData cylinder_pair(const CylinderPairOptions& options);

struct ParaboloidOptions {
  double radius = 1.0;   ///< R of the face z = r^2/(2 R)
  double size = 1.0;     ///< edge length of the body, and of a plate that is meshed
  double core = 0.1;     ///< extent of the uniform fine region from the axis
  int facets = 8;        ///< faces along the core
  double growth = 1.25;  ///< largest ratio of neighbouring cells outside the core
  double depth = -1.0;   ///< extent of the uniform layers below the surfaces; negative: core / 2
  double max_size = 0.0; ///< largest cell; 0: size / 5
  double gap = 0.0;      ///< height of the lowest point above z = 0
  int plate_facets =
      0; ///< faces of the plate along the core; 0: the plate is one cell, to be rigid
  fem::CellType element = fem::CellType::hex8; ///< of both bodies; a plate of one cell is hex8
};

/// Block `paraboloid`: the quarter x >= 0, y >= 0 of a block whose lower face bulges as
/// z = gap + r^2/(2 R), with nodes on the true surface; its layers run parallel to that face. Block
/// `plate` below z = 0. Sets: contact (lower faces within 2 core of the axis), top, plate_top,
/// plate_bottom, and x0, x1, y0, y1, of both bodies where the plate is meshed; the node set `pole`.
/// A plate of one cell reaches 2.5 core, and core beyond the symmetry planes.
mesh::MeshData paraboloid(const ParaboloidOptions& options);

enum class PunchShape {
  strip, ///< half of a long punch, 0 <= x <= radius, a slab along y
  disc   ///< quarter of a circular punch about the z axis
};

struct PunchOptions {
  PunchShape shape = PunchShape::strip;
  double radius = 1.0; ///< half width of the strip
  int facets = 10;     ///< faces of the body from the middle to the edge of the punch
  double offset = 0.0; ///< the edge lies so many cells inside a line of the mesh, 0 <= offset < 1
  double size = 10.0;  ///< reach of the body sideways and downwards
  double growth = 1.3; ///< largest ratio of neighbouring cells beyond 1.5 radius and below radius/2
  double max_size = 0.0;   ///< largest cell; 0: size / 5
  double thickness = 0.1;  ///< of the strip along y
  int punch_divisions = 1; ///< faces of the punch from its middle to its edge; for a disc even, and
                           ///< its outline has as many corners over 90 degrees
  fem::CellType element = fem::CellType::hex8; ///< of the body; the punch is always hex8
};

/// Block `body` below z = 0 (a slab [0,size] x [0,thickness], or a quarter cylinder of radius size,
/// size deep), and block `punch` above it, sharp-edged. Sets: top, contact (top faces within 2
/// radius of the middle), bottom, side (x or r = size), x0, y0, and y1 of the strip; punch_bottom,
/// punch_top. The outline of a disc is a polygon of the same area as the circle. No wedge6.
mesh::MeshData punch(const PunchOptions& options);

} // namespace abut::meshgen
