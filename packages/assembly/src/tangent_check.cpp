// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/tangent_check.hpp"

#include "abut/assembly/equation_system.hpp"
#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"

#include <cmath>
#include <random>

namespace abut::assembly {

namespace {

/// The same direction on any number of ranks: from the number of the unknown.
double direction(Global unknown) {
  std::mt19937_64 random(static_cast<std::uint64_t>(unknown) + 1);
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

} // namespace

/// Looks at the contributions of an EquationSystem one by one.
class TangentCheck {
public:
  explicit TangentCheck(EquationSystem& equations)
      : equations_(equations), x_(equations.dofs().map()), d_(equations.dofs().map()) {
    ABUT_REQUIRE(!equations.last_.is_null(), "nothing has been evaluated yet");
    x_.assign(*equations.last_);
    const auto view = d_.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = direction(x_.getMap()->getGlobalElement(static_cast<Local>(i)));
  }

  std::vector<TangentMismatch> run(double step) {
    equations_.tangent(x_);
    std::vector<TangentMismatch> list;
    for (std::size_t p = 0; p < equations_.contributions_.size(); ++p)
      list.push_back(compare(p, step));
    Vector unused(x_.getMap());
    equations_.residual(x_, unused); // all states are those of x again
    return list;
  }

private:
  /// K d of one contribution, owned scalar rows.
  std::vector<double> tangent_times_direction(std::size_t part) {
    Contributions& contributions = equations_.contributions_;
    const View<double>& values = equations_.tangent_.clear();
    contributions.add_tangent_of(part, equations_.fields(), equations_.bodies_, values.data());
    contributions.pattern().add_shared_values(values.data());
    return equations_.tangent_.times(d_);
  }

  /// Central differences of one contribution's residual along d, owned scalar rows.
  std::vector<double> slope_of(std::size_t part, double step) {
    Vector moved(x_.getMap());
    std::vector<double> slope;
    for (const double side : {1.0, -1.0}) {
      moved.assign(x_);
      moved.update(side * step, d_, 1.0);
      equations_.prepare(moved);
      const std::vector<double> r =
          equations_.contributions_.residual_of(part, equations_.fields(), equations_.bodies_);
      slope.resize(r.size(), 0.0);
      for (std::size_t i = 0; i < r.size(); ++i)
        slope[i] += side * r[i] / (2.0 * step);
    }
    return slope;
  }

  TangentMismatch compare(std::size_t part, double step) {
    const std::vector<double> slope = slope_of(part, step);
    equations_.tangent(x_); // pattern and state at x again
    const std::vector<double> product = tangent_times_direction(part);
    const unknowns::DofMap& dofs = equations_.dofs();
    const Comm& comm = dofs.mesh().comm;
    double sums[2] = {0.0, 0.0}, worst = 0.0;
    std::size_t row = 0;
    const auto node_rows = static_cast<std::size_t>(dofs.num_node_rows()) * dofs.fields();
    for (std::size_t i = 0; i < node_rows; ++i) {
      const double error = std::fabs(product[i] - slope[i]);
      sums[0] += error * error;
      sums[1] += slope[i] * slope[i];
      if (error > worst)
        worst = error, row = i;
    }
    comm.sum(sums, 2);
    TangentMismatch result;
    result.part = equations_.contributions_.name(part);
    result.error = sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : std::sqrt(sums[0]);
    const double largest = comm.max(worst);
    Global found[2] = {-1, -1}; // mesh node and field, on the rank that has them
    if (worst == largest && worst > 0.0) {
      const auto block = static_cast<Local>(row) / dofs.fields();
      found[0] = dofs.mesh().node_id[std::size_t(dofs.node_of_row(block))];
      found[1] = static_cast<Global>(row) % dofs.fields();
    }
    result.node = comm.max(found[0]);
    result.field = static_cast<int>(comm.max(found[1]));
    result.force = sums[1] > 0.0 ? std::sqrt(sums[1]) : 0.0;
    return result;
  }

  EquationSystem& equations_;
  Vector x_, d_;
};

std::vector<TangentMismatch> check_tangent(EquationSystem& equations, double step) {
  return TangentCheck(equations).run(step);
}

} // namespace abut::assembly
