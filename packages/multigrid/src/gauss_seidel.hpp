// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/multigrid/block_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace abut::multigrid {

/// D^-1 of a block matrix, row by row. A row without a usable diagonal block is divided by one.
template <int N> class InverseDiagonal {
public:
  InverseDiagonal() = default;
  /// border: (rows, padded(N)) added to the diagonal, or empty.
  explicit InverseDiagonal(const BlockMatrix<float, N, N>& a, const View<float>& border = {});

  KOKKOS_INLINE_FUNCTION Pack<float, N> times(Local i, const Pack<float, N>& x) const {
    Pack<float, N> y;
    add_product<float, N, N>(value_.data() + static_cast<std::size_t>(i) * size, x.value, y);
    return y;
  }
  std::size_t bytes() const { return value_.size() * sizeof(float); }

private:
  static constexpr int size = N * N;
  View<float> value_; ///< (rows, N, N), see block_values
};

/// What is added to the diagonal of rows with columns of other ranks. Between ranks the sweep is
/// Jacobi's, which diverges where strong couplings cross; with half the sum of a row's sizes there
/// on the diagonal it converges for any partition. Rows where that is little are left as they are.
/// Baker, Falgout, Kolev, Yang, Multigrid smoothers for ultraparallel computing, SIAM J. Sci.
/// Comput. 33 (2011), section 6.
template <int N> View<float> border_weights(const BlockMatrix<float, N, N>& a);

/// Block Gauss-Seidel on the owned rows; values of ghosts are those of the last exchange. The
/// matrix is kept in parts that each sweep reads from front to back: a sweep is bound by memory.
template <int N> class GaussSeidel {
public:
  using Blocks = BlockMatrix<float, N, N>;

  GaussSeidel() = default;
  /// a: rows sorted by column; columns from the number of rows on are ghosts.
  explicit GaussSeidel(const Blocks& a);
  /// Takes other values in the same places.
  void renew(const Blocks& a);

  /// One forward sweep from x = 0: x = (L + D)^-1 b, D with the border's weights.
  void forward_from_zero(const float* b, float* x) const;
  /// r = b - A x after forward_from_zero and an exchange of x. Needs no b, as b = (L + D) x.
  void residual_after_forward(const float* x, float* r) const;
  /// One backward sweep. x: its ghosts exchanged. work: (rows, padded).
  void backward(const float* b, float* x, float* work) const;

  /// D^-1 with the border's weights.
  const InverseDiagonal<N>& inverse_diagonal() const { return inverse_; }
  std::size_t bytes() const {
    return lower_.bytes() + upper_.bytes() + ghost_.bytes() + inverse_.bytes() +
           border_.size() * sizeof(float);
  }

private:
  Blocks lower_;       ///< strictly lower blocks
  Blocks upper_;       ///< strictly upper blocks, the last row first, columns descending
  Blocks ghost_;       ///< blocks in columns of other ranks
  View<float> border_; ///< (rows, padded(N)), empty where no row has such columns
  InverseDiagonal<N> inverse_;
};

/// Inverse of a dense block by Gauss and Jordan with row exchanges, in double precision.
template <int N> void invert(const float* block, float* inverse) {
  double m[N][2 * N] = {};
  for (int r = 0; r < N; ++r) {
    for (int c = 0; c < N; ++c)
      m[r][c] = block[c * N + r];
    m[r][N + r] = 1.0;
  }
  for (int c = 0; c < N; ++c) {
    int pivot = c;
    for (int r = c + 1; r < N; ++r)
      if (std::fabs(m[r][c]) > std::fabs(m[pivot][c]))
        pivot = r;
    if (m[pivot][c] == 0.0)
      m[pivot = c][c] = 1.0;
    for (int k = 0; k < 2 * N; ++k)
      std::swap(m[c][k], m[pivot][k]);
    const double scale = 1.0 / m[c][c];
    for (int k = 0; k < 2 * N; ++k)
      m[c][k] *= scale;
    for (int r = 0; r < N; ++r)
      for (int k = 2 * N - 1; r != c && k >= c; --k)
        m[r][k] -= m[r][c] * m[c][k];
  }
  for (int c = 0; c < N; ++c)
    for (int r = 0; r < N; ++r)
      inverse[c * N + r] = static_cast<float>(m[r][N + c]);
}

