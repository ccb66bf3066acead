// SPDX-License-Identifier: BSD-3-Clause
#include "automatic.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/material.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;

namespace {

using Ad = Sacado::Fad::SFad<double, 9>;

MaterialOptions options(MaterialModel model, double young, double poisson) {
  MaterialOptions o;
  o.name = "m";
  o.model = model;
  o.young = young;
  o.poisson = poisson;
  return o;
}

Mat3 stretch(double axial, double lateral) {
  Mat3 h = Mat3::zero();
  h[0][0] = h[1][1] = lateral - 1.0;
  h[2][2] = axial - 1.0;
  return h;
}

const Mat3 some_gradient = {{{0.21, -0.13, 0.07}, {0.05, -0.17, 0.11}, {-0.09, 0.14, 0.23}}};

// Exact columns of a neo-Hookean body, E = 1: axial stretch, lateral stretch squared and nominal
// stress when free (nu = 0.3), nominal stress when confined (nu = 0.3), nominal stress (nu = 0).
TEST(NeoHookean, ColumnsMatchExactSolution) {
  const double table[][5] = {{0.9, 1.0644099132, -0.10872219, -0.14873537, -0.10555556},
                             {0.8, 1.1392111945, -0.24000538, -0.33399775, -0.225},
                             {0.7, 1.2275193723, -0.40523042, -0.57418265, -0.36428571},
                             {0.6, 1.3339837672, -0.62434857, -0.90143489, -0.53333333},
                             {0.5, 1.465957674, -0.93535206, -1.37670829, -0.75}};
  const auto m = std::get<NeoHookean>(make_material(options(MaterialModel::neo_hookean, 1, 0.3)));
  const auto m0 = std::get<NeoHookean>(make_material(options(MaterialModel::neo_hookean, 1, 0.0)));
  for (const auto& row : table) {
    const double axial = row[0];
    // N = tau_zz / axial stretch, whatever the lateral one.
    const Mat3 free = m.stress(Deformation<double>(stretch(axial, std::sqrt(row[1]))));
    EXPECT_NEAR(free[0][0], 0.0, 2e-10); // ten digits of the lateral stretch are given
    EXPECT_NEAR(free[2][2] / axial, row[2], 1e-8);
    const Mat3 confined = m.stress(Deformation<double>(stretch(axial, 1.0)));
    EXPECT_NEAR(confined[2][2] / axial, row[3], 5.1e-9);
    const Mat3 straight = m0.stress(Deformation<double>(stretch(axial, 1.0)));
    EXPECT_NEAR(straight[2][2] / axial, row[4], 5.1e-9);
    EXPECT_NEAR(straight[0][0], 0.0, 1e-16);
  }
}

template <class M> void stress_is_derivative_of_energy(const M& material) {
  Mat<Ad, 3> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      h[i][j] = Ad(9, 3 * i + j, some_gradient[i][j]);
  const Ad w = material.energy(Deformation<Ad>(h));
  EXPECT_GT(w.val(), 0.0);
  const Mat3 s = material.stress(Deformation<double>(some_gradient));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double expected = w.dx(3 * i + j); // first Piola-Kirchhoff stress
      if (M::finite_strain) {
        expected = 0.0;
        for (int k = 0; k < 3; ++k)
          expected += w.dx(3 * i + k) * (some_gradient[j][k] + (j == k ? 1.0 : 0.0));
      }
      EXPECT_NEAR(s[i][j], expected, 1e-15) << i << j;
    }
}

TEST(NeoHookean, StressIsDerivativeOfEnergy) {
  stress_is_derivative_of_energy(NeoHookean{0.4, 0.7});
}
TEST(LinearElastic, StressIsDerivativeOfEnergy) {
  stress_is_derivative_of_energy(LinearElastic{0.4, 0.7});
}

// Lie derivative: d(tau)(H) along dF = l F is l tau + tau l^T + c : sym l.
TEST(NeoHookean, TangentIsLieDerivativeOfStress) {
  const NeoHookean m{0.4, 0.7};
  const Mat3 l = {{{0.3, 0.1, -0.4}, {0.6, -0.2, 0.5}, {0.2, -0.7, 0.8}}};
  Mat3 F = some_gradient;
  for (int i = 0; i < 3; ++i)
    F[i][i] += 1.0;
  const Mat3 rate = l * F;
  Mat<Ad, 3> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      h[i][j] = Ad(some_gradient[i][j]);
      h[i][j].fastAccessDx(0) = rate[i][j];
    }
  const Mat<Ad, 3> s = m.stress(Deformation<Ad>(h));
  Mat3 stress;
  double c[6][6];
  m.tangent(Deformation<double>(some_gradient), stress, c);
  const Mat3 left = l * stress, right = stress * transpose(l);
  for (int v = 0; v < voigt_size; ++v) {
    const int i = voigt_row[v], j = voigt_column[v];
    double expected = left[i][j] + right[i][j];
    for (int w = 0; w < voigt_size; ++w) {
      const int p = voigt_row[w], q = voigt_column[w];
      expected += c[v][w] * (p == q ? l[p][p] : l[p][q] + l[q][p]);
    }
    EXPECT_NEAR(s[i][j].dx(0), expected, 1e-15);
    EXPECT_NEAR(s[i][j].val(), stress[i][j], 1e-16);
  }
}

// A strain of 1e-12 keeps its digits: F - I is the argument, not F.
TEST(NeoHookean, NoCancellationAtSmallStrain) {
  const NeoHookean m{1.0, 2.0};
  const double e = 1.2345678901234567e-12;
  const Mat3 s = m.stress(Deformation<double>(stretch(1.0 + 0.0, 1.0)));
  EXPECT_EQ(s[2][2], 0.0);
  Mat3 h = Mat3::zero();
  h[2][2] = e;
  EXPECT_NEAR(m.stress(Deformation<double>(h))[2][2] / e, 4.0, 1e-11);
  EXPECT_NEAR(m.stress(Deformation<double>(h))[0][0] / e, 2.0, 1e-11);
}

TEST(Material, ModulusAlongAnyDirectionIsYoungs) {
  for (const MaterialModel model : {MaterialModel::neo_hookean, MaterialModel::linear_elastic}) {
    const Material m = make_material(options(model, 210.0, 0.3));
    Vec3 n{{0.3, -0.5, 0.8}};
    n *= 1.0 / norm(n);
    EXPECT_NEAR(modulus_along(m, n), 210.0, 1e-12 * 210.0);
    EXPECT_NEAR(modulus_along(m, Vec3{{0, 0, 1}}), 210.0, 1e-12 * 210.0);
  }
}

TEST(Material, InvalidConstantsAreADefect) {
  EXPECT_THROW(make_material(options(MaterialModel::neo_hookean, 1, 0.5)), Defect);
  EXPECT_THROW(make_material(options(MaterialModel::neo_hookean, 0, 0.3)), Defect);
}

} // namespace
