// SPDX-License-Identifier: BSD-3-Clause
#include "automatic.hpp"

#include "abut/solid/face_kernel.hpp"
#include "formulations.hpp"
#include "small_mesh.hpp"
#include "some_laws.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using abut::fem::CellType;

namespace {

template <CellType C, class M, class F = Displacement> struct Case {
  static constexpr CellType type = C;
  using Law = M;
  using Formulation = F;
};

template <class P> class Element : public ::testing::Test {
public:
  static constexpr CellType type = P::type;
  using Law = typename P::Law;
  static constexpr int n = ReferenceCell<type>::nodes;
  using Nodal = double[3][n];

  static Law law() { return some_law<Law>(); }

  template <class T> double residual(const T (&u)[3][n], T (&r)[3][n]) const {
    return P::Formulation::template residual<type>(law(), x, u, r);
  }
  void averages(double stress[6], double& energy) const {
    P::Formulation::template averages<type>(law(), x, u, stress, energy);
  }

  /// Straight edges between moved corners, then every node moved by up to `curved`.
  void set_x(double curved) {
    const auto corners = test::distorted_corners(type, 0.08, engine);
    const auto nodes = test::straight_nodes(type, corners);
    const auto moved = test::random_vector(3 * n, curved, engine);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        x[i][a] = nodes[a][i] + moved[3 * a + i];
  }
  void set_u(double amount) {
    const auto random = test::random_vector(3 * n, amount, engine);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        u[i][a] = random[3 * a + i];
  }
  /// u = H x + b
  void set_linear(const Mat3& h, const Vec3& b) {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        u[i][a] = b[i] + h[i][0] * x[0][a] + h[i][1] * x[1][a] + h[i][2] * x[2][a];
  }
  std::vector<double> tangent() {
    std::vector<double> k(9 * n * n);
    EXPECT_GT(tangent(k), 0.0);
    return k;
  }
  double tangent(std::vector<double>& k) const {
    return P::Formulation::template tangent<type>(law(), x, u, k.data());
  }

  std::mt19937 engine{7};
  Nodal x, u;
};

using N = NeoHookean;
using L = LinearElastic;
/// Cases of finite strain and, beside them, these.
template <class... Small>
using CasesWith = ::testing::Types<
    Case<CellType::hex8, N>, Case<CellType::hex20, N>, Case<CellType::hex27, N>,
    Case<CellType::tet4, N>, Case<CellType::tet10, N>, Case<CellType::wedge6, N>,
    Case<CellType::hex8, SaintVenantKirchhoff>, Case<CellType::hex8, HolmesMow>,
    Case<CellType::hex8, MooneyRivlin>, Case<CellType::tet10, MooneyRivlin>,
    Case<CellType::wedge6, Ogden>, Case<CellType::hex8, OgdenUnconstrained>,
    Case<CellType::hex8, MooneyRivlin, MeanDilatation>, Case<CellType::hex8, Ogden, MeanDilatation>,
    Case<CellType::wedge6, MooneyRivlin, MeanDilatation>, Case<CellType::hex8, N, Enhanced>,
    Case<CellType::hex8, SaintVenantKirchhoff, Enhanced>, Case<CellType::hex8, HolmesMow, Enhanced>,
    Case<CellType::hex8, MooneyRivlin, Enhanced>, Case<CellType::hex8, Ogden, Enhanced>,
    Case<CellType::hex8, OgdenUnconstrained, Enhanced>, Small...>;
using FiniteStrainCases = CasesWith<>;
using Cases = CasesWith<Case<CellType::hex8, L>, Case<CellType::hex20, L>, Case<CellType::hex27, L>,
                        Case<CellType::tet4, L>, Case<CellType::tet10, L>,
                        Case<CellType::wedge6, L>, Case<CellType::hex8, L, Enhanced>>;
TYPED_TEST_SUITE(Element, Cases);

template <class P> class FiniteStrainElement : public Element<P> {};
TYPED_TEST_SUITE(FiniteStrainElement, FiniteStrainCases);

double largest(const std::vector<double>& v) {
  double m = 0.0;
  for (const double x : v)
    m = std::max(m, std::abs(x));
  return m;
}

TYPED_TEST(Element, TangentMatchesAutomaticDifferentiation) {
  constexpr int n = TestFixture::n, size = 3 * n;
  using Ad = Sacado::Fad::SFad<double, size>;
  for (int trial = 0; trial < 5; ++trial) {
    this->set_x(0.03);
    this->set_u(0.06);
    static Ad u[3][n], r[3][n];
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        u[i][a] = Ad(size, 3 * a + i, this->u[i][a]);
    ASSERT_GT(this->residual(u, r), 0.0);
    const std::vector<double> k = this->tangent();
    const double scale = largest(k);
    double worst = 0.0, plain[3][n];
    this->residual(this->u, plain);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(plain[i][a], r[i][a].val(), 1e-14 * scale);
        for (int m = 0; m < size; ++m)
          worst = std::max(worst, std::abs(k[(3 * a + i) * size + m] - r[i][a].dx(m)));
      }
    EXPECT_LT(worst, 1e-13 * scale);
    for (int p = 0; p < size; ++p)
      for (int q = 0; q < p; ++q)
        EXPECT_EQ(k[p * size + q], k[q * size + p]);
  }
}

