// SPDX-License-Identifier: BSD-3-Clause
// Elements, points and faces per second of the kernels that a Newton iteration is made of, on two
// stacked blocks of hex8 with a non-matching interface.
#include "abut/assembly/equation_system.hpp"
#include "abut/contact/interaction.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/mesh/generate.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/solid/solid_contribution.hpp"

#include <Tpetra_Core.hpp>
#include <benchmark/benchmark.h>

using namespace abut;

namespace {

struct Blocks {
  mesh::Mesh mesh;
  PhaseTimers timers;
  assembly::EquationSystem system;
  std::shared_ptr<contact::Interaction> contact;

  explicit Blocks(int n)
      : mesh(make_mesh(n)),
        system(assembly::DofMap(mesh, {"x", "y", "z"}, std::vector<char>(mesh.node.size(), 0)),
               timers) {
    solid::MaterialOptions material;
    material.young = 1.0;
    material.poisson = 0.3;
    for (int b = 0; b < 2; ++b)
      system.add(
          std::make_shared<solid::SolidContribution>(mesh, b, solid::make_material(material)));
    contact::ContactOptions options;
    options.name = "pair";
    options.penalty = 100.0;
    contact = std::make_shared<contact::Interaction>(
        mesh.comm, mesh::extract_surface(mesh, "upper_bottom"),
        mesh::extract_surface(mesh, "lower_top"), options, timers);
    system.add(contact);
  }

  static mesh::Mesh make_mesh(int n) {
    const auto cells = [](int k) { return std::to_string(k); };
    return mesh::distribute(mesh::generate("blocks", {{"lower_divisions", cells(n)},
                                                      {"upper_divisions", cells(n + n / 2)},
                                                      {"gap", "-0.001"}}),
                            Comm(MPI_COMM_WORLD));
  }
};

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
  assembly::BlockPattern pattern(blocks.system.dofs());
  for (auto _ : state)
    pattern.build({&cells[0], &cells[1]});
}

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
