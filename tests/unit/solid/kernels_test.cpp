// SPDX-License-Identifier: BSD-3-Clause
// Launches of the kernels over cells that share nodes against plain loops over dense arrays.
#include "formulations.hpp"
#include "kernels/elements.hpp"
#include "kernels/inertia.hpp"
#include "kernels/loads.hpp"
#include "kernels/mass.hpp"
#include "small_mesh.hpp"
#include "some_laws.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;
using fem::FaceType;

namespace {

constexpr int nodes = 40, fields = 5, size = nodes * fields;
constexpr double others = 7.0; ///< what stands in the arrays before

/// Cells of random nodes, each with a geometry of its own.
struct Cells {
  std::mt19937 engine{5};
  std::vector<Local> first{0}, node;
  std::vector<Vec3> x;
  std::vector<double> u; ///< (nodes, fields)

  Cells() : u(test::random_vector(size, 0.02, engine)) {}

  void add(const std::vector<Vec3>& at) {
    std::vector<Local> all(nodes);
    for (Local i = 0; i < nodes; ++i)
      all[std::size_t(i)] = i;
    std::shuffle(all.begin(), all.end(), engine);
    node.insert(node.end(), all.begin(), all.begin() + std::ptrdiff_t(at.size()));
    x.insert(x.end(), at.begin(), at.end());
    first.push_back(static_cast<Local>(node.size()));
  }
  void add(CellType type) {
    add(test::straight_nodes(type, test::distorted_corners(type, 0.08, engine)));
  }
  Local count() const { return static_cast<Local>(first.size()) - 1; }
  Local nodes_of(Local c) const { return first[std::size_t(c) + 1] - first[std::size_t(c)]; }
  CellArrays arrays() const {
    return {make_view("first", first), make_view("node", node), make_view("x", x)};
  }
  NodalFields values() const { return {u.data(), fields, 1.0}; }
  Vec3 displacement(Local entry) const {
    const double* of = &u[std::size_t(node[std::size_t(entry)] * fields)];
    return {{of[0], of[1], of[2]}};
  }
  /// Reference positions and displacements of a cell, by component first.
  template <int n> void gather(Local c, double (&at)[3][n], double (&by)[3][n]) const {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        const Local entry = first[std::size_t(c)] + a;
        at[i][a] = x[std::size_t(entry)][i];
        by[i][a] = displacement(entry)[i];
      }
  }
};

/// Dense residual and tangent over all nodes, and scatters to them.
struct Sums {
  const Cells& cells;
  std::vector<double> r = std::vector<double>(size, others);
  std::vector<double> k = std::vector<double>(std::size_t(size) * size, others);
  std::vector<std::int64_t> offset{0}, position;
  std::vector<Local> length = std::vector<Local>(nodes, size);

  explicit Sums(const Cells& of) : cells(of) {
    for (Local c = 0; c < of.count(); ++c) {
      for (Local a = of.first[std::size_t(c)]; a < of.first[std::size_t(c) + 1]; ++a)
        for (Local b = of.first[std::size_t(c)]; b < of.first[std::size_t(c) + 1]; ++b)
          position.push_back(std::int64_t(of.node[std::size_t(a)]) * fields * size +
                             of.node[std::size_t(b)] * fields);
      offset.push_back(static_cast<std::int64_t>(position.size()));
    }
  }
  ResidualScatter residual() { return {fields, cells.first.data(), cells.node.data(), r.data()}; }
  TangentScatter tangent() {
    return {fields,          cells.first.data(), cells.node.data(), offset.data(),
            position.data(), length.data(),      k.data()};
  }

  // The plain way. value(a, i) and value(a, i, b, j) of a cell's nodes and directions.
  template <class Value> void add_residual(Local c, const Value& value) {
    for (Local a = 0; a < cells.nodes_of(c); ++a)
      for (int i = 0; i < 3; ++i)
        r[row(c, a, i)] += value(a, i);
  }
  template <class Value> void add_tangent(Local c, const Value& value) {
    for (Local a = 0; a < cells.nodes_of(c); ++a)
      for (Local b = 0; b < cells.nodes_of(c); ++b)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            k[row(c, a, i) * size + row(c, b, j)] += value(a, i, b, j);
  }

private:
  std::size_t row(Local c, Local a, int i) const {
    return std::size_t(cells.node[std::size_t(cells.first[std::size_t(c)] + a)] * fields + i);
  }
};