template <int N>
InverseDiagonal<N>::InverseDiagonal(const BlockMatrix<float, N, N>& a, const View<float>& border) {
  value_ = block_values<N, float>("multigrid: inverse diagonal",
                                  static_cast<std::size_t>(a.rows) * size);
  float block[size];
  for (Local i = 0; i < a.rows; ++i)
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k) {
      if (a.column(k) != i)
        continue;
      std::copy_n(a.block(k), size, block);
      for (int r = 0; r < N && border.size() > 0; ++r)
        block[r * N + r] += border(static_cast<std::size_t>(i) * padded(N) + r);
      invert<N>(block, value_.data() + static_cast<std::size_t>(i) * size);
    }
}

template <int N> View<float> border_weights(const BlockMatrix<float, N, N>& a) {
  constexpr float little = 1.0F / 3.0F; // of the diagonal
  View<float> weight;
  for (Local i = 0; i < a.rows; ++i) {
    float sum[N] = {}, diagonal[N] = {};
    for (Local k = a.offset(i); k < a.offset(i + 1); ++k)
      for (int c = 0; c < N; ++c)
        for (int r = 0; r < N; ++r) {
          const float entry = std::fabs(a.block(k)[c * N + r]);
          if (a.column(k) >= a.rows)
            sum[r] += 0.5F * entry;
          else if (a.column(k) == i && r == c)
            diagonal[r] = entry;
        }
    for (int r = 0; r < N; ++r) {
      if (sum[r] <= little * diagonal[r])
        continue;
      if (weight.size() == 0)
        weight = View<float>("multigrid: border", static_cast<std::size_t>(a.rows) * padded(N));
      weight(static_cast<std::size_t>(i) * padded(N) + r) = sum[r];
    }
  }
  return weight;
}

/// Calls visit(row, k) for the blocks of each row from front to back or, from the last row on, from
/// back to front.
template <int N, class Visit>
void for_each_block(const BlockMatrix<float, N, N>& a, bool backward, Visit visit) {
  for (Local n = 0; n < a.rows; ++n) {
    const Local i = backward ? a.rows - 1 - n : n;
    const Local first = a.offset(i), last = a.offset(i + 1);
    for (Local m = 0; m < last - first; ++m)
      visit(i, backward ? last - 1 - m : first + m);
  }
}

/// Which blocks of a matrix are in a part of it, and in which order.
template <int N> struct Part {
  bool backward;
  bool (*keeps)(Local row, Local column, Local rows);

  /// Zero blocks in the part's places.
  BlockMatrix<float, N, N> places(const BlockMatrix<float, N, N>& a) const {
    std::vector<Local> offset(static_cast<std::size_t>(a.rows) + 1, 0), column;
    for_each_block<N>(a, backward, [&](Local i, Local k) {
      if (!keeps(i, a.column(k), a.rows))
        return;
      column.push_back(a.column(k));
      ++offset[static_cast<std::size_t>(backward ? a.rows - 1 - i : i) + 1];
    });
    for (std::size_t i = 1; i < offset.size(); ++i)
      offset[i] += offset[i - 1];
    return make_block_matrix<float, N, N>(offset, column);
  }

  void copy(const BlockMatrix<float, N, N>& a, BlockMatrix<float, N, N>& part) const {
    Local to = 0;
    for_each_block<N>(a, backward, [&](Local i, Local k) {
      if (keeps(i, a.column(k), a.rows))
        std::copy_n(a.block(k), a.block_size, part.block(to++));
    });
  }
};

template <int N> constexpr Part<N> lower_part{false, [](Local i, Local j, Local) { return j < i; }};
template <int N>
constexpr Part<N> upper_part{true, [](Local i, Local j, Local rows) { return j > i && j < rows; }};
template <int N>
constexpr Part<N> ghost_part{false, [](Local, Local j, Local rows) { return j >= rows; }};

template <int N>
GaussSeidel<N>::GaussSeidel(const Blocks& a)
    : lower_(lower_part<N>.places(a)), upper_(upper_part<N>.places(a)),
      ghost_(ghost_part<N>.places(a)) {
  renew(a);
}

