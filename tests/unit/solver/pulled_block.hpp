// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elastic_block.hpp"

namespace abut::test {

/// A x = t b.
class PulledBlock : public ElasticBlock {
public:
  using ElasticBlock::ElasticBlock;
  void set_time(double t) override { time_ = t; }
  void residual(const Vector& x, Vector& f) override {
    matrix()->apply(x, f);
    f.update(-time_, wavy_vector(map()), 1.0);
  }
  RCP<const Matrix> predictor(const Vector& x, Vector& rhs) override {
    residual(x, rhs);
    rhs.scale(-1.0);
    return matrix();
  }

private:
  double time_ = 0.0;
};

} // namespace abut::test
