// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/solid/solid_contribution.hpp"
#include "abut_test/dense_system.hpp"
#include "formulations.hpp"
#include "small_mesh.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;
using test::all_cells;

namespace {

mesh::Mesh two_elements(CellType type, std::mt19937& engine) {
  const auto one = [&] {
    return test::straight_nodes(type, test::distorted_corners(type, 0.08, engine));
  };
  return test::separate_elements(type, {one(), one()});
}

// The whole path gather, evaluate, scatter gives what the element kernel gives, in the right rows,
// and leaves fields beyond the displacement alone.
TEST(SolidContribution, ScattersElementResults) {
  std::mt19937 engine(3);
  constexpr double rounding = 1e-14; // the loop takes wider vectors
  const NeoHookean law{0.4, 0.7};
  for (const CellType type : all_cells)
    for (const int fields : {3, 4}) {
      const mesh::Mesh mesh = two_elements(type, engine);
      SolidContribution solid(mesh, 0, law, ElementFormulation::displacement);
      EXPECT_EQ(solid.role(), Role::internal);
      EXPECT_TRUE(solid.symmetric());
      abut_test::DenseSystem system(mesh.num_local(), fields);
      system.u = test::random_vector(system.u.size(), 0.05, engine);
      system.evaluate(solid, true);
      const int size = mesh.num_local() * fields;
      fem::dispatch_cell(type, [&](auto shape) {
        constexpr CellType C = decltype(shape)::type;
        constexpr int n = ReferenceCell<C>::nodes;
        for (int e = 0; e < 2; ++e) {
          double x[3][n], u[3][n], r[3][n];
          for (int a = 0; a < n; ++a)
            for (int i = 0; i < 3; ++i) {
              x[i][a] = mesh.x[3 * (e * n + a) + i];
              u[i][a] = system.u[fields * (e * n + a) + i];
            }
          std::vector<double> k(9 * n * n);
          element_residual<C>(reference_cell<C>(), law, x, u, r);
          element_tangent<C>(reference_cell<C>(), law, x, u, k.data());
          for (int a = 0; a < n; ++a)
            for (int i = 0; i < fields; ++i) {
              const int row = (e * n + a) * fields + i;
              EXPECT_NEAR(system.residual[row], i < 3 ? r[i][a] : 0.0, rounding);
              for (int column = 0; column < size; ++column) {
                const int b = column / fields - e * n, j = column % fields;
                const bool own = b >= 0 && b < n && i < 3 && j < 3;
                EXPECT_NEAR(system.tangent[std::size_t(row) * size + column],
                            own ? k[(3 * a + i) * 3 * n + 3 * b + j] : 0.0, rounding);
              }
            }
        }
      });
    }
}

TEST(SolidContribution, TakesTheFormulation) {
  std::mt19937 engine(3);
  const mesh::Mesh mesh = two_elements(CellType::hex8, engine);
  const MooneyRivlin law(1e3, 0.3, 0.2);
  abut_test::DenseSystem system(mesh.num_local(), 3);
  system.u = test::random_vector(system.u.size(), 0.05, engine);
  const auto residual = [&](ElementFormulation formulation) {
    SolidContribution solid(mesh, 0, law, formulation);
    system.evaluate(solid, false);
    return system.residual;
  };
  const auto expected = [&](auto formulation) {
    std::vector<double> result;
    for (int e = 0; e < 2; ++e) {
      double x[3][8], u[3][8], r[3][8];
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i) {
          x[i][a] = mesh.x[3 * (8 * e + a) + i];
          u[i][a] = system.u[3 * (8 * e + a) + i];
        }
      formulation.template residual<CellType::hex8>(law, x, u, r);
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
          result.push_back(r[i][a]);
    }
    return result;
  };
  const std::vector<double> all[] = {expected(Displacement()), expected(MeanDilatation()),
                                     expected(Enhanced())};
  const ElementFormulation formulations[] = {ElementFormulation::displacement,
                                             ElementFormulation::mean_dilatation,
                                             ElementFormulation::enhanced};
  for (int f = 0; f < 3; ++f) {
    const std::vector<double> found = residual(formulations[f]);
    double other = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], all[f][i], 1e-12);
      other = std::max(other, std::abs(found[i] - all[(f + 1) % 3][i]));
    }
    EXPECT_GT(other, 1e-3);
  }
}

TEST(SolidContribution, AutomaticFormulations) {
  const NeoHookean compressible{0.4, 0.7}, stiff_volume{0.7, 100.0};
  const MooneyRivlin uncoupled(1e3, 0.3, 0.2);
  const auto automatic = [](CellType cell, const Material& material) {
    return element_formulation(ElementFormulation::automatic, cell, material);
  };
  EXPECT_EQ(automatic(CellType::hex8, compressible), ElementFormulation::displacement);
  EXPECT_EQ(automatic(CellType::hex8, stiff_volume), ElementFormulation::enhanced);
  for (const CellType cell : {CellType::hex8, CellType::wedge6})
    EXPECT_EQ(automatic(cell, uncoupled), ElementFormulation::mean_dilatation);
  EXPECT_EQ(automatic(CellType::wedge6, stiff_volume), ElementFormulation::displacement);
  for (const CellType cell : {CellType::hex20, CellType::hex27, CellType::tet4, CellType::tet10})
    EXPECT_EQ(automatic(cell, uncoupled), ElementFormulation::displacement);
}