/// Sums of the same few numbers in any order.
void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0, difference = 0.0, change = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::fabs(b[i]));
    change = std::max(change, std::fabs(b[i] - others));
    difference = std::max(difference, std::fabs(a[i] - b[i]));
  }
  EXPECT_GT(change, 1e-3);
  EXPECT_LE(difference, 1e-13 * largest);
}

template <class Elements, class Formulation> struct Kind {};

template <CellType C, class M>
DisplacementElements<C, M> make_elements(const Cells& cells,
                                         Kind<DisplacementElements<C, M>, Displacement>) {
  return {cells.arrays(), make_view("table", 1, reference_cell<C>()), some_law<M>()};
}
template <CellType C, class M>
DilatedElements<C, M> make_elements(const Cells& cells,
                                    Kind<DilatedElements<C, M>, MeanDilatation>) {
  return {cells.arrays(), make_view("table", 1, reference_cell<C>()), some_law<M>()};
}
template <class M>
EnhancedElements<M> make_elements(const Cells& cells, Kind<EnhancedElements<M>, Enhanced>) {
  const View<EnhancedReference> reference("reference", std::size_t(cells.count()));
  Kokkos::parallel_for("abut::test", Range(0, cells.count()),
                       EnhancedReferences{cells.arrays(),
                                          make_view("table", 1, reference_cell<CellType::hex8>()),
                                          at_rest(some_law<M>()), reference});
  return {cells.arrays(), reference, some_law<M>()};
}

template <class Functor> SmallestDet::value_type launch(const Cells& cells, const Functor& f) {
  SmallestDet::value_type least;
  Kokkos::parallel_reduce("abut::test", Range(0, cells.count()), f, SmallestDet(least));
  return least;
}

template <CellType C, class E, class F> void check_elements(Kind<E, F> kind) {
  constexpr int n = ReferenceCell<C>::nodes;
  Cells cells;
  for (int c = 0; c < 30; ++c)
    cells.add(C);
  const E elements = make_elements(cells, kind);
  Sums found(cells), expected(cells);
  double least = 1.0;
  for (Local c = 0; c < cells.count(); ++c) {
    double x[3][n], u[3][n], r[3][n];
    std::vector<double> k(9 * n * n);
    cells.gather(c, x, u);
    least = std::min(least, F::template residual<C>(elements.material, x, u, r));
    F::template tangent<C>(elements.material, x, u, k.data());
    expected.add_residual(c, [&](Local a, int i) { return r[i][a]; });
    expected.add_tangent(c, [&](Local a, int i, Local b, int j) {
      return k[std::size_t((3 * a + i) * 3 * n + 3 * b + j)];
    });
  }
  using Residual = ElementResidual<E>;
  using Tangent = ElementTangent<E>;
  EXPECT_EQ(launch(cells, Residual{elements, cells.values(), found.residual()}).val, least);
  EXPECT_EQ(launch(cells, Tangent{elements, cells.values(), found.tangent()}).val, least);
  EXPECT_LT(least, 1.0);
  expect_same(found.r, expected.r);
  expect_same(found.k, expected.k);
}

template <CellType C, class M> using Plain = Kind<DisplacementElements<C, M>, Displacement>;
template <CellType C, class M> using Dilated = Kind<DilatedElements<C, M>, MeanDilatation>;
template <class M> using EnhancedHex = Kind<EnhancedElements<M>, Enhanced>;

TEST(SolidKernels, Elements) {
  check_elements<CellType::hex8>(Plain<CellType::hex8, NeoHookean>());
  check_elements<CellType::hex20>(Plain<CellType::hex20, SaintVenantKirchhoff>());
  check_elements<CellType::hex27>(Plain<CellType::hex27, HolmesMow>());
  check_elements<CellType::tet4>(Plain<CellType::tet4, NeoHookean>());
  check_elements<CellType::tet10>(Plain<CellType::tet10, Ogden>());
  check_elements<CellType::wedge6>(Plain<CellType::wedge6, OgdenUnconstrained>());
  check_elements<CellType::hex8>(Dilated<CellType::hex8, MooneyRivlin>());
  check_elements<CellType::hex8>(EnhancedHex<NeoHookean>());
}

