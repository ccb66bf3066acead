// SPDX-License-Identifier: BSD-3-Clause
#include "abut/audit/findings.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>

namespace abut::audit {

namespace {

std::string number(double x) {
  std::ostringstream text;
  text.precision(3);
  text << x;
  return text.str();
}

std::string place_text(const Vec3& x) {
  return "(" + number(x[0]) + ", " + number(x[1]) + ", " + number(x[2]) + ")";
}

std::string quoted(const std::string& word) {
  return "'" + word + "'";
}

/// What the interface has to do with it.
std::string why(const Finding& f, const Names& names) {
  if (f.cause == Cause::no_contact)
    return f.body[0] == f.body[1]
               ? "no contact joins the body with itself: give one whose two surfaces are the same"
               : "no contact joins these bodies: give one";
  if (f.interface == nothing)
    return "";
  const auto i = static_cast<std::size_t>(f.interface);
  const std::string contact = "contact." + names.interfaces[i];
  const std::string sides = quoted(names.primaries[i]) + " and " + quoted(names.secondaries[i]);
  switch (f.cause) {
  case Cause::other_faces:
    return contact + " joins these bodies, but not these faces: add them to " + sides;
  case Cause::rests:
    return contact + " does not act at this time";
  case Cause::no_point:
    return contact + " has no point near there: take the finer side as primary, or more points";
  case Cause::no_partner:
    return contact +
           " sees nothing before its points there: take the finer side as primary, more "
           "points or two_pass, or check which way " +
           sides + " face";
  case Cause::open:
    return contact + " believes in a gap of " + number(f.believed) +
           " there: take the finer side as primary, or more points";
  case Cause::less:
    return contact + " knows of " + number(std::max(0.0, -f.believed)) +
           " only: take a finer mesh, the finer side as primary, or two_pass";
  case Cause::step:
    return "the step is longer than the body is thick: take more steps";
  default:
    return "";
  }
}

std::string element_text(const Names& names, const Finding& f, int k) {
  return "body " + quoted(names.bodies[std::size_t(f.body[k])]) + " (element " +
         std::to_string(f.element[k]) + ")";
}

std::string percent(double share) {
  return number(100.0 * share) + " %";
}

} // namespace

void Measures::raise(const Measures& o) {
  overlap = std::max(overlap, o.overlap);
  overlap_over_face_size = std::max(overlap_over_face_size, o.overlap_over_face_size);
  unseen_overlap = std::max(unseen_overlap, o.unseen_overlap);
  tension = std::max(tension, o.tension);
  cone = std::max(cone, o.cone);
  balance = std::max(balance, o.balance);
}

bool are_alike(const Finding& a, const Finding& b) {
  return a.kind == b.kind && a.interface == b.interface &&
         std::minmax(a.body[0], a.body[1]) == std::minmax(b.body[0], b.body[1]);
}

bool is_worse(const Finding& a, const Finding& b) {
  const auto order = [](const Finding& f) {
    return std::make_tuple(-std::max(f.in_faces, 0.0), -f.value, f.element[0], f.element[1],
                           f.place[0], f.place[1], f.place[2]);
  };
  return order(a) < order(b);
}

std::string text(const Finding& f, const Names& names) {
  const std::string at = " at " + place_text(f.place);
  const std::string contact =
      f.interface == nothing ? "" : "contact." + names.interfaces[std::size_t(f.interface)];
  switch (f.kind) {
  case Kind::overlap:
    return element_text(names, f, 0) + " reaches " + number(f.value) + ", " + number(f.in_faces) +
           " of a face, into " +
           (f.body[0] == f.body[1] ? "itself (element " + std::to_string(f.element[1]) + ")"
                                   : element_text(names, f, 1)) +
           at + ": " + why(f, names);
  case Kind::passage:
    return element_text(names, f, 0) + " went through " + element_text(names, f, 1) +
           " in one step, by " + number(f.value) + at + ": " + why(f, names);
  case Kind::tension:
    return contact + " pulls" + at + " with " + percent(f.value) + " of its largest pressure";
  case Kind::cone:
    return contact + " has a shear" + at + " that friction does not bear, by " + percent(f.value) +
           " of its largest pressure";
  case Kind::force:
    return contact + ": its forces on the two sides are not opposite: " + percent(f.value) +
           " of their size is left over";
  case Kind::moment:
    return contact + ": its forces leave a moment about" + at.substr(3) + ", " + percent(f.value) +
           " of their size times their reach";
  case Kind::believed_force:
    return contact + ": the force that it reports differs from those on the nodes by " +
           percent(f.value) + " of their size";
  }
  return "";
}

} // namespace abut::audit
