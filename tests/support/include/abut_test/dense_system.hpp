// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"

#include <vector>

namespace abut_test {

/// Slow, obvious assembly of one contribution on one rank: block row = global mesh node number.
struct DenseSystem {
  int nodes, fields;
  std::vector<double> u, residual, tangent; ///< (nodes*fields), ..., (nodes*fields)^2

  DenseSystem(int node_count, int field_count)
      : nodes(node_count), fields(field_count), u(std::size_t(node_count * field_count), 0.0) {}

  void evaluate(abut::Contribution& c, bool with_tangent, double time = 1.0) {
    const abut::NodalFields in{u.data(), fields, time};
    c.prepare(in);
    const abut::Connectivity& cells = c.connectivity();
    const std::size_t size = std::size_t(nodes) * fields;
    std::vector<abut::Local> row(cells.nodes.begin(), cells.nodes.end());
    residual.assign(size, 0.0);
    c.residual(in, {fields, cells.offsets.data(), row.data(), residual.data()});
    if (!with_tangent)
      return;
    tangent.assign(size * size, 0.0);
    std::vector<std::int64_t> offset{0}, position;
    for (abut::Local i = 0; i < cells.cells(); ++i) {
      for (abut::Local a = cells.offsets[i]; a < cells.offsets[i + 1]; ++a)
        for (abut::Local b = cells.offsets[i]; b < cells.offsets[i + 1]; ++b)
          position.push_back(std::int64_t(row[a]) * fields * std::int64_t(size) +
                             std::int64_t(row[b]) * fields);
      offset.push_back(static_cast<std::int64_t>(position.size()));
    }
    const std::vector<abut::Local> length(std::size_t(nodes), static_cast<abut::Local>(size));
    c.tangent(in, {fields, cells.offsets.data(), row.data(), offset.data(), position.data(),
                   length.data(), tangent.data()});
  }
};

} // namespace abut_test
