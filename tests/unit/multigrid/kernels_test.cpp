// SPDX-License-Identifier: BSD-3-Clause
// The internal steps of the setup against plain dense algebra.
#include "../../../packages/multigrid/src/aggregates.hpp"
#include "../../../packages/multigrid/src/gauss_seidel.hpp"
#include "../../../packages/multigrid/src/products.hpp"

#include <gtest/gtest.h>

namespace {

using namespace abut;
using namespace abut::multigrid;
using Dense = std::vector<std::vector<double>>;

/// Each third block, filled with numbers that look random.
template <int R, int C> BlockMatrix<float, R, C> sample(Local rows, Local columns, int seed) {
  std::vector<Local> offset{0}, column;
  for (Local i = 0; i < rows; ++i) {
    for (Local j = 0; j < columns; ++j)
      if (i == j || (i + 2 * j + seed) % 3 == 0)
        column.push_back(j);
    offset.push_back(static_cast<Local>(column.size()));
  }
  auto a = make_block_matrix<float, R, C>(offset, column);
  for (Local i = 0; i < rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (int c = 0; c < C; ++c)
        for (int r = 0; r < R; ++r)
          a.block(k)[c * R + r] =
              std::sin(1.7F * float(k) + 3.1F * float(c * R + r) + float(seed)) +
              (a.column(k) == i && r == c ? 10.0F : 0.0F);
  return a;
}

template <int R, int C> Dense dense(const BlockMatrix<float, R, C>& a, Local columns) {
  Dense m(std::size_t(a.rows * R), std::vector<double>(std::size_t(columns * C), 0.0));
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (int c = 0; c < C; ++c)
        for (int r = 0; r < R; ++r)
          m[std::size_t(i * R + r)][std::size_t(a.column(k) * C + c)] = a.block(k)[c * R + r];
  return m;
}

void expect_near(const Dense& a, const Dense& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    for (std::size_t j = 0; j < a[i].size(); ++j)
      EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << ", " << j;
  }
}

TEST(Products, EqualThoseOfDenseMatrices) {
  const auto a = sample<3, 3>(7, 7, 1);
  const auto b = sample<3, 6>(7, 4, 2);
  const Dense x = dense(a, 7), y = dense(b, 4);
  Dense expected(x.size(), std::vector<double>(y[0].size(), 0.0));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < y.size(); ++k)
      for (std::size_t j = 0; j < y[0].size(); ++j)
        expected[i][j] += x[i][k] * y[k][j];
  expect_near(dense(product<float, 3, 3, 6>(a, b, 4), 4), expected, 1e-4);
}

TEST(Products, TransposeSwapsRowsAndColumns) {
  const auto a = sample<3, 6>(7, 4, 3);
  const Dense x = dense(a, 4), y = dense(transpose(a, 4), 7);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x[i].size(); ++j)
      EXPECT_EQ(x[i][j], y[j][i]);
}

TEST(GaussSeidel, SweepsAreThoseOfTheTextbook) {
  const Local rows = 7;
  const auto a = sample<3, 3>(rows, rows, 4);
  const GaussSeidel<3> smoother(a);
  const std::size_t length = std::size_t(rows) * padded(3);
  std::vector<float> b(length), x(length, 0.0F), r(length), work(length);
  for (std::size_t i = 0; i < length; ++i)
    b[i] = i % padded(3) < 3 ? std::cos(float(i)) : 0.0F;
  std::vector<float> plain(length, 0.0F);
  const InverseDiagonal<3> inverse(a);
  const auto relax = [&](Local i) {
    const std::size_t at = std::size_t(i) * padded(3);
    auto rest = Pack<float, 3>::load(b.data() + at) - a.row_product(i, plain.data());
    (Pack<float, 3>::load(plain.data() + at) + inverse.times(i, rest)).store(plain.data() + at);
  };
  smoother.forward_from_zero(b.data(), x.data());
  for (Local i = 0; i < rows; ++i)
    relax(i);
  for (std::size_t i = 0; i < length; ++i)
    EXPECT_NEAR(x[i], plain[i], 1e-6);
  smoother.residual_after_forward(x.data(), r.data());
  for (Local i = 0; i < rows; ++i) {
    const auto rest = Pack<float, 3>::load(b.data() + 4 * i) - a.row_product(i, plain.data());
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(r[std::size_t(4 * i + c)], rest.value[c], 1e-5);
  }
  smoother.backward(b.data(), x.data(), work.data());
  for (Local i = rows - 1; i >= 0; --i)
    relax(i);
  for (std::size_t i = 0; i < length; ++i)
    EXPECT_NEAR(x[i], plain[i], 1e-6);
}

TEST(Aggregates, TakeEveryCoupledRowOnce) {
  StrengthGraph line; // ten rows in a line, and one by itself
  for (Local i = 0; i < 10; ++i) {
    if (i > 0)
      line.neighbour.push_back(i - 1);
    if (i < 9)
      line.neighbour.push_back(i + 1);
    line.offset.push_back(static_cast<Local>(line.neighbour.size()));
  }
  line.offset.push_back(line.offset.back());
  const Aggregates groups = aggregate(line);
  EXPECT_EQ(groups.of_row.back(), -1);
  EXPECT_EQ(groups.count, 4);
  std::vector<int> size(std::size_t(groups.count), 0);
  for (std::size_t i = 0; i < 10; ++i) {
    ASSERT_GE(groups.of_row[i], 0);
    ++size[std::size_t(groups.of_row[i])];
  }
  for (const int members : size)
    EXPECT_GE(members, 2);
}

} // namespace
