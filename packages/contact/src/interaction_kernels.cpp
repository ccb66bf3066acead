// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"

#include "abut/contact/dual_columns.hpp"
#include "abut/core/error.hpp"
#include "automatic_tangent.hpp"
#include "constants.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace abut::contact {

namespace {

constexpr int max_nodes = 3 * fem::max_face_nodes;

/// Positions of the nodes of a pair's secondary faces.
struct SecondaryNodes {
  Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes], z[fem::max_face_nodes];
};

SecondaryNodes secondary_nodes(const FacingSurface& surface, Local facing, Local anchor) {
  SecondaryNodes s;
  surface.coordinates(facing, s.y);
  surface.previous_coordinates(facing, s.y_previous);
  surface.coordinates(anchor >= 0 ? anchor : facing, s.z);
  return s;
}

/// Far from equilibrium the spring of a deep point presses so hard that the terms of the tangent
/// that turn its force would outweigh all others: they are taken for one that is not deeper than
/// this.
void moderate(ContactPoint& c, const PointState& state, double size) {
  const double excess = state.pressure - state.multiplier - moderate_depth * size * state.penalty;
  if (excess > 0.0 && c.ray)
    c.multiplier -= excess;
}

void make_symmetric(int size, double* k) {
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < i; ++j)
      k[i * size + j] = k[j * size + i] = 0.5 * (k[i * size + j] + k[j * size + i]);
}

} // namespace

bool Interaction::symmetric() const {
  return options_.tangent == Tangent::symmetric ||
         (!options_.uses_ray() && !options_.has_anchors() && options_.friction == 0.0);
}

/// A gap is a difference of positions: it is known to a few units in their last place.
double Interaction::round_off_force2() const {
  constexpr double last_place = 1e-15;
  double sum = 0.0;
  for (const Pair& pair : pair_list_)
    for (Local p : pair.points) {
      const double known = last_place * norm(primary_nodes(pair.face)[0]);
      const double force =
          measure(pair.face, p) * points_[point_index(pair.face, p)].penalty * known;
      sum += force * force;
    }
  return sum;
}

void Interaction::residual(const NodalFields&, const ResidualScatter& scatter) {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  Kokkos::parallel_for(
      "abut::contact::residual",
      Kokkos::RangePolicy<Execution>(0, static_cast<Local>(pair_list_.size())), [&](Local i) {
        const Pair& pair = pair_list_[i];
        const fem::FaceType type = facing_.type(pair.facing);
        double r[max_nodes * 3] = {};
        for (Local p : pair.points) { // the search left every point's traction
          const PointState& state = points_[point_index(pair.face, p)];
          double N[fem::max_face_nodes];
          fem::dispatch_face(type, [&](auto face) { decltype(face)::values(state.xi, N); });
          add_force(shape(pair.face, p), fem::face_nodes(type), N,
                    share_ * measure(pair.face, p) * state.traction, r);
        }
        scatter.add(i, r);
      });
}

void Interaction::tangent(const NodalFields&, const TangentScatter& scatter) {
  keep_iterate();
  using Execution = Kokkos::DefaultHostExecutionSpace;
  int singular = 0;
  Kokkos::parallel_reduce(
      "abut::contact::tangent",
      Kokkos::RangePolicy<Execution>(0, static_cast<Local>(pair_list_.size())),
      [&](Local i, int& failed) {
        const Pair& pair = pair_list_[i];
        const auto s = secondary_nodes(facing_, pair.facing, pair.anchor);
        const int n = 3 * pairs_.size(i);
        double k[9 * max_nodes * max_nodes];
        std::fill_n(k, n * n, 0.0);
        for (Local p : pair.points) {
          ContactPoint c = dual_ ? given_point(pair.face, p, s.y_previous)
                                 : contact_point(pair.face, p, s.y_previous);
          if (!exact_tangent_ && searches_ <= early_searches)
            moderate(c, points_[point_index(pair.face, p)], size_[pair.face]);
          const Vec3* x = primary_nodes(pair.face);
          const bool one_face = pair.anchor < 0;
          const bool fine = options_.tangent == Tangent::automatic
                                ? automatic_tangent(c, x, s.y, s.z, one_face, k)
                            : dual_ && friction_ > 0.0
                                ? given_traction_tangent(c, given_shear(pair.face, p), x, s.y, k)
                                : point_tangent(c, x, s.y, s.z, one_face, k);
          failed += !fine;
        }
        if (options_.tangent == Tangent::symmetric)
          make_symmetric(n, k);
        scatter.add(i, k);
      },
      singular);
  if (dual_)
    scatter_node_cells(scatter);
  if (singular > 0)
    throw SolveError("contact." + options_.name + ": " + std::to_string(singular) +
                     " points lie at the centre of curvature of '" + secondary_.name +
                     "', or their ray runs along it");
}

} // namespace abut::contact
