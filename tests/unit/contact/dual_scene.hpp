// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"
#include "abut_test/dense_system.hpp"
#include "abut_test/surfaces.hpp"

#include <cmath>
#include <memory>
#include <mpi.h>
#include <vector>

/// Two wavy surfaces of any face type that do not match, moved by hand, under the dual law.
namespace abut::contact::testing {

/// Face types of both sides, the formulation and the averages.
struct Faces {
  fem::FaceType primary, secondary;
  Formulation formulation;
  WeightedGap weighted_gap = WeightedGap::dual;
};

inline std::vector<Faces> all_faces() {
  std::vector<Faces> list;
  const fem::FaceType pairs[][2] = {
      {fem::FaceType::quad4, fem::FaceType::quad4}, {fem::FaceType::quad4, fem::FaceType::tri3},
      {fem::FaceType::tri3, fem::FaceType::quad8},  {fem::FaceType::quad8, fem::FaceType::quad9},
      {fem::FaceType::quad9, fem::FaceType::quad4}, {fem::FaceType::tri6, fem::FaceType::tri6}};
  for (const auto& p : pairs)
    for (Formulation f :
         {Formulation::facet_on_facet, Formulation::node_on_facet, Formulation::sliding_elastic})
      list.push_back({p[0], p[1], f});
  return list;
}

/// The same, and some whose nodes average gaps with N.
inline std::vector<Faces> faces_of_both_averages() {
  std::vector<Faces> list = all_faces();
  for (Formulation f :
       {Formulation::facet_on_facet, Formulation::node_on_facet, Formulation::sliding_elastic})
    list.push_back({fem::FaceType::quad4, fem::FaceType::tri3, f, WeightedGap::hat});
  list.push_back(
      {fem::FaceType::tri6, fem::FaceType::quad8, Formulation::facet_on_facet, WeightedGap::hat});
  return list;
}

/// Whether the tangent of the scene without friction is symmetric.
inline bool is_symmetric(const Faces& f) {
  return f.formulation != Formulation::sliding_elastic && f.weighted_gap == WeightedGap::dual;
}

inline ContactOptions options(const Faces& f, double friction = 0.0) {
  ContactOptions o;
  o.penalty = 7.0;
  o.formulation = f.formulation;
  o.weighted_gap = f.weighted_gap;
  o.friction = friction;
  o.enforcement = Enforcement::augmented_lagrangian;
  return o;
}

/// n x n cells of `type` (triangles: two each) over the square [x0, x1]^2, z and all put right by
/// `place`; the normal looks up, or down when `flip`.
inline mesh::Surface patch(fem::FaceType type, int n, double x0, double x1, bool flip,
                           Global first_node, Global first_face,
                           const std::function<void(double*)>& place) {
  const bool quadratic = type != fem::FaceType::quad4 && type != fem::FaceType::tri3;
  const int m = quadratic ? 2 * n : n, k = quadratic ? 2 : 1;
  const mesh::Surface grid =
      abut_test::grid_surface(m, m, x0, x1, x0, x1, false, first_node, place);
  mesh::Surface s = grid;
  s.type.clear(), s.face_id.clear(), s.nodes.clear(), s.offset.assign(1, 0);
  const auto node = [&](int i, int j) { return j * (m + 1) + i; };
  const auto face = [&](std::vector<int> list) {
    const int corners = fem::face_corners(type);
    if (flip) { // the other way round, from the same first node
      std::reverse(list.begin() + 1, list.begin() + corners);
      if (quadratic)
        std::reverse(list.begin() + corners, list.begin() + 2 * corners);
    }
    list.resize(std::size_t(fem::face_nodes(type)));
    s.nodes.insert(s.nodes.end(), list.begin(), list.end());
    s.offset.push_back(static_cast<Local>(s.nodes.size()));
    s.type.push_back(type);
    s.face_id.push_back(first_face + static_cast<Global>(s.face_id.size()));
  };
  for (int j = 0; j < m; j += k)
    for (int i = 0; i < m; i += k) {
      const int a = node(i, j), b = node(i + k, j), c = node(i + k, j + k), d = node(i, j + k);
      const int h = quadratic ? 1 : 0; // middle nodes, past the end of the list on linear faces
      const int ab = node(i + h, j), bc = node(i + k, j + h), cd = node(i + h, j + k),
                da = node(i, j + h), middle = node(i + h, j + h);
      if (!fem::is_triangle(type)) {
        face({a, b, c, d, ab, bc, cd, da, middle});
      } else {
        face({a, b, c, ab, bc, middle});
        face({a, c, d, middle, cd, da});
      }
    }
  s.modulus.assign(s.type.size(), 0.0);
  s.inverse_depth.assign(s.type.size(), 0.0);
  return s;
}

struct DualScene {
  /// The primary looks down and lies over the secondary, overlapping by about `depth`, turned about
  /// its middle by `turn`. The dual law, unless o says otherwise.
  DualScene(fem::FaceType primary, fem::FaceType secondary, ContactOptions o, double depth = 0.03,
            int n = 3, double wave = 0.03, double turn = 0.0)
      : upper(patch(primary, n, 0.0, 1.0, true, 0, 0,
                    [=](double* x) {
                      x[2] = wave * (std::sin(3.0 * x[0]) + std::cos(2.0 * x[1])) - depth;
                      const double a = x[0] - 0.5, b = x[1] - 0.5;
                      x[0] = 0.5 + std::cos(turn) * a - std::sin(turn) * b;
                      x[1] = 0.5 + std::sin(turn) * a + std::cos(turn) * b;
                    })),
        lower(patch(secondary, 4, -0.3, 1.37, false, upper.num_nodes(), 1000,
                    [=](double* x) {
                      x[2] = wave * (std::sin(2.0 * x[0] + 0.4) + std::cos(3.0 * x[1])) -
                             0.5 * wave * x[0] * x[1];
                    })),
        system(upper.num_nodes() + lower.num_nodes(), 3) {
    o.name = "pair";
    if (o.multipliers == Multipliers::automatic)
      o.multipliers = Multipliers::dual;
    pair = std::make_unique<Interaction>(Comm(MPI_COMM_WORLD), upper, lower, o, timers);
    pair->set_exact_tangent(true);
  }

  /// Moves every node by a smooth field of this size plus that of the upper surface.
  void move(double size, const Vec3& upper_shift, double phase = 0.0) {
    for (const mesh::Surface* s : {&upper, &lower})
      for (std::size_t a = 0; a < s->node.size(); ++a) {
        double* u = &system.u[3 * std::size_t(s->node[a])];
        const double *x = &s->x[3 * a], side = s == &upper ? 1.0 : -0.7;
        u[0] = size * side * std::sin(2.0 * x[1] + x[0] + phase);
        u[1] = size * side * std::cos(1.7 * x[0] - x[1] + phase);
        u[2] = size * side * std::sin(1.3 * x[0] + 2.1 * x[1] + 2.0 * phase);
        for (int i = 0; s == &upper && i < 3; ++i)
          u[i] += upper_shift[i];
      }
  }

  mesh::Surface upper, lower;
  PhaseTimers timers;
  abut_test::DenseSystem system;
  std::unique_ptr<Interaction> pair;
};

} // namespace abut::contact::testing
