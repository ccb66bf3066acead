// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/element_fields.hpp"
#include "abut/solid/element_kernel.hpp"
#include "abut/solid/linear_fit.hpp"
#include "small_mesh.hpp"
#include "some_laws.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;
using test::all_cells;

namespace {

/// A distorted element with straight edges, moved at random.
template <CellType C> struct Moved {
  static constexpr int n = ReferenceCell<C>::nodes, P = ReferenceCell<C>::points;
  double x[3][n], u[3][n];
  Vec3 at[P];

  explicit Moved(std::mt19937& engine) {
    const auto nodes = test::straight_nodes(C, test::distorted_corners(C, 0.08, engine));
    const auto random = test::random_vector(3 * n, 0.05, engine);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        x[i][a] = nodes[a][i];
        u[i][a] = random[3 * a + i];
      }
    for (int p = 0; p < P; ++p)
      for (int i = 0; i < 3; ++i)
        at[p][i] = nodal_sum(x[i], reference_cell<C>().N[p]);
  }
};

/// Averages over the current volume are those of the element.
template <CellType C, class M> void expect_averages(const Moved<C>& e, const M& law) {
  PointValues<Moved<C>::P> values{};
  element_points<C>(reference_cell<C>(), law, e.x, e.u, values);
  double average[6], energy, sum[6] = {}, volume = 0.0;
  element_averages<C>(reference_cell<C>(), law, e.x, e.u, average, energy);
  for (int p = 0; p < Moved<C>::P; ++p) {
    // Green-Lagrange: det(2 E + I) = J^2; the small strain leaves volumes as they are.
    Mat3 c = Mat3::identity();
    for (int v = 0; v < voigt_size; ++v) {
      c[voigt_row[v]][voigt_column[v]] += 2.0 * values.strain[p][v];
      if (voigt_row[v] != voigt_column[v])
        c[voigt_column[v]][voigt_row[v]] += 2.0 * values.strain[p][v];
    }
    const double J = M::finite_strain ? std::sqrt(det(c)) : 1.0;
    volume += values.volume[p] * J;
    for (int v = 0; v < voigt_size; ++v)
      sum[v] += values.volume[p] * J * values.stress[p][v];
  }
  for (int v = 0; v < voigt_size; ++v) {
    EXPECT_GT(std::fabs(average[v]), 1e-5);
    EXPECT_NEAR(sum[v] / volume, average[v], 1e-13);
  }
}

TEST(PointValues, AverageToThoseOfTheElement) {
  std::mt19937 engine(11);
  for (const CellType type : all_cells)
    fem::dispatch_cell(type, [&](auto shape) {
      const Moved<decltype(shape)::type> e(engine);
      expect_averages(e, NeoHookean{0.4, 0.7});
      expect_averages(e, LinearElastic{0.4, 0.7});
    });
}

// Distorted elements too, whose reference coordinates are no linear functions of the position.
TEST(LinearFit, KeepsLinearFieldsAndMeans) {
  std::mt19937 engine(12);
  const Vec3 slope{{0.3, -0.7, 1.1}};
  for (const CellType type : all_cells)
    fem::dispatch_cell(type, [&](auto shape) {
      constexpr CellType C = decltype(shape)::type;
      using E = Moved<C>;
      const E e(engine);
      PointValues<E::P> values{};
      element_points<C>(reference_cell<C>(), LinearElastic{0.4, 0.7}, e.x, e.u, values);
      double field[E::P][6] = {}, mean = 0.0, volume = 0.0, out[6 * E::n];
      for (int p = 0; p < E::P; ++p) {
        field[p][0] = 2.0 + dot(slope, e.at[p]);
        field[p][4] = e.at[p][0] * e.at[p][1];
        mean += values.volume[p] * field[p][0];
        volume += values.volume[p];
      }
      const LinearFit fit(values, e.at);
      EXPECT_NEAR(fit.volume(), volume, 1e-13 * volume);
      fit.at_nodes(values, e.at, field, e.x, out);
      for (int a = 0; a < E::n; ++a) {
        const Vec3 x{{e.x[0][a], e.x[1][a], e.x[2][a]}};
        EXPECT_NEAR(out[6 * a], E::P > 1 ? 2.0 + dot(slope, x) : mean / volume, 1e-12);
        EXPECT_EQ(out[6 * a + 1], 0.0);
      }
    });
}

TEST(LinearFit, LeavesTurnedOverPointsOut) {
  std::mt19937 engine(13);
  const Moved<CellType::hex8> e(engine);
  PointValues<8> values{};
  element_points<CellType::hex8>(reference_cell<CellType::hex8>(), NeoHookean{0.4, 0.7}, e.x, e.u,
                                 values);
  double field[8][6] = {}, out[48];
  for (int p = 0; p < 8; ++p)
    field[p][2] = 1.0 + e.at[p][0];
  values.volume[3] = 0.0;
  field[3][2] = std::nan("");
  LinearFit(values, e.at).at_nodes(values, e.at, field, e.x, out);
  EXPECT_NEAR(out[6 * 5 + 2], 1.0 + e.x[0][5], 1e-12);
  for (double& v : values.volume)
    v = 0.0;
  LinearFit(values, e.at).at_nodes(values, e.at, field, e.x, out);
  EXPECT_EQ(out[6 * 5 + 2], 0.0);
}

TEST(PrincipalValues, AreRootsOfTheCharacteristicPolynomialInOrder) {
  const double s[6] = {0.4, -1.3, 2.1, 0.7, -0.2, 1.9};
  const auto root = principal_values(s);
  EXPECT_GT(root[0], root[1]);
  EXPECT_GT(root[1], root[2]);
  for (const double r : root) {
    Mat3 a;
    for (int v = 0; v < voigt_size; ++v)
      a[voigt_row[v]][voigt_column[v]] = a[voigt_column[v]][voigt_row[v]] = s[v];
    for (int i = 0; i < 3; ++i)
      a[i][i] -= r;
    EXPECT_NEAR(det(a), 0.0, 1e-13);
  }
  EXPECT_NEAR(root[0] + root[1] + root[2], s[0] + s[1] + s[2], 1e-14);
  const double none[6] = {};
  EXPECT_EQ(principal_values(none)[0], 0.0);
}

} // namespace
