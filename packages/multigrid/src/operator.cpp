// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/trilinos.hpp"
#include "abut/multigrid/multigrid.hpp"

namespace abut::multigrid {

namespace {

class CycleOperator : public Operator {
public:
  CycleOperator(std::shared_ptr<const Multigrid> multigrid, RCP<const Map> map)
      : multigrid_(std::move(multigrid)), map_(std::move(map)) {}

  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }

  /// y = alpha B x + beta y, column by column.
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = y.getLocalViewHost(Tpetra::Access::ReadWrite);
    std::vector<double> b(from.extent(0)), z(from.extent(0));
    for (std::size_t c = 0; c < from.extent(1); ++c) {
      for (std::size_t i = 0; i < b.size(); ++i)
        b[i] = from(i, c);
      multigrid_->apply(b.data(), z.data());
      for (std::size_t i = 0; i < b.size(); ++i)
        to(i, c) = alpha * z[i] + (beta == 0.0 ? 0.0 : beta * to(i, c));
    }
  }

private:
  std::shared_ptr<const Multigrid> multigrid_;
  RCP<const Map> map_;
};

} // namespace

RCP<Operator> make_operator(std::shared_ptr<const Multigrid> multigrid, RCP<const Map> map) {
  return rcp(new CycleOperator(std::move(multigrid), std::move(map)));
}

} // namespace abut::multigrid