template <int N> void GaussSeidel<N>::renew(const Blocks& a) {
  lower_part<N>.copy(a, lower_);
  upper_part<N>.copy(a, upper_);
  ghost_part<N>.copy(a, ghost_);
  border_ = ghost_.blocks() > 0 ? border_weights<N>(a) : View<float>();
  inverse_ = InverseDiagonal<N>(a, border_);
}

/// The border's weights times x, of one row.
template <int N>
KOKKOS_INLINE_FUNCTION Pack<float, N> border_product(const View<float>& border, std::size_t at,
                                                     const float* x) {
  Pack<float, N> y;
  if (border.size() > 0)
    for (int r = 0; r < padded(N); ++r)
      y.value[r] = border(at + r) * x[at + r];
  return y;
}

/// One row of the forward sweep. To be run in order, on one thread.
template <int N> struct ForwardRow {
  BlockMatrix<float, N, N> lower;
  InverseDiagonal<N> inverse;
  const float* b;
  float* x;

  void operator()(Local i) const {
    const std::size_t at = static_cast<std::size_t>(i) * padded(N);
    inverse.times(i, Pack<float, N>::load(b + at) - lower.row_product(i, x)).store(x + at);
  }
};

template <int N> void GaussSeidel<N>::forward_from_zero(const float* b, float* x) const {
  with_row_registers(ForwardRow<N>{lower_, inverse_, b, x}, [&](const auto& row) {
    for (Local i = 0; i < lower_.rows; ++i)
      row(i);
  });
}

/// r = (border - U - ghost columns) x, from the last row on: as U lies in memory.
template <int N> struct UpperResidual {
  BlockMatrix<float, N, N> upper, ghost;
  View<float> border;
  const float* x;
  float* r;

  KOKKOS_INLINE_FUNCTION void operator()(Local n) const {
    const Local i = upper.rows - 1 - n;
    const auto product = upper.row_product(n, x) + ghost.row_product(i, x);
    const std::size_t at = static_cast<std::size_t>(i) * padded(N);
    (border_product<N>(border, at, x) - product).store(r + at);
  }
};

template <int N> void GaussSeidel<N>::residual_after_forward(const float* x, float* r) const {
  with_row_registers(UpperResidual<N>{upper_, ghost_, border_, x, r}, [&](const auto& kernel) {
    Kokkos::parallel_for("abut::multigrid::residual", Range(0, lower_.rows), kernel);
  });
}

/// w = b - (L + ghost columns - border) x.
template <int N> struct LowerResidual {
  BlockMatrix<float, N, N> lower, ghost;
  View<float> border;
  const float *b, *x;
  float* w;

  KOKKOS_INLINE_FUNCTION void operator()(Local i) const {
    const std::size_t at = static_cast<std::size_t>(i) * padded(N);
    const auto product = lower.row_product(i, x) + ghost.row_product(i, x);
    (Pack<float, N>::load(b + at) - product + border_product<N>(border, at, x)).store(w + at);
  }
};

/// One row of the backward sweep: x_i = D_i^-1 (w_i - U x_new). To be run from the last row on.
template <int N> struct BackwardRow {
  BlockMatrix<float, N, N> upper; ///< its last row first
  InverseDiagonal<N> inverse;
  const float* w;
  float* x;

  void operator()(Local i) const {
    const std::size_t at = static_cast<std::size_t>(i) * padded(N);
    const auto product = upper.row_product(upper.rows - 1 - i, x);
    inverse.times(i, Pack<float, N>::load(w + at) - product).store(x + at);
  }
};

/// The lower part is taken before the sweep begins, as it multiplies old values only.
template <int N> void GaussSeidel<N>::backward(const float* b, float* x, float* work) const {
  with_row_registers(
      LowerResidual<N>{lower_, ghost_, border_, b, x, work}, [&](const auto& kernel) {
        Kokkos::parallel_for("abut::multigrid::lower_residual", Range(0, lower_.rows), kernel);
      });
  with_row_registers(BackwardRow<N>{upper_, inverse_, work, x}, [&](const auto& row) {
    for (Local i = upper_.rows - 1; i >= 0; --i)
      row(i);
  });
}

} // namespace abut::multigrid