TEST(SolidContribution, FormulationsThatAreNotThere) {
  std::mt19937 engine(3);
  const mesh::Mesh hex8 = two_elements(CellType::hex8, engine);
  const mesh::Mesh tet4 = two_elements(CellType::tet4, engine);
  const NeoHookean compressible{0.4, 0.7};
  const MooneyRivlin uncoupled(1e3, 0.3, 0.2);
  EXPECT_THROW(SolidContribution(tet4, 0, compressible, ElementFormulation::enhanced), InputError);
  EXPECT_THROW(SolidContribution(tet4, 0, uncoupled, ElementFormulation::mean_dilatation),
               InputError);
  EXPECT_THROW(SolidContribution(hex8, 0, compressible, ElementFormulation::mean_dilatation),
               InputError);
  EXPECT_NO_THROW(SolidContribution(hex8, 0, uncoupled, ElementFormulation::mean_dilatation));
}

TEST(SolidContribution, InvertedElementIsASolveErrorThatNamesIt) {
  std::mt19937 engine(3);
  const mesh::Mesh mesh = two_elements(CellType::hex8, engine);
  SolidContribution solid(mesh, 0, NeoHookean{0.4, 0.7});
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (int a = 8; a < 16; ++a)
    system.u[3 * a + 2] = -2.0 * mesh.x[3 * a + 2]; // second: mirrored
  for (const bool with_tangent : {false, true}) {
    try {
      system.evaluate(solid, with_tangent);
      FAIL() << "no error";
    } catch (const SolveError& error) {
      EXPECT_NE(std::string(error.what()).find("element 102 of block 'body'"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("det F = -1"), std::string::npos) << error.what();
    }
  }
  system.u.assign(system.u.size(), 0.0);
  system.u[3] = std::nan("");
  EXPECT_THROW(system.evaluate(solid, false), SolveError);
  system.u[3] = 0.0;
  EXPECT_NO_THROW(system.evaluate(solid, true));
}

TEST(SolidContribution, LinearElasticityIgnoresInversion) {
  std::mt19937 engine(3);
  const mesh::Mesh mesh = two_elements(CellType::tet4, engine);
  SolidContribution solid(mesh, 0, LinearElastic{0.4, 0.7});
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (std::size_t i = 2; i < system.u.size(); i += 3)
    system.u[i] = -2.0 * mesh.x[i];
  EXPECT_NO_THROW(system.evaluate(solid, true));
}

// Free column under axial stretch 0.5 (E = 1, nu = 0.3): Cauchy stress N/y, nothing else.
TEST(ElementFields, FreeColumn) {
  const CellType type = CellType::hex8;
  std::mt19937 engine(5);
  const mesh::Mesh mesh = two_elements(type, engine);
  MaterialOptions options;
  options.young = 1.0;
  options.poisson = 0.3;
  const double y = 1.465957674, axial = 0.5, nominal = -0.93535206;
  std::vector<double> u(mesh.x.size());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = mesh.x[i] * ((i % 3 == 2 ? axial : std::sqrt(y)) - 1.0);
  const SolidContribution solid(mesh, 0, make_material(options));
  const ElementFields out = solid.element_fields({u.data(), 3, 1.0});
  ASSERT_EQ(out.von_mises.size(), 2u);
  const double expected[] = {0, 0, nominal / y, 0, 0, 0};
  double volume = 0.0;
  for (int e = 0; e < 2; ++e) {
    for (int v = 0; v < 6; ++v)
      EXPECT_NEAR(out.stress[6 * e + v], expected[v], 1e-8);
    EXPECT_NEAR(out.von_mises[e], -nominal / y, 1e-8);
  }
  const ReferenceCell<type>& cell = reference_cell<type>();
  for (int e = 0; e < 2; ++e) {
    double x[3][8];
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        x[i][a] = mesh.x[3 * (8 * e + a) + i];
    for (int p = 0; p < 8; ++p)
      volume += cell.weight[p] * det(nodal_gradient(x, cell.dN[p]));
  }
  const double shear = 0.5 / 1.3, lambda = 0.3 / (1.3 * 0.4), log_j = std::log(axial * y);
  const double density =
      0.5 * shear * (2 * y + axial * axial - 3.0) - shear * log_j + 0.5 * lambda * log_j * log_j;
  EXPECT_NEAR(out.total_energy(), density * volume, 1e-13 * volume);
  EXPECT_GT(density, 0.1);
}

TEST(ElementFields, VonMises) {
  const double shear[6] = {5, 5, 5, 2, 0, 0};
  EXPECT_NEAR(von_mises(shear), 2.0 * std::sqrt(3.0), 1e-15);
}

} // namespace
