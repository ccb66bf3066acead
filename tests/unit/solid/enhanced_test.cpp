// SPDX-License-Identifier: BSD-3-Clause
// What sets the enhanced hex8 apart; what it shares with other elements is in element_test.cpp.
#include "formulations.hpp"
#include "small_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;

namespace {

constexpr int size = 24;
using Nodal = double[3][8];
using Matrix = std::vector<std::vector<double>>;

/// Eigenvalues of a symmetric matrix by Jacobi's rotations, in ascending order.
std::vector<double> eigenvalues(Matrix a) {
  const std::size_t n = a.size();
  for (int sweep = 0; sweep < 30; ++sweep)
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a[p][q] == 0.0)
          continue;
        const double angle = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
        }
      }
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k)
    values.push_back(a[k][k]);
  std::sort(values.begin(), values.end());
  return values;
}

template <class F, class M> Matrix tangent(const M& law, const Nodal& x, const Nodal& u) {
  std::vector<double> k(size * size);
  EXPECT_GT(F::template tangent<CellType::hex8>(law, x, u, k.data()), 0.0);
  Matrix result;
  for (int row = 0; row < size; ++row)
    result.emplace_back(k.begin() + row * size, k.begin() + (row + 1) * size);
  return result;
}

void distorted(Nodal& x, std::mt19937& engine) {
  const auto corners = test::distorted_corners(CellType::hex8, 0.3, engine);
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i)
      x[i][a] = corners[std::size_t(a)][i];
}

void box(Nodal& x, const Vec3& length) {
  for (int a = 0; a < 8; ++a) {
    double xi[3];
    fem::CellShape<CellType::hex8>::node(a, xi);
    for (int i = 0; i < 3; ++i)
      x[i][a] = 0.5 * length[i] * xi[i];
  }
}

void linear(const Mat3& h, const Nodal& x, Nodal& u) {
  for (int a = 0; a < 8; ++a)
    for (int i = 0; i < 3; ++i)
      u[i][a] = h[i][0] * x[0][a] + h[i][1] * x[1][a] + h[i][2] * x[2][a];
}

Mat3 stretches(double a, double b, double c) {
  return {{{a - 1.0, 0.0, 0.0}, {0.0, b - 1.0, 0.0}, {0.0, 0.0, c - 1.0}}};
}

/// Orthonormal displacements without a mean gradient.
std::vector<std::array<double, size>> hourglass_basis(const Nodal& mean_gradient) {
  std::vector<std::array<double, 8>> lines; // of one component, by Gram and Schmidt
  for (int k = 0; k < 12; ++k) {
    std::array<double, 8> line;
    for (int a = 0; a < 8; ++a)
      line[std::size_t(a)] = k == 0  ? 1.0
                             : k < 4 ? mean_gradient[k - 1][a]
                                     : (a == k - 4 ? 1.0 : 0.0);
    for (int pass = 0; pass < 2; ++pass)
      for (const auto& other : lines) {
        double share = 0.0;
        for (std::size_t a = 0; a < 8; ++a)
          share += line[a] * other[a];
        for (std::size_t a = 0; a < 8; ++a)
          line[a] -= share * other[a];
      }
    double norm = 0.0;
    for (const double value : line)
      norm += value * value;
    if (norm < 1e-6)
      continue;
    for (double& value : line)
      value /= std::sqrt(norm);
    lines.push_back(line);
  }
  EXPECT_EQ(lines.size(), 8u);
  std::vector<std::array<double, size>> basis;
  for (std::size_t k = 4; k < lines.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, size> mode{};
      for (std::size_t a = 0; a < 8; ++a)
        mode[3 * a + i] = lines[k][a];
      basis.push_back(mode);
    }
  return basis;
}

Matrix projected(const Matrix& k, const std::vector<std::array<double, size>>& basis) {
  Matrix result(basis.size(), std::vector<double>(basis.size(), 0.0));
  for (std::size_t p = 0; p < basis.size(); ++p)
    for (std::size_t q = 0; q < basis.size(); ++q)
      for (std::size_t m = 0; m < size; ++m)
        for (std::size_t n = 0; n < size; ++n)
          result[p][q] += basis[p][m] * k[m][n] * basis[q][n];
  return result;
}

TEST(EnhancedHex8, KnowsSixMotionsWithoutForceAtRest) {
  std::mt19937 engine(11);
  for (const double lambda : {0.0, 0.7, 1e4})
    for (int trial = 0; trial < 5; ++trial) {
      Nodal x, none = {};
      distorted(x, engine);
      const auto values = eigenvalues(tangent<Enhanced>(NeoHookean{0.4, lambda}, x, none));
      for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(values[std::size_t(k)], 0.0, 1e-13 * values.back());
      EXPECT_GT(values[6], 0.05);
    }
}

