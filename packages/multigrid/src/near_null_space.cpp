// SPDX-License-Identifier: BSD-3-Clause
#include "abut/multigrid/near_null_space.hpp"

#include "abut/core/error.hpp"

#include <array>
#include <cmath>

namespace abut::multigrid {

namespace {

struct Extent {
  std::array<double, 3> centre{};
  double radius = 1.0;
};

Extent extent_of(const Comm& comm, const std::vector<RowPlace>& rows) {
  double sum[4] = {0, 0, 0, static_cast<double>(rows.size())};
  for (const RowPlace& row : rows)
    for (std::size_t d = 0; d < 3; ++d)
      sum[d] += row.point[d];
  comm.sum(sum, 4);
  Extent extent;
  if (sum[3] == 0.0)
    return extent;
  for (std::size_t d = 0; d < 3; ++d)
    extent.centre[d] = sum[d] / sum[3];
  double square = 0.0;
  for (const RowPlace& row : rows)
    for (std::size_t d = 0; d < 3; ++d)
      square += std::pow(row.point[d] - extent.centre[d], 2);
  const double radius = std::sqrt(comm.sum(square) / sum[3]);
  extent.radius = radius > 0.0 ? radius : 1.0;
  return extent;
}

/// Modes of `dimensions` displacements at arm r from the centre: translations, then rotations.
void set_motions(int dimensions, int modes, const double* r, RowKind kind, double* row) {
  const int rotations = dimensions == 3 ? 3 : dimensions == 2 ? 1 : 0;
  for (int d = 0; d < dimensions && kind != RowKind::rotation; ++d)
    row[d * modes + d] = 1.0;
  for (int m = 0; m < rotations; ++m) {
    const int axis = dimensions == 3 ? m : 2; // the plane turns about the third axis
    if (kind == RowKind::rotation) {
      row[axis % dimensions * modes + dimensions + m] = 1.0;
      continue;
    }
    const int e = (axis + 1) % 3, f = (axis + 2) % 3;
    row[e * modes + dimensions + m] = -r[f];
    row[f * modes + dimensions + m] = r[e];
  }
}

} // namespace

NearNullSpace rigid_motions(const Comm& comm, int fields, const std::vector<RowPlace>& rows) {
  ABUT_REQUIRE(fields >= 1 && fields <= 4, "multigrid takes one to four unknowns to a row");
  const int dimensions = fields == 4 ? 3 : fields;
  const Extent extent = extent_of(comm, rows);
  NearNullSpace space{fields, mode_count(fields), {}};
  const auto size = static_cast<std::size_t>(fields * space.modes);
  space.values.assign(rows.size() * size, 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double arm[3];
    for (std::size_t d = 0; d < 3; ++d)
      arm[d] = (rows[i].point[d] - extent.centre[d]) / extent.radius;
    double* modes = space.values.data() + i * size;
    set_motions(dimensions, space.modes, arm, rows[i].kind, modes);
    if (rows[i].kind == RowKind::rotation) // by one over the extent
      for (std::size_t k = 0; k < size; ++k)
        modes[k] *= rows[i].unit / extent.radius;
    if (fields == 4 && rows[i].kind == RowKind::node)
      modes[3 * space.modes + 6] = 1.0;
  }
  return space;
}

} // namespace abut::multigrid