TYPED_TEST(Element, ResidualIsDerivativeOfEnergy) {
  constexpr int n = TestFixture::n;
  this->set_x(0.03);
  this->set_u(0.06);
  double r[3][n], stress[6], plus, minus;
  this->residual(this->u, r);
  const double h = 1e-5;
  for (const int a : {0, n - 1})
    for (int i = 0; i < 3; ++i) {
      const double at = this->u[i][a];
      this->u[i][a] = at + h;
      this->averages(stress, plus);
      this->u[i][a] = at - h;
      this->averages(stress, minus);
      this->u[i][a] = at;
      EXPECT_NEAR((plus - minus) / (2 * h), r[i][a], 2e-9); // h^2 times third derivatives
    }
}

// Patch test, element by element: under u = H x + b nodal forces equal the integrals over the sides
// of N_a times the constant nominal traction, so that forces cancel between elements.
TYPED_TEST(Element, LinearDisplacementGivesConstantStress) {
  constexpr int n = TestFixture::n;
  using Law = typename TestFixture::Law;
  const Mat3 h = {{{0.11, -0.06, 0.04}, {0.08, -0.12, 0.05}, {-0.07, 0.03, 0.09}}};
  const Deformation<double> d(h);
  const Mat3 stress = this->law().stress(d);
  Mat3 nominal = stress;
  Mat3 cauchy = stress;
  if (Law::finite_strain) {
    Mat3 F = h;
    for (int i = 0; i < 3; ++i)
      F[i][i] += 1.0;
    nominal = stress * transpose(inverse(F, det(F)));
    for (auto& row : cauchy.m)
      for (double& value : row)
        value /= det(F);
  }
  for (int trial = 0; trial < 5; ++trial) {
    this->set_x(0.0);
    this->set_linear(h, {{0.3, -0.2, 0.1}});
    double average[6], energy, r[3][n], expected[3][n] = {};
    this->averages(average, energy);
    for (int v = 0; v < 6; ++v)
      EXPECT_NEAR(average[v], cauchy[voigt_row[v]][voigt_column[v]], 1e-14);
    this->residual(this->u, r);
    for (int s = 0; s < fem::info(TestFixture::type).sides; ++s) {
      const fem::CellSide& side = fem::side(TestFixture::type, s);
      fem::dispatch_face(side.type, [&](auto shape) {
        constexpr int m = decltype(shape)::nodes;
        Vec3 xs[m], unit[m];
        for (int a = 0; a < m; ++a)
          for (int i = 0; i < 3; ++i)
            xs[a][i] = this->x[i][side.nodes[a]];
        double one[ReferenceFace<decltype(shape)::type>::points];
        std::fill(std::begin(one), std::end(one), 1.0);
        pressure_residual(reference_face<decltype(shape)::type>(), one, xs, unit); // int N_a n dA
        for (int a = 0; a < m; ++a) {
          const Vec3 force = nominal * unit[a];
          for (int i = 0; i < 3; ++i)
            expected[i][side.nodes[a]] += force[i];
        }
      });
    }
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(r[i][a], expected[i][a], 1e-14) << a << " " << i;
  }
}

