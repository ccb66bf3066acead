// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/assembly/equation_system.hpp"
#include "abut/solver/nonlinear_system.hpp"

#include <functional>
#include <utility>

namespace abut::solver {

/// The assembled equations as Newton sees them.
class AssembledSystem : public NonlinearSystem {
public:
  /// The equations must outlive this object.
  explicit AssembledSystem(assembly::EquationSystem& equations) : equations_(equations) {}

  /// What beside the equations may find that the end of a solve is no solution: throws SolveError
  /// then. Collective.
  void set_check(std::function<void()> check) { check_ = std::move(check); }

  RCP<const Map> map() const override { return equations_.dofs().map(); }
  void residual(const Vector& x, Vector& f) override { equations_.residual(x, f); }
  RCP<const Matrix> tangent(const Vector& x) override { return equations_.tangent(x); }
  long graph_version() const override { return equations_.graph_version(); }
  bool symmetric() const override { return equations_.symmetric(); }
  bool indefinite() const override { return equations_.indefinite(); }
  double reference_force() const override { return equations_.measure().reference; }
  double round_off_force() const override { return equations_.measure().round_off; }
  bool settled() const override { return equations_.measure().settled; }
  bool overloaded() const override { return equations_.measure().overloaded; }
  bool lands() const override { return equations_.measure().lands; }
  void require_consistent() const override {
    equations_.require_consistent();
    if (check_)
      check_();
  }
  int unknowns_per_node() const override { return equations_.dofs().fields(); }
  std::vector<RowPlace> row_places() const override;
  void set_time(double t) override { equations_.set_time(t); }
  void begin_solve(SolveKind kind) override { equations_.begin_solve(kind); }
  void iterate_taken() override { equations_.iterate_taken(); }
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs) override {
    return equations_.predictor(x, rhs);
  }
  void apply_constraints(Vector& x) override { equations_.apply_constraints(x); }
  void accept(const Vector& x) override { equations_.accept(x); }
  void reject() override { equations_.reject(); }

private:
  assembly::EquationSystem& equations_;
  std::function<void()> check_;
};

} // namespace abut::solver
