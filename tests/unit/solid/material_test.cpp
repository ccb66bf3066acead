// SPDX-License-Identifier: BSD-3-Clause
#include "automatic.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/material.hpp"
#include "some_laws.hpp"

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

// Energy and Cauchy stresses at stretches 1.3, 0.9, 0.8, to 17 digits, from derivatives of the
// energies as functions of the stretches in 40-digit arithmetic.
struct Principal {
  double energy, stress[3];
};
template <class M> Principal exact();
template <> Principal exact<NeoHookean>() {
  return {0.055986986718187078, {0.24540826735771207, -0.130660108710664, -0.20330968136023665}};
}
template <> Principal exact<SaintVenantKirchhoff>() {
  return {0.065895, {0.58680555555555556, -0.023365384615384615, -0.064957264957264957}};
}
template <> Principal exact<HolmesMow>() {
  return {0.048738374697712396, {0.2146547834904174, -0.054670370120663352, -0.17648214279425497}};
}
template <> Principal exact<MooneyRivlin>() {
  return {0.1439228939316683, {0.29762032570341438, -0.55478464658667443, -0.80276841156137144}};
}
template <> Principal exact<Ogden>() {
  return {0.068415462982876831, {0.016537468764228541, -0.51818635494793209, -0.55828384626092794}};
}
template <> Principal exact<OgdenUnconstrained>() {
  return {0.052371177519351733, {0.36886277193123904, -0.097140733687385258, -0.13434217992882322}};
}

template <class M> class FiniteStrain : public ::testing::Test {
public:
  const M material = some_law<M>();
};
using FiniteStrainLaws = ::testing::Types<NeoHookean, SaintVenantKirchhoff, HolmesMow, MooneyRivlin,
                                          Ogden, OgdenUnconstrained>;
TYPED_TEST_SUITE(FiniteStrain, FiniteStrainLaws);

// The stretches along turned axes, so that principal directions matter too.
TYPED_TEST(FiniteStrain, StressMatchesStretches) {
  const double stretch[3] = {1.3, 0.9, 0.8}, J = 1.3 * 0.9 * 0.8;
  const double a = 0.7, b = -0.4;
  const Mat3 first = {{{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}};
  const Mat3 second = {{{1, 0, 0}, {0, std::cos(b), -std::sin(b)}, {0, std::sin(b), std::cos(b)}}};
  const Principal expected = exact<TypeParam>();
  for (const Mat3& turn : {Mat3::identity(), first * second}) {
    Mat3 h = Mat3::zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int p = 0; p < 3; ++p)
          h[i][j] += turn[i][p] * (stretch[p] - 1.0) * turn[j][p];
    const Deformation<double> d(h);
    EXPECT_NEAR(this->material.energy(d), expected.energy, 4e-16);
    const Mat3 s = transpose(turn) * this->material.stress(d) * turn;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(s[i][j] / J, i == j ? expected.stress[i] : 0.0, 4e-15) << i << j;
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
      EXPECT_NEAR(s[i][j], expected, 4e-15) << i << j;
    }
}

TYPED_TEST(FiniteStrain, StressIsDerivativeOfEnergy) {
  stress_is_derivative_of_energy(this->material);
}
TEST(LinearElastic, StressIsDerivativeOfEnergy) {
  stress_is_derivative_of_energy(LinearElastic{0.4, 0.7});
}

/// Lie derivative: d(tau)(H) along dF = l F is l tau + tau l^T + c : sym l. rate: d(tau).
template <class M>
void tangent_is_lie_derivative(const M& m, const Mat3& gradient, const Mat3& l, const Mat3& rate,
                               double tolerance) {
  Mat3 stress;
  double c[6][6];
  m.tangent(Deformation<double>(gradient), stress, c);
  const Mat3 left = l * stress, right = stress * transpose(l);
  for (int v = 0; v < voigt_size; ++v) {
    const int i = voigt_row[v], j = voigt_column[v];
    double expected = left[i][j] + right[i][j];
    for (int w = 0; w < voigt_size; ++w) {
      const int p = voigt_row[w], q = voigt_column[w];
      expected += c[v][w] * (p == q ? l[p][p] : l[p][q] + l[q][p]);
      EXPECT_NEAR(c[v][w], c[w][v], 4e-15);
    }
    EXPECT_NEAR(rate[i][j], expected, tolerance) << i << j;
  }
}

const Mat3 some_rate = {{{0.3, 0.1, -0.4}, {0.6, -0.2, 0.5}, {0.2, -0.7, 0.8}}};

TYPED_TEST(FiniteStrain, TangentIsLieDerivativeOfStress) {
  const auto& m = this->material;
  Mat3 F = some_gradient;
  for (int i = 0; i < 3; ++i)
    F[i][i] += 1.0;
  const Mat3 rate = some_rate * F;
  Mat<Ad, 3> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      h[i][j] = Ad(some_gradient[i][j]);
      h[i][j].fastAccessDx(0) = rate[i][j];
    }
  const Mat<Ad, 3> s = m.stress(Deformation<Ad>(h));
  Mat3 along;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      along[i][j] = s[i][j].dx(0);
  tangent_is_lie_derivative(m, some_gradient, some_rate, along, 4e-14);
}

