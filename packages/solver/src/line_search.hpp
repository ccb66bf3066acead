// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

namespace abut::solver {

/// The line search of contact problems. The full step is taken unless
/// - the residual cannot be evaluated there or is not finite: halved until it can be, or
/// - the slope s(a) = dx . f(x + a dx) has |s(1)| > 0.9 |s(0)| and another sign than s(0): a root
/// is
///   sought by regula falsi (Matthies and Strang 1979, with the Illinois weights).
/// A stiff contact that closes within the step has its root at the first touch; were that step
/// taken each time, faces would close one by one. The shortest step is therefore 0.1, and doubles
/// with every iteration in a row that the slope shortened. Where shortest and whole steps take turns,
/// stiff springs close and open: whole steps then no longer bring the floor down.
/// With multipliers among the unknowns the slope alone says little: the full step is also taken
/// where it makes the residual smaller.
class SlopeLineSearch : public NOX::LineSearch::Generic {
public:
  explicit SlopeLineSearch(bool indefinite) : indefinite_(indefinite) {}
  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

private:
  /// The slope at x + step dx; nothing where the residual cannot be evaluated (why: `failure_`).
  bool evaluate(double step, double& slope);
  double seek_root(double step, double slope_start, double slope_full);

  static constexpr double first_floor = 0.1;
  NOX::Abstract::Group* group_ = nullptr;
  const NOX::Abstract::Group* old_ = nullptr;
  const NOX::Abstract::Vector* direction_ = nullptr;
  double floor_ = first_floor;
  bool whole_ = true; ///< the last step
  int turns_ = 0;     ///< shortest steps after whole ones, since two whole ones in a row
  bool indefinite_;
  std::string failure_;
};

/// Hands a line search to NOX's parameter list.
class SlopeLineSearchFactory : public NOX::LineSearch::UserDefinedFactory {
public:
  explicit SlopeLineSearchFactory(bool indefinite) : indefinite_(indefinite) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new SlopeLineSearch(indefinite_));
  }

private:
  bool indefinite_;
};

} // namespace abut::solver
