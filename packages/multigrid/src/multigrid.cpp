// SPDX-License-Identifier: BSD-3-Clause
#include "abut/multigrid/multigrid.hpp"

#include "abut/core/error.hpp"
#include "fine_matrix.hpp"
#include "levels.hpp"

#include <optional>

namespace abut::multigrid {

class Multigrid::Hierarchy {
public:
  virtual ~Hierarchy() = default;
  virtual void setup(const Matrix& matrix) = 0;
  virtual void refresh(const Matrix& matrix, bool same_places) = 0;
  virtual void apply(const double* b, double* x) = 0;
  virtual std::vector<LevelReport> report() const = 0;
  virtual std::size_t bytes() const = 0;
  bool is_set_up = false;
};

/// Blocks of N unknowns on the finest level, of one unknown for each mode on the others.
template <int N> class Multigrid::Levels : public Hierarchy {
public:
  static constexpr int M = mode_count(N);

  Levels(const Comm& comm, NearNullSpace space, const Options& options)
      : comm_(comm), space_(std::move(space)), options_(options) {}

  void setup(const Matrix& matrix) override {
    fine_.reset();
    coarse_.clear();
    rows_.emplace(comm_, matrix);
    const auto a = rows_->blocks(matrix);
    std::vector<double> modes = free_modes(FineMatrix<N>::constrained(a));
    const Distribution& rows = rows_->rows();
    if (!is_small<N>(rows))
      fine_ = coarsen<N, M>(a, rows, modes, options_);
    if (!fine_) {
      finish(a, rows);
      return;
    }
    auto next = product_of(*fine_, a);
    while (!is_small<M>(next.columns) &&
           static_cast<int>(coarse_.size()) + 2 < options_.max_levels) {
      auto level = coarsen<M, M>(next.matrix, next.columns, modes, options_);
      if (!level)
        break;
      coarse_.push_back(std::move(*level));
      next = product_of(coarse_.back(), next.matrix);
    }
    finish(next.matrix, next.columns);
  }

  void refresh(const Matrix& matrix, bool same_places) override {
    if (!same_places)
      rows_.emplace(comm_, matrix);
    const auto a = rows_->blocks(matrix);
    if (!fine_) {
      finish(a, rows_->rows());
      return;
    }
    auto next = renewed(*fine_, {a, rows_->rows()}, same_places);
    for (auto& level : coarse_)
      next = renewed(level, next, same_places);
    finish(next.matrix, next.columns);
  }

  void apply(const double* b, double* x) override {
    auto& from = fine_ ? fine_->b : coarsest_b_;
    auto& to = fine_ ? fine_->x : coarsest_x_;
    const auto rows = static_cast<std::size_t>(rows_->rows().owned());
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t r = 0; r < N; ++r)
        from[i * padded(N) + r] = static_cast<float>(b[i * N + r]);
    if (fine_)
      cycle(*fine_, 0);
    else
      coarsest_.solve(from.data(), to.data());
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t r = 0; r < N; ++r)
        x[i * N + r] = to[i * padded(N) + r];
  }

  std::vector<LevelReport> report() const override {
    std::vector<LevelReport> levels;
    if (fine_)
      levels.push_back({fine_->rows.total(), fine_->blocks, N});
    for (const auto& level : coarse_)
      levels.push_back({level.rows.total(), level.blocks, M});
    levels.push_back(last_);
    return levels;
  }

  std::size_t bytes() const override {
    std::size_t sum = coarsest_.bytes() + (fine_ ? fine_->bytes() : 0);
    for (const auto& level : coarse_)
      sum += level.bytes();
    return sum;
  }