template <CellType C, class E, class F> void check_averages(Kind<E, F> kind) {
  constexpr int n = ReferenceCell<C>::nodes;
  Cells cells;
  for (int c = 0; c < 30; ++c)
    cells.add(C);
  const E elements = make_elements(cells, kind);
  const View<double> stress("stress", 180), energy("energy", 30);
  Kokkos::parallel_for("abut::test", Range(0, 30),
                       ElementAverages<E>{elements, cells.values(), stress, energy});
  for (Local c = 0; c < 30; ++c) {
    double x[3][n], u[3][n], s[6], w;
    cells.gather(c, x, u);
    F::template averages<C>(elements.material, x, u, s, w);
    EXPECT_EQ(energy(c), w);
    EXPECT_GT(w, 0.0);
    for (int v = 0; v < 6; ++v)
      EXPECT_EQ(stress(6 * c + v), s[v]);
  }
}

TEST(SolidKernels, Averages) {
  check_averages<CellType::tet10>(Plain<CellType::tet10, NeoHookean>());
  check_averages<CellType::hex8>(Dilated<CellType::hex8, Ogden>());
  check_averages<CellType::hex8>(EnhancedHex<NeoHookean>());
}

template <class Hex, class F> void check_turned_element(Kind<Hex, F> kind) {
  constexpr CellType C = CellType::hex8;
  Cells cells;
  cells.u.assign(cells.u.size(), 0.0);
  for (int c = 0; c < 4; ++c)
    cells.add(C);
  for (int a = 0; a < 8; ++a) { // the only one with displacements, and with nodes of its own
    cells.node[std::size_t(16 + a)] = 32 + a;
    cells.u[std::size_t((32 + a) * fields + 2)] = -2.0 * cells.x[std::size_t(16 + a)][2];
  }
  for (std::size_t k = 0; k < cells.node.size(); ++k)
    if (k / 8 != 2)
      cells.node[k] %= 32;
  Sums found(cells);
  const Hex elements = make_elements(cells, kind);
  const auto least = launch(cells, ElementTangent<Hex>{elements, cells.values(), found.tangent()});
  EXPECT_EQ(least.loc, 2);
  EXPECT_LT(least.val, 0.0);
  for (std::size_t row = 32 * fields; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      ASSERT_EQ(found.k[row * size + column], others);
  EXPECT_NE(found.k[std::size_t(cells.node[0] * fields * (size + 1))], others);
}

// One element is turned over: the loop names it, and its tangent is left out.
TEST(SolidKernels, TurnedElement) {
  check_turned_element(Plain<CellType::hex8, NeoHookean>());
  check_turned_element(EnhancedHex<NeoHookean>());
}

constexpr FaceType all_faces[] = {FaceType::quad4, FaceType::quad8, FaceType::quad9, FaceType::tri3,
                                  FaceType::tri6};

/// Faces of all types, a little out of their plane.
std::vector<FaceType> add_faces(Cells& cells) {
  std::vector<FaceType> types;
  for (int c = 0; c < 30; ++c) {
    types.push_back(all_faces[c % 5]);
    std::vector<Vec3> x(std::size_t(fem::face_nodes(types.back())));
    fem::dispatch_face(types.back(), [&](auto shape) {
      for (int a = 0; a < decltype(shape)::nodes; ++a) {
        double xi[2];
        decltype(shape)::node(a, xi);
        x[std::size_t(a)] = {{xi[0], xi[1], 0.1 * xi[0] * xi[1]}};
      }
    });
    cells.add(x);
  }
  return types;
}

/// residual(face, values at points, x, r) and tangent(face, values at points, x, k).
template <class Load, class Residual, class Tangent>
void check_faces(const std::vector<Load>& load, const Residual& residual, const Tangent& tangent) {
  Cells cells;
  const std::vector<FaceType> types = add_faces(cells);
  Sums found(cells), expected(cells);
  const LoadedFaces<Load> faces{cells.arrays(), make_view("type", types),
                                make_view<ReferenceFaces>("faces", 1), make_view("load", load)};
  Kokkos::parallel_for("abut::test", Range(0, cells.count()),
                       FaceResidual<Load>{faces, cells.values(), found.residual()});
  Kokkos::parallel_for("abut::test", Range(0, cells.count()),
                       FaceTangent<Load>{faces, cells.values(), found.tangent()});
  for (Local c = 0; c < cells.count(); ++c)
    fem::dispatch_face(types[std::size_t(c)], [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      const auto& face = reference_face<decltype(shape)::type>();
      const Load* at = &load[std::size_t(c * max_face_points)];
      Vec3 x[n], r[n];
      double k[9 * n * n];
      for (Local a = 0; a < n; ++a) {
        const Local entry = cells.first[std::size_t(c)] + a;
        x[a] = cells.x[std::size_t(entry)] + cells.displacement(entry);
      }
      residual(face, at, x, r);
      tangent(face, at, x, k);
      expected.add_residual(c, [&](Local a, int i) { return r[a][i]; });
      expected.add_tangent(
          c, [&](Local a, int i, Local b, int j) { return k[(3 * a + i) * 3 * n + 3 * b + j]; });
    });
  expect_same(found.r, expected.r);
  expect_same(found.k, expected.k);
}

TEST(SolidKernels, Pressure) {
  std::vector<double> pressure(30 * max_face_points);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    pressure[i] = 1.0 + 0.01 * double(i);
  check_faces(
      pressure,
      [](const auto& face, const double* p, const Vec3* x, Vec3* r) {
        pressure_residual(face, p, x, r);
      },
      [](const auto& face, const double* p, const Vec3* x, double* k) {
        pressure_tangent(face, p, x, k);
      });
}

TEST(SolidKernels, Traction) {
  std::vector<Vec3> traction(30 * max_face_points);
  for (std::size_t i = 0; i < traction.size(); ++i)
    traction[i] = {{1.0 + 0.01 * double(i), -0.5, 0.3}};
  check_faces(
      traction,
      [](const auto& face, const Vec3* t, const Vec3* x, Vec3* r) {
        traction_residual(face, t, x, r);
      },
      [](const auto& face, const Vec3* t, const Vec3* x, double* k) {
        traction_tangent(face, t, x, k);
      });
}

TEST(SolidKernels, DeadForce) {
  Cells cells;
  add_faces(cells);
  Sums found(cells), expected(cells);
  std::vector<Vec3> force(cells.node.size());
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = {{0.1 * double(i), -0.5, 0.3}};
  Kokkos::parallel_for("abut::test", Range(0, cells.count()),
                       DeadForce{cells.arrays(), make_view("force", force), found.residual()});
  for (Local c = 0; c < cells.count(); ++c)
    expected.add_residual(
        c, [&](Local a, int i) { return -force[std::size_t(cells.first[std::size_t(c)] + a)][i]; });
  expect_same(found.r, expected.r);
}

/// Cells of all types and their mass matrices.
struct Masses {
  Cells cells;
  std::vector<CellType> type;
  std::vector<std::int64_t> first{0};
  View<double> packed;

  Masses() {
    constexpr CellType all[] = {CellType::hex8, CellType::hex20, CellType::hex27,
                                CellType::tet4, CellType::tet10, CellType::wedge6};
    for (int c = 0; c < 30; ++c) {
      type.push_back(all[c % 6]);
      cells.add(type.back());
      first.push_back(first.back() + mass_size(fem::info(type.back()).nodes));
    }
    packed = View<double>("packed", std::size_t(first.back()));
    Kokkos::parallel_for(
        "abut::test", Range(0, 30),
        CellMass{massive(), make_view("density", 30, 1.5), make_view("first_mass", first), packed});
  }
  MassiveCells massive() const {
    return {cells.arrays(), make_view("type", type), make_view<MassCells>("table", 1)};
  }
  MassArrays arrays() const { return {cells.arrays(), make_view("first_mass", first), packed}; }
  double entry(Local c, int a, int b) const {
    return packed.data()[first[std::size_t(c)] + mass_index(a, b)];
  }
};

TEST(SolidKernels, Mass) {
  const Masses m;
  for (Local c = 0; c < 30; ++c)
    fem::dispatch_cell(m.type[std::size_t(c)], [&](auto shape) {
      constexpr int n = decltype(shape)::nodes;
      double x[3][n], u[3][n], expected[mass_size(n)];
      m.cells.gather(c, x, u);
      element_mass(MassCell<decltype(shape)::type>(), x, 1.5, expected);
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b)
          EXPECT_EQ(m.entry(c, a, b), expected[mass_index(a, b)]);
    });
}

