// SPDX-License-Identifier: BSD-3-Clause
// A kernel gives the same values on every vector unit, but for rounding.
#include "abut/core/vector_units.hpp"
#include "abut/core/views.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace abut;

namespace {

constexpr int rows = 100, columns = 37;

/// Sums of products along a row, and the largest of them.
struct Sums {
  const double* a;
  double* sum;

  void operator()(Local i, double& largest) const {
    double s = 0.0;
    for (int j = 0; j < columns; ++j)
      s += a[i * columns + j] * (1.0 + 1e-3 * a[(i * columns + j + 1) % (rows * columns)]);
    sum[i] = s;
    largest = std::max(largest, s);
  }
};

struct Answer {
  std::vector<double> sum;
  double largest = 0.0;
};

template <class Kernel> Answer run(const Kernel& kernel, std::vector<double>& sum) {
  Answer answer;
  Kokkos::parallel_reduce("sums", Range(0, rows), kernel, Kokkos::Max<double>(answer.largest));
  answer.sum = sum;
  return answer;
}

} // namespace

TEST(VectorUnits, GiveTheSameValues) {
  std::vector<double> a, sum(rows);
  for (int i = 0; i < rows * columns; ++i)
    a.push_back(std::sin(1.7 * i));
  const Sums kernel{a.data(), sum.data()};
  const Answer plain = run(kernel, sum);
  EXPECT_GT(plain.largest, 0.01);
  std::vector<Answer> others;
  with_vector_units<double>(kernel, [&](const auto& k) { others.push_back(run(k, sum)); });
  if (vector_unit() >= VectorUnit::avx2)
    others.push_back(run(Wide<VectorUnit::avx2, Sums, double>{kernel}, sum));
  for (const Answer& other : others) {
    EXPECT_NEAR(other.largest, plain.largest, 1e-13);
    for (int i = 0; i < rows; ++i)
      EXPECT_NEAR(other.sum[i], plain.sum[i], 1e-13);
  }
}
