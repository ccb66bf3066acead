// SPDX-License-Identifier: BSD-3-Clause
// Kernels against the two roofs of the machine, which are measured first: bandwidth by a triad of
// arrays beyond the caches, arithmetic by multiply-adds in registers. Counted is what a kernel must
// at least move or do, so that a share is no larger than the true one.
#include "abut/core/trilinos.hpp"
#include "abut/core/vector_units.hpp"
#include "abut/multigrid/multigrid.hpp"
#include "abut/search/bvh.hpp"
#include "abut/search/queries.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solver/assembled_system.hpp"
#include "blocks.hpp"

#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>

using namespace abut;
using abut::bench::Blocks;

namespace {

/// Least seconds of a few calls.
template <class Work> double seconds(Work work) {
  double least = HUGE_VAL;
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  return least;
}

/// Multiply-adds on eight registers' worth of numbers at a time.
struct MultiplyAdds {
  static constexpr int width = 64, count = 1000;
  double* out;

  void operator()(Local i) const {
    double sum[width];
    for (int l = 0; l < width; ++l)
      sum[l] = out[l];
    for (int k = 0; k < count; ++k)
#pragma omp simd
      for (int l = 0; l < width; ++l)
        sum[l] = sum[l] * 0.999 + 1e-3;
    for (int l = 0; l < width; ++l)
      out[l] = sum[l] + i;
  }
};

/// Of one core. [bytes/s], [1/s]
struct Roofs {
  double bandwidth, arithmetic;

  Roofs() {
    const std::size_t n = std::size_t(1) << 23;
    std::vector<double> a(n), b(n, 1.0), c(n, 2.0);
    bandwidth = 24.0 * double(n) / seconds([&] {
                  for (std::size_t i = 0; i < n; ++i)
                    a[i] = b[i] + 0.5 * c[i];
                  benchmark::DoNotOptimize(a.data());
                  benchmark::ClobberMemory();
                });
    double sums[MultiplyAdds::width] = {};
    constexpr int calls = 1000;
    arithmetic = 2.0 * MultiplyAdds::width * MultiplyAdds::count * calls / seconds([&] {
                   with_vector_units(MultiplyAdds{sums}, [](const auto& kernel) {
                     Kokkos::parallel_for("multiply_adds", Range(0, calls), kernel);
                   });
                   benchmark::DoNotOptimize(sums);
                 });
  }
};

const Roofs& roofs() {
  static const Roofs measured;
  return measured;
}

/// Rates of a kernel that moves so many bytes and does so many operations in each iteration.
void rate(benchmark::State& state, double bytes, double operations) {
  using benchmark::Counter;
  const auto each = Counter::kIsIterationInvariantRate;
  if (bytes > 0.0) {
    state.counters["GB/s"] = Counter(1e-9 * bytes, each);
    state.counters["of_bandwidth"] = Counter(bytes / roofs().bandwidth, each);
  }
  if (operations > 0.0) {
    state.counters["GF/s"] = Counter(1e-9 * operations, each);
    state.counters["of_arithmetic"] = Counter(operations / roofs().arithmetic, each);
  }
}

/// The first tangent of two blocks, and a hierarchy for it.
struct System {
  Blocks blocks;
  solver::AssembledSystem equations;
  Vector x;
  RCP<const Matrix> matrix;

  explicit System(benchmark::State& state)
      : blocks(static_cast<int>(state.range(0))), equations(blocks.system), x(equations.map()) {
    blocks.system.set_constraints(bottom());
    matrix = equations.tangent(x);
    state.counters["unknowns"] = double(x.getGlobalLength());
  }
  std::vector<assembly::Constraint> bottom() const {
    std::vector<assembly::Constraint> all;
    const mesh::Mesh& mesh = blocks.mesh;
    for (Local a = 0; a < mesh.num_owned; ++a)
      for (int d = 0; d < 3; ++d)
        if (mesh.x[3 * static_cast<std::size_t>(a) + 2] == 0.0)
          all.push_back({a, d, [](double) { return 0.0; }});
    return all;
  }
  std::unique_ptr<multigrid::Multigrid> hierarchy() const {
    const Comm comm(MPI_COMM_WORLD);
    return std::make_unique<multigrid::Multigrid>(
        comm, multigrid::rigid_motions(comm, 3, equations.row_places()));
  }
};

void sparse_product(benchmark::State& state) {
  const System s(state);
  Vector y(s.x.getMap());
  for (auto _ : state)
    s.matrix->apply(s.x, y);
  const auto entries = double(s.matrix->getLocalMatrixHost().nnz());
  rate(state, 12.0 * entries + 24.0 * double(s.x.getLocalLength()), 2.0 * entries);
}

/// Counted: the matrices of all levels twice, in single precision.
void v_cycle(benchmark::State& state) {
  const System s(state);
  const auto hierarchy = s.hierarchy();
  hierarchy->setup(*s.matrix);
  std::vector<double> b(s.x.getLocalLength(), 1.0), z(b.size());
  for (auto _ : state)
    hierarchy->apply(b.data(), z.data());
  double bytes = 0.0, operations = 0.0;
  for (const multigrid::LevelReport& level : hierarchy->levels()) {
    const int n = level.unknowns_per_row;
    bytes += 2.0 * double(level.blocks) * (4.0 * n * n + 4.0);
    operations += 2.0 * double(level.blocks) * 2.0 * n * n;
  }
  rate(state, bytes, operations);
  const auto& last = hierarchy->levels().back();
  state.counters["levels"] = double(hierarchy->levels().size());
  state.counters["coarsest_unknowns"] = double(last.rows * last.unknowns_per_row);
}

void multigrid_setup(benchmark::State& state) {
  const System s(state);
  const auto hierarchy = s.hierarchy();
  for (auto _ : state)
    hierarchy->setup(*s.matrix);
}

void multigrid_refresh(benchmark::State& state) {
  const System s(state);
  const auto hierarchy = s.hierarchy();
  hierarchy->setup(*s.matrix);
  for (auto _ : state)
    hierarchy->refresh(*s.matrix, true);
}

/// The same element over and over, in the cache: arithmetic alone.
template <fem::CellType C> struct OneElement {
  static constexpr int n = solid::ReferenceCell<C>::nodes;
  const solid::ReferenceCell<C>* cell;
  solid::NeoHookean law;
  double* k;

  void operator()(Local e) const {
    double x[3][n], u[3][n];
    for (int a = 0; a < n; ++a) {
      double xi[3];
      fem::CellShape<C>::node(a, xi);
      for (int i = 0; i < 3; ++i)
        x[i][a] = xi[i], u[i][a] = 0.02 * xi[(i + 1) % 3] + 1e-9 * e;
    }
    solid::element_tangent<C>(*cell, law, x, u, k);
  }
};

/// Counted: gradients, c B and B^T c B of each point.
template <fem::CellType C> void element_tangent(benchmark::State& state) {
  constexpr int n = OneElement<C>::n, points = solid::ReferenceCell<C>::points, elements = 1000;
  std::vector<double> k(9 * n * n);
  const OneElement<C> kernel{&solid::reference_cell<C>(), {1.0, 1.0}, k.data()};
  for (auto _ : state) {
    with_vector_units(
        kernel, [](const auto& run) { Kokkos::parallel_for("elements", Range(0, elements), run); });
    benchmark::DoNotOptimize(k.data());
  }
  rate(state, 0.0, elements * double(points) * (42.0 * n * n + 108.0 * n + 54.0 * n));
}

double wave(double x, double y) {
  return 0.05 * std::sin(7.0 * x) * std::cos(5.0 * y);
}

/// A wavy sheet of cells x cells quad4 over the unit square.
struct Sheet {
  search::Faces faces;
  search::Bvh<3> tree;