// Volume, first and second moments from the mass matrices, whose functions sum to 1 and carry x.
TEST(SolidKernels, VolumeMoments) {
  const Masses m;
  const View<double> sums("sums", VolumeMoments::value_count);
  Kokkos::parallel_reduce("abut::test", Range(0, 30), VolumeMoments{m.massive()}, sums);
  double expected[VolumeMoments::value_count] = {};
  for (Local c = 0; c < 30; ++c)
    for (Local a = 0; a < m.cells.nodes_of(c); ++a)
      for (Local b = 0; b < m.cells.nodes_of(c); ++b) {
        const double volume = m.entry(c, a, b) / 1.5;
        const Vec3& x = m.cells.x[std::size_t(m.cells.first[std::size_t(c)] + a)];
        const Vec3& y = m.cells.x[std::size_t(m.cells.first[std::size_t(c)] + b)];
        expected[0] += volume;
        for (int i = 0; i < 3; ++i) {
          expected[1 + i] += volume * x[i];
          expected[4 + i] += volume * x[i] * y[i];
          expected[7 + i] += volume * x[i] * y[(i + 1) % 3];
        }
      }
  EXPECT_GT(expected[0], 10.0);
  for (unsigned k = 0; k < VolumeMoments::value_count; ++k)
    EXPECT_NEAR(sums(k), expected[k], 1e-13 * expected[0]) << k;
}

