// SPDX-License-Identifier: BSD-3-Clause
#include "convergence_test.hpp"

#include "abut/core/trilinos.hpp"
#include "abut/solver/linear_solver.hpp"
#include "abut/solver/nonlinear_system.hpp"
#include "thyra_model.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Abstract_Vector.H>
#include <NOX_Solver_LineSearchBased.H>
#include <NOX_Thyra_Vector.H>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut::solver {

namespace {

constexpr double divergence = 1e4; ///< times the larger of first residual and first reference force
constexpr int divergence_iterations = 3;
constexpr int longest_cycle = 4;
constexpr double cycle_tolerance = 1e-9; ///< relative difference of residuals that repeat
constexpr int stagnation_window = 4;
constexpr int short_steps = 6; ///< in a row, without any gain: the direction leads nowhere
constexpr double short_step = 0.5;

std::string scientific(double x) {
  std::ostringstream text;
  text.precision(2);
  text << std::scientific << x;
  return text.str();
}

double relative_size(double residual, double reference) {
  return residual == 0.0 ? 0.0 : residual / reference;
}

} // namespace

ConvergenceTest::ConvergenceTest(const NonlinearSystem& system, const LinearSolver& linear,
                                 const NewtonOptions& options, const EarlyEnd& early,
                                 const IncrementScale& scale, IterationCallback observer)
    : system_(system), linear_(linear), options_(options), early_(early), start_(scale.start),
      observer_(std::move(observer)), largest_work_(scale.work),
      linear_at_start_(linear.total_iterations()), linear_before_(linear_at_start_) {}

NOX::StatusTest::StatusType ConvergenceTest::checkStatus(const NOX::Solver::Generic& solver,
                                                         NOX::StatusTest::CheckType) {
  if (static_cast<int>(residuals_.size()) == solver.getNumIterations() + 1)
    return status_;
  record(solver);
  measure_correction(solver);
  return status_ = judge();
}

void ConvergenceTest::record(const NOX::Solver::Generic& solver) {
  IterationReport report;
  report.iteration = static_cast<int>(residuals_.size());
  report.residual = solver.getSolutionGroup().getNormF();
  // A body that moves without strain has no forces but those of rounding to compare with.
  reference_ = std::max(system_.reference_force(), system_.round_off_force() / options_.tolerance);
  if (report.iteration == 0)
    first_reference_ = reference_;
  residuals_.push_back(report.residual);
  report.relative = relative_size(report.residual, reference_);
  const auto* stepped = dynamic_cast<const NOX::Solver::LineSearchBased*>(&solver);
  if (report.iteration > 0)
    report.step_length = stepped ? stepped->getStepSize() : 1.0;
  step_lengths_.push_back(report.step_length);
  report.linear_iterations = static_cast<int>(linear_.total_iterations() - linear_before_);
  linear_before_ = linear_.total_iterations();
  if (observer_)
    observer_(report);
}

void ConvergenceTest::measure_correction(const NOX::Solver::Generic& solver) {
  if (!options_.displacement_tolerance || residuals_.size() < 2)
    return;
  const auto values = [](const NOX::Abstract::Vector& v) {
    return tpetra_vector(dynamic_cast<const NOX::Thyra::Vector&>(v).getThyraRCPVector());
  };
  const auto &old = solver.getPreviousSolutionGroup(), &now = solver.getSolutionGroup();
  const auto x = values(now.getX());
  Vector difference(*x, Teuchos::Copy);
  difference.update(-1.0, start_, 1.0);
  increment_ = difference.norm2();
  difference.update(1.0, *x, -1.0, *values(old.getX()), 0.0);
  correction_ = difference.norm2() / step_lengths_.back(); // a shortened step is not a small one
  largest_work_ = std::max(largest_work_, std::abs(difference.dot(*values(old.getF()))));
  work_left_ = std::abs(difference.dot(*values(now.getF())));
}