// Where stretches coincide or nearly do, by central differences: nothing there may divide by zero.
TYPED_TEST(FiniteStrain, TangentIsSmoothAtEqualStretches) {
  const double step = 1e-5;
  for (const double apart : {0.0, 1e-15, 1e-9, 1e-4}) {
    Mat3 h = stretch(1.2, 0.9);
    h[0][0] += apart;
    Mat3 F = h, plus = h, minus = h;
    for (int i = 0; i < 3; ++i)
      F[i][i] += 1.0;
    const Mat3 rate = some_rate * F;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        plus[i][j] += step * rate[i][j];
        minus[i][j] -= step * rate[i][j];
      }
    Mat3 along = this->material.stress(Deformation<double>(plus));
    const Mat3 back = this->material.stress(Deformation<double>(minus));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        along[i][j] = (along[i][j] - back[i][j]) / (2.0 * step);
    // step^2 times third derivatives of up to 30
    tangent_is_lie_derivative(this->material, h, some_rate, along, 1e-8);
  }
}

// All laws are linear elastic at small strain, with the constants that the deck's words promise,
// and lose no digits there: F - I is the argument, not F.
TYPED_TEST(FiniteStrain, SmallStrain) {
  Mat3 stress;
  double c[6][6], isotropic[6][6];
  this->material.tangent(Deformation<double>(Mat3::zero()), stress, c);
  const Constants expected = small_strain<TypeParam>();
  isotropic_tangent(expected.lambda, expected.shear, isotropic);
  for (int v = 0; v < 6; ++v)
    for (int w = 0; w < 6; ++w)
      EXPECT_NEAR(c[v][w], isotropic[v][w], 4e-15) << v << w;
  Mat3 h = Mat3::zero();
  h[2][2] = 1.2345678901234567e-12;
  h[0][1] = 0.5e-12;
  const Mat3 s = this->material.stress(Deformation<double>(h));
  EXPECT_NEAR(s[2][2] / 1.2345678901234567e-12, expected.lambda + 2.0 * expected.shear, 3e-10);
  EXPECT_NEAR(s[0][1] / 0.5e-12, expected.shear, 3e-11);
}

// Uniaxial stress of incompressible rubber: sigma = 2 (l^2 - 1/l) (c1 + c2/l).
TEST(MooneyRivlin, UniaxialStress) {
  const MooneyRivlin m(1e9, 0.3, 0.2);
  for (const double l : {0.5, 0.8, 1.5, 3.0}) {
    const Mat3 s = m.isochoric_stress(Deformation<double>(stretch(l, 1.0 / std::sqrt(l))));
    EXPECT_NEAR(s[2][2] - s[0][0], 2.0 * (l * l - 1.0 / l) * (0.3 + 0.2 / l), 2e-14);
    EXPECT_NEAR(s[0][0] + s[1][1] + s[2][2], 0.0, 1e-14);
  }
}

// One term with m = 2 is Mooney and Rivlin's first term: c/4 (I1* - 3).
TEST(Ogden, SecondPowerIsMooneyRivlin) {
  OgdenSum sum;
  sum.terms = 1;
  sum.c[0] = 1.2;
  sum.m[0] = 2.0;
  const Ogden ogden(5.0, sum);
  const MooneyRivlin mooney(5.0, 0.3, 0.0);
  Mat3 stress[2];
  double c[2][6][6];
  ogden.tangent(Deformation<double>(some_gradient), stress[0], c[0]);
  mooney.tangent(Deformation<double>(some_gradient), stress[1], c[1]);
  for (int v = 0; v < 6; ++v)
    for (int w = 0; w < 6; ++w)
      EXPECT_NEAR(c[0][v][w], c[1][v][w], 2e-14);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(stress[0][i][j], stress[1][i][j], 4e-15);
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
  for (const MaterialModel model : {MaterialModel::neo_hookean, MaterialModel::linear_elastic,
                                    MaterialModel::saint_venant_kirchhoff}) {
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
  EXPECT_THROW(make_material(options(MaterialModel::holmes_mow, 1, 0.3)), Defect);
  MaterialOptions o;
  o.model = MaterialModel::ogden;
  o.bulk = 5.0;
  o.coefficients = {0.5, 0.1};
  o.exponents = {6.82, -1.5};
  EXPECT_EQ(std::get<Ogden>(make_material(o)).sum.terms, 2);
  o.exponents = {6.82, 0.0};
  EXPECT_THROW(make_material(o), Defect);
  o.exponents = {6.82};
  EXPECT_THROW(make_material(o), Defect);
  o.model = MaterialModel::mooney_rivlin;
  o.c1 = 1.0;
  o.c2 = -1.0;
  EXPECT_THROW(make_material(o), Defect);
}

TEST(Material, OptionsReachTheLaw) {
  MaterialOptions o;
  o.model = MaterialModel::mooney_rivlin;
  o.c1 = 0.3;
  o.c2 = 0.2;
  o.bulk = 5.0;
  const auto rubber = std::get<MooneyRivlin>(make_material(o));
  EXPECT_EQ(rubber.c1, 0.3);
  EXPECT_EQ(rubber.c2, 0.2);
  EXPECT_EQ(rubber.bulk, 5.0);
  o = options(MaterialModel::holmes_mow, 0.4, 0.25);
  o.beta = 0.35;
  const auto tissue = std::get<HolmesMow>(make_material(o));
  EXPECT_NEAR(tissue.shear, 0.16, 1e-16);
  EXPECT_NEAR(tissue.lambda, 0.16, 1e-16);
  EXPECT_EQ(tissue.beta, 0.35);
  o = {};
  o.model = MaterialModel::ogden_unconstrained;
  o.coefficients = {0.5};
  o.exponents = {-3.0};
  o.lambda = 2.0;
  const auto foam = std::get<OgdenUnconstrained>(make_material(o));
  EXPECT_EQ(foam.lambda, 2.0);
  EXPECT_EQ(foam.sum.c[0], 0.5);
  EXPECT_EQ(foam.sum.m[0], -3.0);
}

} // namespace
