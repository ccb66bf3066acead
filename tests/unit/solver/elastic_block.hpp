// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solver/nonlinear_system.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace abut::test {

struct BlockKind {
  bool floating = false, skew = false;
  long long first_id = 0; ///< of the unknowns; ids need not start at zero
  double skewness = 0.2;
};

/// Stiffness of a linear elastic unit cube of n^3 trilinear bricks (E = 1, nu = 0.3), its nodes
/// dealt to the ranks in slabs; z = 0 is held unless `floating`. A skew coupling of neighbours
/// makes the matrix unsymmetric.
class ElasticBlock : public solver::NonlinearSystem {
public:
  explicit ElasticBlock(int n, BlockKind kind = {}) : n_(n), kind_(kind), comm_(MPI_COMM_WORLD) {
    const Global side = n + 1, nodes = side * side * side;
    const Map node_map(nodes, 0, teuchos_comm(comm_));
    std::vector<Global> ids;
    for (std::size_t i = 0; i < local_size(node_map); ++i) {
      const Global node = node_map.getGlobalElement(static_cast<Local>(i));
      for (int d = 0; d < 3; ++d) {
        ids.push_back(kind.first_id + 3 * node + d);
        const Global place[3] = {node % side, node / side % side, node / (side * side)};
        coordinates_.push_back(double(place[d]) / n);
      }
    }
    map_ = rcp(
        new Map(3 * nodes, Teuchos::arrayViewFromVector(ids), kind.first_id, teuchos_comm(comm_)));
    assemble();
  }

  RCP<const Matrix> matrix() const { return matrix_; }
  RCP<const Map> map() const override { return map_; }
  int unknowns_per_node() const override { return 3; }
  std::vector<solver::RowPlace> row_places() const override {
    std::vector<solver::RowPlace> places(coordinates_.size() / 3);
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      places[i / 3].point[i % 3] = coordinates_[i];
    return places;
  }
  bool symmetric() const override { return !kind_.skew; }
  long graph_version() const override { return 0; }
  RCP<const Matrix> tangent(const Vector&) override { return matrix_; }
  void residual(const Vector& x, Vector& f) override { matrix_->apply(x, f); }
  double reference_force() const override { return 1.0; }
  void set_time(double) override {}
  RCP<const Matrix> predictor(const Vector&, Vector&) override { return matrix_; }
  void apply_constraints(Vector&) override {}
  void accept(const Vector&) override {}
  void reject() override {}

private:
  using Element = std::array<std::array<double, 24>, 24>;

  /// Nodes of the unit brick in the order x fastest.
  static double corner(int node, int d) { return (node >> d) & 1 ? 1.0 : -1.0; }

  Element element_stiffness() const {
    const double h = 1.0 / n_, lambda = 0.3 / (1.3 * 0.4), mu = 0.5 / 1.3;
    Element k{};
    for (int point = 0; point < 8; ++point) {
      double gradient[8][3];
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d) {
          gradient[a][d] = corner(a, d) / (4.0 * h);
          for (int e = 0; e < 3; ++e)
            if (e != d)
              gradient[a][d] *= 1.0 + corner(a, e) * corner(point, e) / std::sqrt(3.0);
        }
      const double weight = h * h * h / 8.0;
      for (int a = 0; a < 24; ++a)
        for (int b = 0; b < 24; ++b) {
          const double *p = gradient[a / 3], *q = gradient[b / 3];
          const int i = a % 3, j = b % 3;
          double value = lambda * p[i] * q[j] + mu * p[j] * q[i];
          if (i == j)
            value += mu * (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
          k[a][b] += weight * value;
        }
    }
    if (kind_.skew)
      for (int a = 0; a < 24; ++a)
        for (int b = 0; b < a; ++b)
          k[a][b] += kind_.skewness * h * h * h, k[b][a] -= kind_.skewness * h * h * h;
    return k;
  }

  void assemble() {
    const Element k = element_stiffness();
    const Global side = n_ + 1;
    matrix_ = rcp(new Matrix(map_, 81));
    const auto held = [&](Global node) { return !kind_.floating && node < side * side; };
    for (Global e = 0; e < Global(n_) * n_ * n_; ++e) {
      const Global first = e % n_ + side * (e / n_ % n_ + side * (e / (Global(n_) * n_)));
      Global node[8];
      for (int a = 0; a < 8; ++a)
        node[a] = first + (a & 1) + side * ((a >> 1 & 1) + side * (a >> 2 & 1));
      for (int a = 0; a < 24; ++a) {
        const Global row = kind_.first_id + 3 * node[a / 3] + a % 3;
        if (!map_->isNodeGlobalElement(row))
          continue;
        for (int b = 0; b < 24; ++b) {
          const Global column = kind_.first_id + 3 * node[b / 3] + b % 3;
          const bool constrained = held(node[a / 3]) || held(node[b / 3]);
          const double value = !constrained ? k[a][b] : row == column ? 1.0 / n_ : 0.0;
          if (!constrained || row == column)
            matrix_->insertGlobalValues(row, 1, &value, &column);
        }
      }
    }
    matrix_->fillComplete();
  }

  int n_;
  BlockKind kind_;
  Comm comm_;
  RCP<const Map> map_;
  RCP<Matrix> matrix_;
  std::vector<double> coordinates_;
};

/// A vector without symmetries, the same for any number of ranks.
inline Vector wavy_vector(const RCP<const Map>& map) {
  Vector v(map);
  const auto view = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i) {
    const double id = static_cast<double>(map->getGlobalElement(static_cast<Local>(i)));
    view(i, 0) = std::sin(1.0 + 0.7 * id) + 0.3;
  }
  return v;
}

} // namespace abut::test