/// Least and largest stiffness against hourglass modes in a homogeneous state.
template <class F, class M> std::array<double, 2> hourglass_range(const M& law, const Mat3& h) {
  std::mt19937 engine(11);
  std::array<double, 2> range{{1e300, 0.0}};
  for (int trial = 0; trial < 5; ++trial) {
    Nodal x, u;
    distorted(x, engine);
    linear(h, x, u);
    const auto basis = hourglass_basis(Enhanced::reference(law, x).gradient);
    const auto values = eigenvalues(projected(tangent<F>(law, x, u), basis));
    EXPECT_EQ(values.size(), 12u);
    range = {{std::min(range[0], values.front()), std::max(range[1], values.back())}};
  }
  return range;
}

// However far the element is pressed or drawn, where the law itself is stable.
TEST(EnhancedHex8, HasNoHourglassModeWithoutStiffnessInHomogeneousStates) {
  const Mat3 states[] = {stretches(1.0, 1.0, 1.0),  stretches(1.0, 1.0, 0.2),
                         stretches(1.6, 1.6, 0.39), stretches(0.5, 0.5, 0.5),
                         stretches(0.7, 0.7, 2.0),  stretches(2.0, 2.0, 2.0)};
  for (const Mat3& h : states) {
    EXPECT_GT(hourglass_range<Enhanced>(NeoHookean{0.4, 0.7}, h)[0], 0.01);
    EXPECT_GT(hourglass_range<Enhanced>(NeoHookean{0.4, 70.0}, h)[0], 0.01);
    EXPECT_GT(hourglass_range<Enhanced>(HolmesMow{0.4, 0.3, 0.35}, h)[0], 0.01);
    EXPECT_GT(hourglass_range<Enhanced>(MooneyRivlin(1e3, 0.1, 0.1), h)[0], 0.01);
  }
  EXPECT_GT(hourglass_range<Enhanced>(SaintVenantKirchhoff{0.4, 0.7}, stretches(1.3, 1.3, 1.3))[0],
            0.01);
}

/// A cube under u_x = (l - 1) x + amount x z: stretched along x, by more above than below.
void bent(double l, double amount, const Nodal& x, Nodal& u) {
  for (int a = 0; a < 8; ++a) {
    u[0][a] = (l - 1.0) * x[0][a] + amount * x[0][a] * x[2][a];
    u[1][a] = u[2][a] = 0.0;
  }
}

// Without a lateral strain (lambda is zero) W = G/2 (l^2 - 1) - G ln l of fibers, of which W'' is
// taken: a stiffness of hourglass modes at rest would be right at l = 1 alone.
TEST(EnhancedHex8, BendsAsItsLawWhenStretched) {
  const double shear = 0.4;
  for (const double l : {0.4, 1.0, 2.0}) {
    Nodal x, u, mode;
    box(x, {{1.0, 1.0, 1.0}});
    bent(l, 0.0, x, u);
    bent(1.0, 1.0, x, mode);
    const Matrix k = tangent<Enhanced>(NeoHookean{shear, 0.0}, x, u);
    double stiffness = 0.0;
    for (int m = 0; m < size; ++m)
      for (int n = 0; n < size; ++n)
        stiffness += mode[m % 3][m / 3] * k[std::size_t(m)][std::size_t(n)] * mode[n % 3][n / 3];
    EXPECT_NEAR(stiffness, shear * (1.0 + 1.0 / (l * l)) / 12.0, 1e-12) << l;
  }
}

// At an amount of 2 the lower edge along x has no length.
TEST(EnhancedHex8, ResistsFoldingOfItsCorners) {
  const NeoHookean law{0.4, 0.7};
  Nodal x, u, r;
  box(x, {{1.0, 1.0, 1.0}});
  double force[2] = {};
  for (const int k : {0, 1}) {
    const double amount = k == 0 ? 1.5 : 1.99;
    bent(1.0, amount, x, u);
    ASSERT_GT(Enhanced::residual<CellType::hex8>(law, x, u, r), 0.0);
    force[k] = std::abs(r[0][1]);
  }
  EXPECT_GT(force[0], 0.1);
  EXPECT_GT(force[1], 100.0 * force[0]);
  bent(1.0, 2.0001, x, u);
  EXPECT_LT(Enhanced::residual<CellType::hex8>(law, x, u, r), 0.0);
  EXPECT_GT(Displacement::residual<CellType::hex8>(law, x, u, r), 0.0); // sees it at points alone
}