private:
  template <int K> bool is_small(const Distribution& rows) const {
    return rows.total() * K <= options_.coarsest_unknowns;
  }

  /// The modes without their part in constrained rows.
  std::vector<double> free_modes(const std::vector<char>& constrained) const {
    std::vector<double> modes = space_.values;
    ABUT_REQUIRE(modes.size() == constrained.size() * M, "modes and matrix differ in their rows");
    for (std::size_t i = 0; i < modes.size(); ++i)
      if (constrained[i / M])
        modes[i] = 0.0;
    return modes;
  }

  template <int K>
  static DistributedRows<float, M, M> product_of(const Level<K, M>& level,
                                                 const BlockMatrix<float, K, K>& a) {
    return galerkin_product<K, M>(a, level.rows, level.prolongator, level.restriction,
                                  level.aggregates);
  }

  template <int K>
  static DistributedRows<float, M, M>
  renewed(Level<K, M>& level, const DistributedRows<float, K, K>& a, bool same_places) {
    if (same_places)
      level.smoother.renew(a.matrix);
    else
      level.take(a.matrix, a.columns);
    return product_of(level, a.matrix);
  }

  template <int K> void finish(const BlockMatrix<float, K, K>& a, const Distribution& rows) {
    coarsest_ = Coarsest(a, rows);
    last_ = {rows.total(), comm_.sum(static_cast<Global>(a.blocks())), K};
    coarsest_b_.assign(static_cast<std::size_t>(rows.size()) * padded(K), 0.0F);
    coarsest_x_ = coarsest_b_;
    is_set_up = true;
  }

  /// level.x = the V cycle's answer to level.b.
  template <int K> void cycle(Level<K, M>& level, std::size_t next) {
    const std::vector<float>& b = level.b;
    std::vector<float>&x = level.x, &work = level.work;
    level.smoother.forward_from_zero(b.data(), x.data());
    level.rows.exchange().to_ghosts(x.data(), padded(K));
    level.smoother.residual_after_forward(x.data(), work.data());
    const bool last = next == coarse_.size();
    std::vector<float>& coarse_b = last ? coarsest_b_ : coarse_[next].b;
    std::vector<float>& coarse_x = last ? coarsest_x_ : coarse_[next].x;
    multiply(level.restriction, work.data(), coarse_b.data());
    level.aggregates.exchange().add_to_owners(coarse_b.data(), padded(M));
    if (last)
      coarsest_.solve(coarse_b.data(), coarse_x.data());
    else
      cycle(coarse_[next], next + 1);
    level.aggregates.exchange().to_ghosts(coarse_x.data(), padded(M));
    multiply(level.prolongator, coarse_x.data(), x.data(), true);
    level.rows.exchange().to_ghosts(x.data(), padded(K));
    level.smoother.backward(b.data(), x.data(), work.data());
  }

  Comm comm_;
  NearNullSpace space_;
  Options options_;
  std::optional<FineMatrix<N>> rows_;
  std::optional<Level<N, M>> fine_;
  std::vector<Level<M, M>> coarse_;
  Coarsest coarsest_;
  LevelReport last_;
  std::vector<float> coarsest_b_, coarsest_x_; ///< (rows, padded)
};

Multigrid::Multigrid(const Comm& comm, const NearNullSpace& modes, const Options& options) {
  switch (modes.fields) {
  case 1:
    hierarchy_ = std::make_unique<Levels<1>>(comm, modes, options);
    return;
  case 2:
    hierarchy_ = std::make_unique<Levels<2>>(comm, modes, options);
    return;
  case 3:
    hierarchy_ = std::make_unique<Levels<3>>(comm, modes, options);
    return;
  case 4:
    hierarchy_ = std::make_unique<Levels<4>>(comm, modes, options);
    return;
  }
  ABUT_REQUIRE(false, "multigrid takes one to four unknowns to a row");
}

Multigrid::~Multigrid() = default;

void Multigrid::setup(const Matrix& matrix) {
  hierarchy_->setup(matrix);
}

void Multigrid::refresh(const Matrix& matrix, bool same_places) {
  hierarchy_->refresh(matrix, same_places);
}

bool Multigrid::is_set_up() const {
  return hierarchy_->is_set_up;
}

void Multigrid::apply(const double* b, double* x) const {
  hierarchy_->apply(b, x);
}

std::vector<LevelReport> Multigrid::levels() const {
  return hierarchy_->report();
}

double Multigrid::operator_complexity() const {
  double sum = 0.0;
  const auto all = levels();
  const auto size = [](const LevelReport& level) {
    return double(level.blocks) * level.unknowns_per_row * level.unknowns_per_row;
  };
  for (const LevelReport& level : all)
    sum += size(level);
  return sum / size(all.front());
}

std::size_t Multigrid::bytes() const {
  return hierarchy_->bytes();
}

} // namespace abut::multigrid
