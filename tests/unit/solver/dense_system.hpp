// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"

#include <cmath>
#include <functional>
#include <vector>

namespace abut::test {

using Values = std::vector<double>;

/// A handful of equations f(x) = 0 with their derivative, spread over the ranks row by row.
class DenseSystem : public solver::NonlinearSystem {
public:
  using Function = std::function<Values(const Values& x)>; ///< f (n) or df/dx (n*n, row by row)

  DenseSystem(int n, Function f, Function derivative)
      : n_(n), comm_(MPI_COMM_WORLD), f_(std::move(f)), derivative_(std::move(derivative)),
        map_(rcp(new Map(n, 0, teuchos_comm(comm_)))) {}

  RCP<const Map> map() const override { return map_; }
  void residual(const Vector& x, Vector& f) override {
    ++evaluations;
    const Values all = f_(gather(x));
    if (all.empty())
      throw SolveError("no residual here");
    scatter(all, f);
  }
  RCP<const Matrix> tangent(const Vector& x) override {
    const Values all = derivative_(gather(x));
    if (changing_graph)
      ++version_;
    // With a changing graph zeros are left out, otherwise every row is full.
    const auto matrix = rcp(new Matrix(map_, static_cast<std::size_t>(n_)));
    for (Local i = 0; i < static_cast<Local>(local_size(*map_)); ++i) {
      const Global row = map_->getGlobalElement(i);
      for (Global column = 0; column < n_; ++column) {
        const double value = all[static_cast<std::size_t>(row * n_ + column)];
        if (!changing_graph || value != 0.0)
          matrix->insertGlobalValues(row, 1, &value, &column);
      }
    }
    matrix->fillComplete();
    return matrix;
  }
  long graph_version() const override { return version_; }
  bool symmetric() const override { return is_symmetric; }
  bool indefinite() const override { return is_indefinite; }
  bool overloaded() const override { return is_overloaded; }
  bool lands() const override { return does_land; }
  double reference_force() const override { return reference; }

  void begin_solve(SolveKind kind) override { solves.push_back(kind); }
  void set_time(double t) override { time = t; }
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs) override {
    residual(x, rhs);
    rhs.scale(-1.0);
    return tangent(x);
  }
  void apply_constraints(Vector&) override {}
  void accept(const Vector&) override { ++accepted; }
  void reject() override { ++rejected; }

  Vector vector(const Values& all) const {
    Vector v(map_);
    scatter(all, v);
    return v;
  }
  Values gather(const Vector& v) const {
    const auto view = v.getLocalViewHost(Tpetra::Access::ReadOnly);
    return comm_.all_gather(Values(view.data(), view.data() + view.extent(0)));
  }

  double reference = 1.0, time = 0.0;
  bool is_symmetric = false, is_indefinite = false, is_overloaded = false, does_land = false,
       changing_graph = false;
  int evaluations = 0, accepted = 0, rejected = 0;
  std::vector<SolveKind> solves; ///< begun

private:
  void scatter(const Values& all, Vector& v) const {
    const auto view = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = all[static_cast<std::size_t>(map_->getGlobalElement(static_cast<Local>(i)))];
  }

  int n_;
  Comm comm_;
  Function f_, derivative_;
  RCP<const Map> map_;
  long version_ = 0;
};

} // namespace abut::test