TEST(SolidKernels, Inertia) {
  Masses m;
  const std::vector<double> a = test::random_vector(3 * nodes, 1.0, m.cells.engine);
  std::vector<Lead> lead(3 * nodes, Lead::free);
  for (std::size_t i = 0; i < lead.size(); i += 4)
    lead[i] = Lead::prescribed;
  const auto slope = [&](std::size_t number) { return number % 4 == 0 ? 3.0 : 2.0; };
  Sums found(m.cells), expected(m.cells);
  Kokkos::parallel_for("abut::test", Range(0, 30),
                       InertiaResidual{m.arrays(), make_view("a", a), found.residual()});
  Kokkos::parallel_for(
      "abut::test", Range(0, 30),
      InertiaTangent{m.arrays(), {make_view("lead", lead), 2.0, 3.0}, found.tangent()});
  for (Local c = 0; c < 30; ++c) {
    const auto number = [&](Local b, int i) {
      return std::size_t(3 * m.cells.node[std::size_t(m.cells.first[std::size_t(c)] + b)] + i);
    };
    expected.add_residual(c, [&](Local r, int i) {
      double sum = 0.0;
      for (Local b = 0; b < m.cells.nodes_of(c); ++b)
        sum += m.entry(c, r, b) * a[number(b, i)];
      return sum;
    });
    expected.add_tangent(c, [&](Local r, int i, Local b, int j) {
      return i == j ? m.entry(c, r, b) * slope(number(b, i)) : 0.0;
    });
  }
  expect_same(found.r, expected.r);
  expect_same(found.k, expected.k);
}

TEST(SolidKernels, Momentum) {
  Masses m;
  const std::vector<double> v = test::random_vector(3 * nodes, 1.0, m.cells.engine);
  const View<double> sums("sums", CellMomentum::value_count);
  Kokkos::parallel_reduce("abut::test", Range(0, 30),
                          CellMomentum{m.arrays(), make_view("v", v), m.cells.values()}, sums);
  double energy = 0.0;
  Vec3 linear = Vec3::zero(), angular = Vec3::zero();
  for (Local c = 0; c < 30; ++c)
    for (Local a = 0; a < m.cells.nodes_of(c); ++a)
      for (Local b = 0; b < m.cells.nodes_of(c); ++b) {
        const Local of_a = m.cells.first[std::size_t(c)] + a;
        const Local of_b = m.cells.first[std::size_t(c)] + b;
        const double* va = &v[std::size_t(3 * m.cells.node[std::size_t(of_a)])];
        const double* vb = &v[std::size_t(3 * m.cells.node[std::size_t(of_b)])];
        const Vec3 p = m.entry(c, a, b) * Vec3{{vb[0], vb[1], vb[2]}};
        linear += p;
        angular += cross(m.cells.x[std::size_t(of_a)] + m.cells.displacement(of_a), p);
        energy += 0.5 * dot(Vec3{{va[0], va[1], va[2]}}, p);
      }
  EXPECT_GT(energy, 1.0);
  EXPECT_NEAR(sums(0), energy, 1e-13 * energy);
  for (unsigned i = 0; i < 3; ++i) {
    EXPECT_NEAR(sums(1 + i), linear[int(i)], 1e-13 * energy);
    EXPECT_NEAR(sums(4 + i), angular[int(i)], 1e-13 * energy);
  }
}

} // namespace