// The stress of the element is the mean of what its nodal forces hold in balance.
TEST(EnhancedHex8, StressIsThatOfTheForces) {
  std::mt19937 engine(11);
  const NeoHookean law{0.4, 0.7};
  for (int trial = 0; trial < 5; ++trial) {
    Nodal x, u, r;
    distorted(x, engine);
    const auto random = test::random_vector(size, 0.15, engine);
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        u[i][a] = random[std::size_t(3 * a + i)];
    double stress[6], energy;
    ASSERT_GT(Enhanced::residual<CellType::hex8>(law, x, u, r), 0.0);
    Enhanced::averages<CellType::hex8>(law, x, u, stress, energy);
    const EnhancedReference reference = Enhanced::reference(law, x);
    const Deformation<double> mean(nodal_gradient(u, reference.gradient));
    for (int v = 0; v < 6; ++v) {
      double sum = 0.0;
      for (int a = 0; a < 8; ++a)
        sum += r[voigt_row[v]][a] * (x[voigt_column[v]][a] + u[voigt_column[v]][a]);
      EXPECT_NEAR(stress[v], sum / (reference.volume * mean.jacobian()), 1e-13);
    }
  }
}

// The bulk modulus does not enter, on any shape.
TEST(EnhancedHex8, HourglassModesDoNotLock) {
  const Mat3 rest = Mat3::zero();
  const auto soft = hourglass_range<Enhanced>(NeoHookean{0.4, 4.0}, rest);
  const auto hard = hourglass_range<Enhanced>(NeoHookean{0.4, 4e6}, rest);
  EXPECT_LT(hard[1], 1.5 * soft[1]);
  EXPECT_GT(hourglass_range<Displacement>(NeoHookean{0.4, 4e6}, rest)[1], 1e4 * soft[1]);
}

/// Solves a x = b by elimination with pivots.
std::vector<double> solve(Matrix a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k; r < n; ++r)
      if (std::abs(a[r][k]) > std::abs(a[pivot][k]))
        pivot = r;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < n; ++c)
        a[r][c] -= factor * a[k][c];
      b[r] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c)
      b[k] -= a[k][c] * b[c];
    b[k] /= a[k][k];
  }
  return b;
}

/// A box as a beam along x under end moments about y; strain of its upper edges over M h/(2 E I).
template <class F> double bending(const Vec3& length, double young, double nu) {
  Nodal x, none = {};
  box(x, length);
  const double shear = 0.5 * young / (1.0 + nu);
  Matrix k = tangent<F>(LinearElastic{shear, 2.0 * shear * nu / (1.0 - 2.0 * nu)}, x, none);
  std::vector<double> f(size, 0.0);
  for (int a = 0; a < 8; ++a)
    f[std::size_t(3 * a)] = x[0][a] * x[2][a] > 0.0 ? 1.0 : -1.0; // moment 4 h/2
  const int held[] = {0, 1, 2, 3 * 1 + 1, 3 * 1 + 2, 3 * 3 + 2};  // nodes 0, 1, 3: no rigid motion
  for (const int row : held) {
    for (int c = 0; c < size; ++c)
      k[std::size_t(row)][std::size_t(c)] = k[std::size_t(c)][std::size_t(row)] = 0.0;
    k[std::size_t(row)][std::size_t(row)] = 1.0;
    f[std::size_t(row)] = 0.0;
  }
  const std::vector<double> u = solve(k, f);
  const double upper = (u[3 * 5] - u[3 * 4]) / length[0], lower = (u[3 * 1] - u[3 * 0]) / length[0];
  const double inertia = length[1] * std::pow(length[2], 3) / 12.0, moment = 2.0 * length[2];
  return 0.5 * (upper - lower) / (moment * 0.5 * length[2] / (young * inertia));
}

TEST(EnhancedHex8, BendsAsABeam) {
  const Vec3 shapes[] = {{{1.0, 1.0, 1.0}}, {{10.0, 1.0, 1.0}}, {{1.0, 10.0, 0.5}}};
  for (const Vec3& length : shapes)
    for (const double nu : {0.0, 0.3, 0.4999})
      EXPECT_NEAR(bending<Enhanced>(length, 3.0, nu), 1.0, 1e-9) << length[0] << " " << nu;
  EXPECT_LT(bending<Displacement>(shapes[1], 3.0, 0.3), 0.1);
  EXPECT_LT(bending<Displacement>(shapes[0], 3.0, 0.4999), 0.6);
}

} // namespace
