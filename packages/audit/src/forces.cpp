// SPDX-License-Identifier: BSD-3-Clause
#include "forces.hpp"

#include <algorithm>
#include <cmath>

namespace abut::audit {

namespace {

constexpr double rounding = 1e-6;   ///< share of the largest pressure that tractions may be off
constexpr double unbalanced = 1e-8; ///< share of the forces' sizes that their sum may be

/// The point of the largest excess, over all ranks; ties go to the lowest face. Collective.
struct Worst {
  double value = 0.0;
  const BelievedPoint* point = nullptr;

  void look(double v, const BelievedPoint& p) {
    if (v > value) {
      value = v;
      point = &p;
    }
  }
};

void add(const mesh::Mesh& mesh, Kind kind, int interface, const Worst& worst, double scale,
         double& measure, std::vector<Finding>& found) {
  const double largest = mesh.comm.max(worst.value);
  if (!(scale > 0.0))
    return;
  measure = std::max(measure, largest / scale);
  if (largest / scale <= rounding || worst.value < largest)
    return;
  Finding f;
  f.kind = kind;
  f.interface = interface;
  f.place = worst.point->x;
  f.value = largest / scale;
  f.believed = worst.point->gap;
  found.push_back(f);
}

/// Sums over the nodes of both sides.
struct Sums {
  enum { force, primary = 3, moment = 6, center = 9, size = 12, count };
  double v[count] = {};

  Vec3 at(int first) const { return {{v[first], v[first + 1], v[first + 2]}}; }
  void add(int first, const Vec3& x) {
    for (int i = 0; i < 3; ++i)
      v[first + i] += x[i];
  }
};

/// About `about`; a center is weighted by the sizes of the forces.
Sums sums_of(const mesh::Mesh& mesh, const Pose& pose, const Belief& belief,
             const std::vector<char>& primary, const Vec3& about) {
  Sums s;
  for (const NodalForce& f : belief.forces) {
    const Vec3 arm = pose.x[std::size_t(f.node)] - about;
    const double size = norm(f.force);
    s.add(Sums::force, f.force);
    s.add(Sums::moment, cross(arm, f.force));
    s.add(Sums::center, size * arm);
    s.v[Sums::size] += size;
    if (!primary.empty() && primary[std::size_t(f.node)])
      s.add(Sums::primary, f.force);
  }
  mesh.comm.sum(s.v, Sums::count);
  return s;
}

/// How far forces reach from their center, at most. Collective.
double reach_of(const mesh::Mesh& mesh, const Pose& pose, const Belief& belief,
                const Vec3& center) {
  double reach = 0.0;
  for (const NodalForce& f : belief.forces)
    reach = std::max(reach, norm(pose.x[std::size_t(f.node)] - center));
  return mesh.comm.max(reach);
}

/// The arm of the couple of shear tractions that act on both sides of what is between the surfaces:
/// largest distance of points that carry any. Collective.
double couple_arm(const mesh::Mesh& mesh, const Belief& belief) {
  double arm = 0.0;
  for (const BelievedPoint& p : belief.points)
    if (p.shear > 0.0 || p.held)
      arm = std::max(arm, std::fabs(p.gap));
  return mesh.comm.max(arm);
}

} // namespace

void judge_tractions(const mesh::Mesh& mesh, int interface, const Belief& belief,
                     Measures& measures, std::vector<Finding>& found) {
  double scale = 0.0;
  Worst pull, shear;
  for (const BelievedPoint& p : belief.points) {
    scale = std::max(scale, std::fabs(p.pressure));
    if (!belief.may_pull && !p.held)
      pull.look(-p.pressure, p);
    if (belief.has_cone && !p.held)
      shear.look(p.shear - belief.friction * std::max(p.pressure, 0.0), p);
  }
  scale = mesh.comm.max(scale);
  add(mesh, Kind::tension, interface, pull, scale, measures.tension, found);
  add(mesh, Kind::cone, interface, shear, scale, measures.cone, found);
}

void judge_balance(const mesh::Mesh& mesh, const Pose& pose, int interface, const Belief& belief,
                   const std::vector<char>& primary, Measures& measures,
                   std::vector<Finding>& found) {
  Sums s = sums_of(mesh, pose, belief, primary, Vec3::zero());
  const double size = s.v[Sums::size];
  if (!(size > 0.0))
    return;
  const Vec3 center = (1.0 / size) * s.at(Sums::center);
  s = sums_of(mesh, pose, belief, primary, center);
  const double reach = reach_of(mesh, pose, belief, center), arm = couple_arm(mesh, belief);
  const auto say = [&](Kind kind, double value) {
    measures.balance = std::max(measures.balance, value);
    if (value <= unbalanced)
      return;
    Finding f;
    f.kind = kind;
    f.interface = interface;
    f.place = center;
    f.value = value;
    found.push_back(f);
  };
  say(Kind::force, norm(s.at(Sums::force)) / size);
  if (reach > 0.0)
    say(Kind::moment, std::max(0.0, norm(s.at(Sums::moment)) - arm * size) / (reach * size));
  if (!primary.empty()) {
    const Vec3 said{{belief.force[0], belief.force[1], belief.force[2]}};
    say(Kind::believed_force, norm(s.at(Sums::primary) - said) / size);
  }
}

} // namespace abut::audit