TYPED_TEST(Element, RigidMotion) {
  constexpr int n = TestFixture::n, size = 3 * n;
  this->set_x(0.03);
  // Translation leaves nothing, whatever the law.
  this->set_linear(Mat3::zero(), {{3.0, -2.0, 5.0}});
  double r[3][n];
  this->residual(this->u, r);
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(r[i][a], 0.0, 2e-14);
  // In the undeformed state the tangent knows six motions without force.
  this->set_linear(Mat3::zero(), Vec3::zero());
  const std::vector<double> k = this->tangent();
  for (int mode = 0; mode < 6; ++mode) {
    Mat3 spin = Mat3::zero();
    Vec3 shift = Vec3::zero();
    if (mode < 3) {
      shift[mode] = 1.0;
    } else {
      spin[(mode + 1) % 3][(mode + 2) % 3] = -1.0;
      spin[(mode + 2) % 3][(mode + 1) % 3] = 1.0;
    }
    this->set_linear(spin, shift);
    for (int p = 0; p < size; ++p) {
      double f = 0.0;
      for (int b = 0; b < n; ++b)
        for (int j = 0; j < 3; ++j)
          f += k[p * size + 3 * b + j] * this->u[j][b];
      EXPECT_NEAR(f, 0.0, 1e-14 * size * largest(k));
    }
  }
}

TYPED_TEST(FiniteStrainElement, KnowsALargeRotation) {
  static_assert(TestFixture::Law::finite_strain);
  this->set_x(0.03);
  const double c = std::cos(1.1), s = std::sin(1.1);
  this->set_linear({{{c - 1.0, -s, 0.0}, {s, c - 1.0, 0.0}, {0.0, 0.0, 0.0}}}, {{1.0, 2.0, 3.0}});
  double stress[6], energy;
  this->averages(stress, energy);
  for (const double v : stress)
    EXPECT_NEAR(v, 0.0, 2e-14);
  EXPECT_NEAR(energy, 0.0, 1e-14);
}

TYPED_TEST(FiniteStrainElement, ReportsInversion) {
  static_assert(TestFixture::Law::finite_strain);
  constexpr int n = TestFixture::n;
  this->set_x(0.0);
  Mat3 mirror = Mat3::zero();
  mirror[2][2] = -2.0;
  this->set_linear(mirror, Vec3::zero());
  double r[3][n];
  std::vector<double> k(9 * n * n);
  EXPECT_NEAR(this->residual(this->u, r), -1.0, 1e-13);
  EXPECT_NEAR(this->tangent(k), -1.0, 1e-13);
}

// An element's mean J decides: pushing one point's volume up and another's down by the same amount
// costs no volumetric energy, however large the bulk modulus.
TEST(MeanDilatationElement, OnlyTheMeanVolumeChangeCounts) {
  const auto& cell = reference_cell<CellType::hex8>();
  double x[3][8], u[3][8], stress[6], energy;
  for (int a = 0; a < 8; ++a) {
    double xi[3];
    fem::CellShape<CellType::hex8>::node(a, xi);
    for (int i = 0; i < 3; ++i)
      x[i][a] = xi[i];
    for (int i = 0; i < 3; ++i)
      u[i][a] = i == 0 ? 0.01 * xi[0] * xi[1] : 0.0; // bending: J - 1 = 0.01 xi[1]
  }
  const MooneyRivlin soft(1.0, 0.3, 0.2), hard(1e6, 0.3, 0.2);
  mean_dilatation_averages<CellType::hex8>(cell, soft, x, u, stress, energy);
  double with_hard;
  mean_dilatation_averages<CellType::hex8>(cell, hard, x, u, stress, with_hard);
  EXPECT_GT(energy, 1e-5);
  EXPECT_NEAR(with_hard, energy, 1e-15);
  for (int a = 0; a < 8; ++a)
    u[0][a] += 0.01 * x[0][a]; // J - 1 = 0.01 in the mean
  mean_dilatation_averages<CellType::hex8>(cell, hard, x, u, stress, with_hard);
  const double log_j = std::log(1.01);
  EXPECT_NEAR(with_hard, 8.0 * 0.5e6 * log_j * log_j, 1e-3);
  EXPECT_NEAR(stress[0] + stress[1] + stress[2], 3.0 * 1e6 * log_j / 1.01, 1e-8);
}

} // namespace
