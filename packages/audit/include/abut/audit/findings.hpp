// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/types.hpp"

#include <string>
#include <vector>

namespace abut::audit {

/// Of one step, or the largest of a run; 0 where there is nothing.
struct Measures {
  double overlap = 0.0;                ///< deepest point of one body in another [length]
  double overlap_over_face_size = 0.0; ///< in sizes of the smaller face there [1]
  double unseen_overlap = 0.0;         ///< deepest that no interface knows of [length]
  double tension = 0.0; ///< largest pull over the largest pressure of the interface [1]
  double cone = 0.0;    ///< largest shear beyond the cone over the largest pressure [1]
  double balance = 0.0; ///< force or moment left over of an interface, over their sizes [1]

  void raise(const Measures& other);
  template <class V> friend void list_state(V& v, Measures& m) {
    v(m.overlap, m.overlap_over_face_size, m.unseen_overlap, m.tension, m.cone, m.balance);
  }
};

enum class Kind { overlap, passage, tension, cone, force, moment, believed_force };

/// Why an interface does not know of an overlap or a passage.
enum class Cause {
  none,        ///< another kind
  no_contact,  ///< no interface joins the two bodies
  other_faces, ///< one joins the bodies, but not the faces that are in each other
  rests,       ///< it does not act now
  no_point,    ///< none of its points is near
  no_partner,  ///< the nearest one sees nothing before it
  open,        ///< the nearest one believes in a gap
  less,        ///< it believes in less
  step,        ///< the step is longer than the body is thick
};

constexpr int nothing = -1;

/// Something that must not be in a converged step.
struct Finding {
  Kind kind = Kind::overlap;
  Cause cause = Cause::none;
  int interface = nothing;          ///< index in the list of interfaces
  int body[2] = {nothing, nothing}; ///< the one that reaches into the other, and that
  Global element[2] = {0, 0};       ///< their elements there, by the number map of the input
  Vec3 place = Vec3::zero();        ///< present position [length]
  double value = 0.0;               ///< [length], or a share as Measures has it [1]
  double in_faces = 0.0;            ///< value in sizes of the smaller face [1]
  double believed = 0.0;            ///< gap there as the interface has it [length]
};

/// Whether one would be said in place of the other: same kind, interface, bodies in either order.
bool are_alike(const Finding& a, const Finding& b);
/// Whether a is the worse of two that are alike. In an order that knows no ranks.
bool is_worse(const Finding& a, const Finding& b);

/// What one step was found to have, the same on all ranks.
struct Findings {
  Measures measures;
  std::vector<Finding> list; ///< of each kind, interface and pair of bodies the worst
};

/// The names that findings are told with.
struct Names {
  std::vector<std::string> bodies;
  std::vector<std::string> interfaces, primaries, secondaries; ///< (interfaces)
};

/// One sentence: what, how much, where, why, and what to do.
std::string text(const Finding& finding, const Names& names);

} // namespace abut::audit
