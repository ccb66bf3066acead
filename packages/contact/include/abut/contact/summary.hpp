// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/site.hpp"
#include "abut/core/types.hpp"
#include "abut/mesh/surface.hpp"

#include <array>
#include <vector>

/// What an interface shows of its present state.
namespace abut::contact {

/// What an interface carries in all, and means over it.
struct ContactIntegrals {
  std::array<double, 3> force{};  ///< on the primary surface [force]
  std::array<double, 3> moment{}; ///< of that about the origin [force length]
  double normal = 0.0;            ///< integral of the pressure [force]
  double tangential = 0.0;        ///< integral of the size of the tangential traction [force]
  double area = 0.0;              ///< reference area of active points [length^2]
  double current_area = 0.0;      ///< of active points [length^2]
  double mean_penetration = 0.0;  ///< of active points, by their current area [length]
  double mean_gap = 0.0;          ///< of points with a partner, likewise [length]
};

/// What one contact interface carries and how it stands, over all ranks.
struct ContactSummary : ContactIntegrals {
  Global active_points = 0, stick_points = 0, slip_points = 0;
  Global flips = 0;                ///< changes of status in the last step, over all points
  double max_pressure = 0.0;       ///< of the nodal pressure; Cauchy [pressure]
  double max_point_pressure = 0.0; ///< of the points' pressure; Cauchy [pressure]
  double max_penetration = 0.0;    ///< [length]
  double max_penetration_over_face_size = 0.0;
  double min_gap = 0.0, max_gap = 0.0; ///< over points with a partner [length]
  Global points = 0, paired_points = 0;
  double max_slip = 0.0;       ///< longest way slipped since the start [length]
  double penalty_energy = 0.0; ///< in the springs of penalty [energy]
  /// Half the work of the present tractions over what they leave open: penetration and, without
  /// multipliers, motion in stick. By penalty alone it is the energy of those springs. 0 between
  /// rigid bodies, whose only stiffness the penalty is [energy]
  double softness = 0.0;
  double dissipation = 0.0;     ///< by friction, since the start [energy]
  double penalty_factor = 0.0;  ///< f of the automatic penalty; 0 when `penalty` is given [1]
  double initial_overlap = 0.0; ///< deepest at the start, see SiteStart [length]
  Global shifted_points = 0; ///< whose gap has another zero since then: closed, adjusted or fitted
  double max_shift = 0.0;    ///< largest of them, either way [length]
  double facet_rise = 0.0; ///< largest difference then between the gap of the faces and that of the
                           ///< round surfaces that they stand for, either way [length]
};

/// A point that is in contact or touches, once for each direction in which it holds.
struct ClosedPoint {
  Local primary_node;    ///< a surface node of its primary face
  Global secondary_node; ///< a mesh node of its secondary face
  Vec3 x, normal;        ///< position [length], direction that is held
};

/// Weighted sums at the nodes of the faces that a rank has of one side; divide after summing over
/// ranks. One entry for each surface node of that side. Areas are current ones.
struct NodalSums {
  const mesh::Surface* surface; ///< of the interface, which must outlive its use
  double share;                 ///< of the tractions that this pass exerts
  std::vector<double> area;     ///< (face nodes) of each face in each of its nodes [length^2]
  std::vector<double> weight;   ///< the same summed at each node; divides the next two
  std::vector<double> pressure; ///< Cauchy
  std::vector<double> traction; ///< (nodes, 3) on this side, Cauchy
  std::vector<double> seen;     ///< area of points that know of the node; divides the next two
  std::vector<double> gap, slip;
  std::vector<double> pressed; ///< area of those that press; divides the next one
  std::vector<double> status;  ///< 1 slip, 2 stick

  NodalSums(const mesh::Surface& s, double share_of_pass)
      : surface(&s), share(share_of_pass), area(s.nodes.size()), weight(s.node.size()),
        pressure(weight), traction(3 * weight.size()), seen(weight), gap(weight), slip(weight),
        pressed(weight), status(weight) {}
};

/// The two sides of an interface.
enum class Side { primary, secondary };

/// One point as an output file wants it. Where the law holds at nodes the tractions are those of
/// the nodes, interpolated: what acts at the point belongs to averages and oscillates.
struct PointRecord {
  Global face; ///< id of the primary face
  int point;   ///< on the face
  Vec3 x;      ///< present position [length]
  Status status;
  double gap, slip;       ///< [length]
  double pressure, shear; ///< Cauchy [pressure]
  Vec3 traction;          ///< Cauchy [pressure]
  int flips;
  bool paired; ///< it has a partner
};

} // namespace abut::contact