  explicit Sheet(int cells) {
    const Local side = cells + 1;
    std::vector<Vec3> x;
    for (Local j = 0; j < side; ++j)
      for (Local i = 0; i < side; ++i) {
        const double at[2] = {double(i) / cells, double(j) / cells};
        x.push_back({{at[0], at[1], wave(at[0], at[1])}});
      }
    std::vector<Local> offset{0}, node;
    for (Local j = 0; j < cells; ++j)
      for (Local i = 0; i < cells; ++i) {
        const Local first = j * side + i;
        for (const Local a : {first, first + 1, first + side + 1, first + side})
          node.push_back(a);
        offset.push_back(static_cast<Local>(node.size()));
      }
    const std::vector<fem::FaceType> types(offset.size() - 1, fem::FaceType::quad4);
    faces = {make_view("type", types), make_view("offset", offset), make_view("node", node),
             make_view("x", x)};
    std::vector<search::Box<3>> boxes;
    for (Local f = 0; f < faces.size(); ++f) {
      Vec3 y[fem::max_face_nodes];
      faces.coordinates(f, y);
      boxes.push_back(search::face_box(fem::FaceType::quad4, y));
    }
    tree.build(boxes);
  }
};

/// Within a face's size of the sheet, in the order of a surface, as points of contact come.
std::vector<Vec3> points_near_the_sheet(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double x = (i % 317 + 0.3) / 317.0, y = (i / 317 % 317 + 0.4) / 317.0;
    points.push_back({{x, y, wave(x, y) + 0.002 * std::sin(double(i))}});
  }
  return points;
}

void closest_points(benchmark::State& state) {
  const Sheet sheet(static_cast<int>(state.range(0)));
  const auto points = make_view("points", points_near_the_sheet(100000));
  for (auto _ : state)
    benchmark::DoNotOptimize(search::closest_points(sheet.faces, sheet.tree.view(), points, 1.0));
  state.counters["queries/s"] =
      benchmark::Counter(1e5, benchmark::Counter::kIsIterationInvariantRate);
}

void line_hits(benchmark::State& state) {
  const Sheet sheet(static_cast<int>(state.range(0)));
  const Vec3 direction = (1.0 / std::sqrt(1.0029)) * Vec3{{0.05, 0.02, -1.0}};
  std::vector<search::Line> lines;
  for (const Vec3& x : points_near_the_sheet(100000))
    lines.push_back({x, direction});
  const auto view = make_view("lines", lines);
  for (auto _ : state)
    benchmark::DoNotOptimize(search::line_hits(sheet.faces, sheet.tree.view(), view, 1.0));
  state.counters["queries/s"] =
      benchmark::Counter(1e5, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(sparse_product)->Arg(16)->Arg(24)->Unit(benchmark::kMillisecond);
BENCHMARK(v_cycle)->Arg(16)->Arg(24)->Unit(benchmark::kMillisecond);
BENCHMARK(multigrid_setup)->Arg(16)->Arg(24)->Unit(benchmark::kMillisecond);
BENCHMARK(multigrid_refresh)->Arg(16)->Arg(24)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(element_tangent, fem::CellType::hex8)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(element_tangent, fem::CellType::hex20)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(element_tangent, fem::CellType::tet10)->Unit(benchmark::kMillisecond);
BENCHMARK(closest_points)->Arg(317)->Unit(benchmark::kMillisecond);
BENCHMARK(line_hits)->Arg(317)->Unit(benchmark::kMillisecond);

} // namespace