bool ConvergenceTest::small_correction() const {
  return options_.displacement_tolerance && residuals_.size() > 1 &&
         correction_ <= *options_.displacement_tolerance * increment_ &&
         work_left_ <= options_.energy_tolerance * largest_work_;
}

NOX::StatusTest::StatusType ConvergenceTest::judge() {
  const double residual = residuals_.back();
  if (!std::isfinite(residual)) {
    reason_ = "The residual is not a finite number.";
    return NOX::StatusTest::Failed;
  }
  const double early =
      std::min(early_.tolerance * reference_, early_.reduction * residuals_.front());
  const bool small = residual <= std::max(options_.tolerance * reference_, early);
  if ((small || small_correction()) && system_.settled())
    return NOX::StatusTest::Converged;
  if (diverges()) {
    reason_ = "Newton diverges: the residual grew from " + scientific(residuals_.front()) + " to " +
              scientific(residual) + ".";
    return NOX::StatusTest::Failed;
  }
  if (const int length = cycle_length()) {
    reason_ = length == 1 ? "Newton stagnates at a relative residual of " +
                                scientific(relative_size(residual, reference_)) + "."
                          : "Newton repeats a cycle of " + std::to_string(length) + " iterates.";
    return NOX::StatusTest::Failed;
  }
  if (no_headway()) {
    reason_ = "Newton makes no headway: " + std::to_string(short_steps) +
              " short steps, and a relative residual of " +
              scientific(relative_size(residual, reference_)) + ".";
    return NOX::StatusTest::Failed;
  }
  if (static_cast<int>(residuals_.size()) > options_.max_iterations) {
    reason_ = too_many_iterations();
    return NOX::StatusTest::Failed;
  }
  return NOX::StatusTest::Unconverged;
}

bool ConvergenceTest::diverges() const {
  const std::size_t n = residuals_.size();
  if (n <= divergence_iterations)
    return false;
  const double bound = divergence * std::max(residuals_.front(), first_reference_);
  return std::all_of(residuals_.end() - divergence_iterations, residuals_.end(),
                     [&](double r) { return r > bound; });
}

bool ConvergenceTest::no_headway() const {
  return static_cast<int>(residuals_.size()) > short_steps &&
         residuals_.back() >= residuals_.front() &&
         std::all_of(step_lengths_.end() - short_steps, step_lengths_.end(),
                     [](double s) { return s <= short_step; });
}

int ConvergenceTest::cycle_length() const {
  const int n = static_cast<int>(residuals_.size());
  for (int length = 1; length <= longest_cycle && 3 * length <= n; ++length) {
    bool repeats = true;
    for (int i = n - 1; repeats && i >= n - 2 * length; --i)
      repeats = std::abs(residuals_[i] - residuals_[i - length]) <= cycle_tolerance * residuals_[i];
    if (repeats)
      return length;
  }
  return 0;
}

std::string ConvergenceTest::too_many_iterations() const {
  std::string text = "Newton did not converge in " + std::to_string(options_.max_iterations) +
                     " iterations: relative residual " +
                     scientific(relative_size(residuals_.back(), reference_));
  if (residuals_.size() > 2 * stagnation_window) {
    const auto middle = residuals_.end() - stagnation_window;
    const double before = *std::min_element(middle - stagnation_window, middle);
    const double after = *std::min_element(middle, residuals_.end());
    if (after > 0.5 * before)
      text += ", no longer falling";
  }
  return text + ".";
}

NewtonResult ConvergenceTest::result() const {
  NewtonResult result;
  result.converged = status_ == NOX::StatusTest::Converged;
  result.iterations = static_cast<int>(residuals_.size()) - 1;
  result.residual = residuals_.back();
  result.reference = reference_;
  result.linear_iterations = linear_.total_iterations() - linear_at_start_;
  result.residual_history = residuals_;
  result.reason = reason_;
  return result;
}

std::ostream& ConvergenceTest::print(std::ostream& stream, int indent) const {
  return stream << std::string(static_cast<std::size_t>(indent), ' ') << status_ << reason_ << '\n';
}

} // namespace abut::solver
