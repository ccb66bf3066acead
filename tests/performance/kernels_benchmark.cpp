// SPDX-License-Identifier: BSD-3-Clause
// Elements, points and faces per second of the kernels that a Newton iteration is made of, on two
// stacked blocks of hex8 with a non-matching interface; tangents of one contact point between two
// quad4, in closed form and by automatic differentiation.
#include <Sacado.hpp>

namespace abut {
using Dual = Sacado::Fad::SFad<double, 24>; // the nodes of both faces
inline double value_of(const Dual& x) {
  return x.val();
}
} // namespace abut

#include "abut/contact/point_tangent.hpp"
#include "abut/core/trilinos.hpp"
#include "blocks.hpp"

#include <Tpetra_Core.hpp>
#include <benchmark/benchmark.h>

using namespace abut;
using abut::bench::Blocks;

namespace {

void tangent(benchmark::State& state) {
  Blocks blocks(static_cast<int>(state.range(0)));
  Vector x(blocks.system.dofs().map());
  for (auto _ : state)
    benchmark::DoNotOptimize(blocks.system.tangent(x));
  state.counters["elements"] = benchmark::Counter(double(blocks.mesh.num_elements),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}

void residual(benchmark::State& state) {
  Blocks blocks(static_cast<int>(state.range(0)));
  Vector x(blocks.system.dofs().map()), f(x.getMap());
  for (auto _ : state)
    blocks.system.residual(x, f);
  state.counters["elements"] = benchmark::Counter(double(blocks.mesh.num_elements),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}

/// Refit, projection of every point, grouping into pairs.
void contact_search(benchmark::State& state) {
  Blocks blocks(static_cast<int>(state.range(0)));
  std::vector<double> u(3 * blocks.mesh.node.size(), 0.0);
  for (auto _ : state)
    blocks.contact->prepare({u.data(), 3, 0.0});
  state.counters["points"] = benchmark::Counter(double(blocks.contact->summary().points),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

/// What a change of the pairing beyond the padded pattern costs.
void pattern(benchmark::State& state) {
  Blocks blocks(static_cast<int>(state.range(0)));
  Vector x(blocks.system.dofs().map());
  blocks.system.tangent(x);
  std::vector<Connectivity> cells{blocks.contact->candidates(), blocks.contact->connectivity()};
  unknowns::BlockPattern pattern(blocks.system.dofs());
  for (auto _ : state)
    pattern.build({&cells[0], &cells[1]});
}

/// A point that slips between two warped faces, its anchor on the face that it hits.
struct ContactPair {
  Vec3 x[4] = {{{-1.0, -1.1, -0.12}}, {{-0.9, 1.0, 0.05}}, {{1.1, 1.0, 0.1}}, {{1.0, -0.9, -0.1}}};
  Vec3 y[4] = {{{-1.4, -1.3, 0.16}}, {{1.3, -1.2, 0.21}}, {{1.4, 1.3, 0.14}}, {{-1.2, 1.4, 0.2}}};
  Vec3 x_previous[4], y_previous[4];
  double N[4], dN[4][2];
  contact::ContactPoint c;

  ContactPair(contact::PointRule rule, bool ray) {
    const double xi[2] = {0.2, -0.3}, start[2] = {0.0, 0.0};
    fem::dispatch_face(fem::FaceType::quad4, [&](auto f) {
      double values[fem::max_face_nodes], derivatives[fem::max_face_nodes][2];
      decltype(f)::values(xi, values);
      decltype(f)::derivatives(xi, derivatives);
      for (int a = 0; a < 4; ++a) {
        N[a] = values[a];
        dN[a][0] = derivatives[a][0];
        dN[a][1] = derivatives[a][1];
        x_previous[a] = x[a] + Vec3{{-0.2, 0.1, 0.01 * a}};
        y_previous[a] = y[a] + Vec3{{0.01 * a, 0.0, 0.02}};
      }
    });
    c.rule = rule;
    c.ray = ray;
    c.shape = {4, N, dN};
    c.weight = 0.3;
    c.penalty = 50.0;
    c.friction = 0.3;
    c.multiplier = 2.0;
    c.x_previous = x_previous;
    c.y_previous = y_previous;
    const auto p = contact::primary_point(c.shape, x);
    c.carried = contact::store_traction(p, 0.5 * p.tangent[0] + 0.1 * p.tangent[1]);
    Vec3 origin = p.x, direction = -p.normal;
    if (rule == contact::PointRule::inclined_slip)
      contact::inclined_ray(c, p, contact::anchored_trial(c, p, y), origin, direction);
    const auto foot = search::project(c.face, y, p.x, start);
    const auto hit = search::intersect(c.face, y, origin, direction, start);
    for (int i = 0; i < 2; ++i)
      c.xi[i] = ray ? hit.xi[i] : foot.xi[i];
  }
};

void closed_tangent(benchmark::State& state, contact::PointRule rule, bool ray) {
  ContactPair pair(rule, ray);
  double k[24 * 24] = {};
  for (auto _ : state) {
    benchmark::DoNotOptimize(contact::point_tangent(pair.c, pair.x, pair.y, pair.y, true, k));
    benchmark::ClobberMemory();
  }
}

void automatic_tangent(benchmark::State& state, contact::PointRule rule, bool ray) {
  ContactPair pair(rule, ray);
  double k[24 * 24] = {};
  for (auto _ : state) {
    Vec<Dual, 3> u[8];
    Dual r[24];
    for (int a = 0; a < 24; ++a) {
      u[a / 3][a % 3] = Dual(24, a, a < 12 ? pair.x[a / 3][a % 3] : pair.y[a / 3 - 4][a % 3]);
      r[a] = 0.0;
    }
    contact::point_force(pair.c, contact::point_traction<Dual>(pair.c, u, u + 4, u + 4), r);
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j)
        k[24 * i + j] += r[i].dx(j);
    benchmark::DoNotOptimize(k);
    benchmark::ClobberMemory();
  }
}

#define ABUT_POINT_BENCHMARK(rule, name, ray)                                                      \
  BENCHMARK_CAPTURE(closed_tangent, name, contact::PointRule::rule, ray);                          \
  BENCHMARK_CAPTURE(automatic_tangent, name, contact::PointRule::rule, ray)

ABUT_POINT_BENCHMARK(frictionless, closest_frictionless, false);
ABUT_POINT_BENCHMARK(incremental_stick, closest_stick, false);
ABUT_POINT_BENCHMARK(incremental_slip, closest_slip, false);
ABUT_POINT_BENCHMARK(frictionless, ray_frictionless, true);
ABUT_POINT_BENCHMARK(incremental_stick, ray_stick, true);
ABUT_POINT_BENCHMARK(incremental_slip, ray_slip, true);
ABUT_POINT_BENCHMARK(anchored, ray_anchored, true);
ABUT_POINT_BENCHMARK(inclined_slip, ray_inclined_slip, true);
ABUT_POINT_BENCHMARK(literal_slip, ray_literal_slip, true);
#undef ABUT_POINT_BENCHMARK

BENCHMARK(tangent)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(residual)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(contact_search)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(pattern)->Arg(16)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
