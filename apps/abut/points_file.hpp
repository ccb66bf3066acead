// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include <string>

namespace abut::app {

/// Table of every contact point, one line for each point and written step (output.points).
class PointsFile {
public:
  /// Starts NAME.points.csv, `stem` being the path without it. Throws InputError when the file
  /// cannot be written. Collective.
  PointsFile(const Model& model, const std::string& stem);
  /// Adds the points of the last prepared configuration. Collective.
  void write(double time, long long augmentations) const;

private:
  const Model& model_;
  std::string path_;
};

} // namespace abut::app
